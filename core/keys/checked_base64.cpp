#include "core/keys/checked_base64.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/hash.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::keys {

static constexpr std::size_t kCheckLength = 4;
static constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;

static Key32 checkOf(std::span<const std::uint8_t, 32> bytes, std::string_view label)
{
    Key32 digest;
    crypto::blake2b(digest.mutableView(), {asBytes(label), bytes});
    return digest;
}

std::string toCheckedBase64(std::span<const std::uint8_t, 32> bytes, std::string_view label)
{
    SecretBytes<32 + kCheckLength> all;
    std::copy(bytes.begin(), bytes.end(), all.mutableView().begin());
    const Key32 check = checkOf(bytes, label);
    std::copy_n(check.view().begin(), kCheckLength, all.mutableView().begin() + 32);
    SecretBytes<kCheckedBase64Length + 1> text;
    sodium_bin2base64(reinterpret_cast<char *>(text.mutableView().data()), text.size(), all.view().data(), all.size(),
                      kVariant);
    return std::string(asText(text.view().first<kCheckedBase64Length>()));
}

std::optional<Key32> fromCheckedBase64(std::string_view text, std::string_view label)
{
    SecretBytes<32 + kCheckLength> all;
    std::size_t size = 0;
    if (text.size() != kCheckedBase64Length
        || sodium_base642bin(all.mutableView().data(), all.size(), text.data(), text.size(), nullptr, &size, nullptr, kVariant)
            != 0
        || size != all.size())
        return std::nullopt;
    Key32 bytes(all.view().first<32>());
    if (sodium_memcmp(checkOf(bytes.view(), label).view().data(), all.view().data() + 32, kCheckLength) != 0)
        return std::nullopt;
    return bytes;
}

} // namespace skyseal::keys
