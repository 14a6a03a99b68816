#include "core/crypto/mavsec_cipher.h"

#include "core/crypto/evp.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::crypto {

std::optional<MavsecCipher> MavsecCipher::make(Kind kind, const Key32 &key, ByteView nonce, std::uint32_t counter)
{
    if (nonce.size() != nonceLength(kind))
        return std::nullopt;
    MavsecCipher cipher;
    const MutableByteView stream = cipher.m_stream.mutableView();
    if (kind == Kind::ChaCha20) {
        crypto_stream_chacha20_ietf_xor_ic(stream.data(), stream.data(), stream.size(), nonce.data(), counter,
                                           key.view().data());
        return cipher;
    }
    const EvpCipher aes(EVP_CIPHER_fetch(nullptr, "AES-256-CTR", nullptr));
    const EvpContext context = makeEvpContext(aes.get(), key.view().data(), EvpDirection::Encrypt);
    int written = 0;
    const bool done = context && EVP_EncryptInit_ex2(context.get(), nullptr, nullptr, nonce.data(), nullptr) == 1
        && EVP_EncryptUpdate(context.get(), stream.data(), &written, stream.data(), static_cast<int>(stream.size())) == 1;
    return done ? std::optional(std::move(cipher)) : std::nullopt;
}

Key32 MavsecCipher::publishedKey(Kind kind)
{
    Key32 key;
    if (kind == Kind::ChaCha20) {
        for (std::size_t i = 0; i < key.size(); ++i)
            key.mutableView()[i] = static_cast<std::uint8_t>(i);
        return key;
    }
    // The AES-256 key of the examples in NIST SP 800-38A, appendix F.
    static constexpr std::array<std::uint8_t, 32> kExample{0x60, 0x3d, 0xeb, 0x10, 0x15, 0xca, 0x71, 0xbe, 0x2b, 0x73, 0xae,
                                                           0xf0, 0x85, 0x7d, 0x77, 0x81, 0x1f, 0x35, 0x2c, 0x07, 0x3b, 0x61,
                                                           0x08, 0xd7, 0x2d, 0x98, 0x10, 0xa3, 0x09, 0x14, 0xdf, 0xf4};
    std::copy(kExample.begin(), kExample.end(), key.mutableView().begin());
    return key;
}

Bytes MavsecCipher::publishedNonce(Kind kind)
{
    if (kind == Kind::ChaCha20)
        return {0, 0, 0, 0, 0, 0, 0, 0x4a, 0, 0, 0, 0};
    Bytes counter(16);
    for (std::size_t i = 0; i < counter.size(); ++i)
        counter[i] = static_cast<std::uint8_t>(0xf0 + i);
    return counter;
}

MavsecCipher MavsecCipher::clone() const
{
    MavsecCipher copy;
    copy.m_stream = m_stream.clone();
    return copy;
}

void MavsecCipher::apply(MutableByteView payload) const
{
    const std::size_t size = std::min(payload.size(), m_stream.size());
    for (std::size_t i = 0; i < size; ++i)
        payload[i] ^= m_stream.view()[i];
}

} // namespace skyseal::crypto
