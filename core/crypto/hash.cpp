#include "core/crypto/hash.h"

#include "core/base/secret_bytes.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::crypto {

/// libsodium leaves the hash, here always a key, in stack frames below the call.
static constexpr std::size_t kHashStack = 2048;

static void hashWithKey(MutableByteView out, ByteView key, std::initializer_list<ByteView> parts)
{
    crypto_generichash_state state;
    crypto_generichash_init(&state, key.empty() ? nullptr : key.data(), key.size(), out.size());
    for (const ByteView part : parts)
        crypto_generichash_update(&state, part.data(), part.size());
    crypto_generichash_final(&state, out.data(), out.size());
    sodium_memzero(&state, sizeof state);
}

Hash64 blake2b(std::initializer_list<ByteView> parts)
{
    Hash64 out;
    hashWithKey(out, {}, parts);
    return out;
}

void blake2b(MutableByteView out, std::initializer_list<ByteView> parts)
{
    hashWithKey(out, {}, parts);
}

void keyedBlake2b(MutableByteView out, ByteView key, std::initializer_list<ByteView> parts)
{
    hashWithKey(out, key, parts);
}

void hmacBlake2b(std::span<std::uint8_t, kBlake2bLength> out, ByteView key, std::initializer_list<ByteView> parts)
{
    SecretBytes<kBlake2bBlock> pad;
    if (key.size() > kBlake2bBlock)
        hashWithKey(pad.mutableView().first<kBlake2bLength>(), {}, {key});
    else
        std::copy(key.begin(), key.end(), pad.mutableView().begin());

    const auto xorPad = [&pad](std::uint8_t value) {
        for (std::uint8_t &byte : pad.mutableView())
            byte = static_cast<std::uint8_t>(byte ^ value);
    };
    SecretBytes<kBlake2bLength> inner;
    xorPad(0x36);
    crypto_generichash_state state;
    crypto_generichash_init(&state, nullptr, 0, kBlake2bLength);
    crypto_generichash_update(&state, pad.view().data(), kBlake2bBlock);
    for (const ByteView part : parts)
        crypto_generichash_update(&state, part.data(), part.size());
    crypto_generichash_final(&state, inner.mutableView().data(), kBlake2bLength);
    sodium_memzero(&state, sizeof state);
    xorPad(0x36 ^ 0x5c);
    hashWithKey(out, {}, {pad.view(), inner.view()});
    sodium_stackzero(kHashStack);
}

} // namespace skyseal::crypto
