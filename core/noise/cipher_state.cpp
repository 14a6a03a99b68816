#include "core/noise/cipher_state.h"

#include "core/base/byte_writer.h"
#include "core/base/weakness.h"

#include <sodium.h>

#include <array>
#include <cstring>
#include <limits>

namespace skyseal::noise {

static constexpr std::uint64_t kReservedNonce = std::numeric_limits<std::uint64_t>::max();

/// ChaChaPoly's nonce: 32 zero bits, then n as 64-bit little-endian (12.3).
static std::array<std::uint8_t, 12> nonceBytes(std::uint64_t n)
{
    std::array<std::uint8_t, 12> out{};
    ByteWriter writer(out);
    writer.u32(0);
    writer.u64(n);
    return out;
}

CipherState CipherState::clone() const
{
    CipherState copy;
    copy.m_key = m_key.clone();
    copy.m_nonce = m_nonce;
    copy.m_hasKey = m_hasKey;
    return copy;
}

void CipherState::initializeKey(Key32 &&key)
{
    m_key = std::move(key);
    m_nonce = 0;
    m_hasKey = true;
}

Result<std::size_t, NoiseError> CipherState::encryptWithAd(ByteView associatedData, ByteView plaintext, MutableByteView out)
{
    if (out.size() < plaintext.size() + overhead())
        return tl::unexpected(NoiseError::NoRoom);
    if (!m_hasKey) {
        if (!plaintext.empty())
            std::memmove(out.data(), plaintext.data(), plaintext.size());
        return plaintext.size();
    }
    if (m_nonce == kReservedNonce)
        return tl::unexpected(NoiseError::NonceExhausted);
    const auto nonce = nonceBytes(m_nonce);
    crypto_aead_chacha20poly1305_ietf_encrypt_detached(out.data(), out.data() + plaintext.size(), nullptr, plaintext.data(),
                                                       plaintext.size(), associatedData.data(), associatedData.size(), nullptr,
                                                       nonce.data(), m_key.view().data());
    ++m_nonce;
    return plaintext.size() + kTagLength;
}

Result<std::size_t, NoiseError> CipherState::decryptWithAd(ByteView associatedData, ByteView ciphertext, MutableByteView out)
{
    if (ciphertext.size() < overhead())
        return tl::unexpected(NoiseError::Truncated);
    const std::size_t size = ciphertext.size() - overhead();
    if (out.size() < size)
        return tl::unexpected(NoiseError::NoRoom);
    if (!m_hasKey) {
        if (size > 0)
            std::memmove(out.data(), ciphertext.data(), size);
        return size;
    }
    if (m_nonce == kReservedNonce)
        return tl::unexpected(NoiseError::NonceExhausted);
    const auto nonce = nonceBytes(m_nonce);
    // libsodium verifies first and writes only zeros when the tag is wrong.
    if (weakened(Weakness::NoHandshakeTag))
        crypto_stream_chacha20_ietf_xor_ic(out.data(), ciphertext.data(), size, nonce.data(), 1, m_key.view().data());
    else if (crypto_aead_chacha20poly1305_ietf_decrypt_detached(out.data(), nullptr, ciphertext.data(), size,
                                                                ciphertext.data() + size, associatedData.data(),
                                                                associatedData.size(), nonce.data(), m_key.view().data())
             != 0)
        return tl::unexpected(NoiseError::DecryptionFailed);
    ++m_nonce;
    return size;
}

} // namespace skyseal::noise
