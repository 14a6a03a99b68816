#include "core/noise/cipher_state.h"

#include "core/base/byte_writer.h"

#include <sodium.h>

#include <array>
#include <limits>

namespace skyseal::noise {

using Done = Result<void, NoiseError>;

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
    if (m_k)
        copy.m_k = m_k->clone();
    copy.m_n = m_n;
    return copy;
}

void CipherState::initializeKey(Key32 &&key)
{
    m_k = std::move(key);
    m_n = 0;
}

Done CipherState::encryptWithAd(ByteView associatedData, ByteView plaintext, MutableByteView out)
{
    if (out.size() < plaintext.size() + kTagLength)
        return tl::unexpected(NoiseError::NoRoom);
    if (!m_k)
        return tl::unexpected(NoiseError::MissingKey);
    if (m_n == kReservedNonce)
        return tl::unexpected(NoiseError::NonceExhausted);
    const auto nonce = nonceBytes(m_n);
    crypto_aead_chacha20poly1305_ietf_encrypt_detached(out.data(), out.data() + plaintext.size(), nullptr, plaintext.data(),
                                                       plaintext.size(), associatedData.data(), associatedData.size(), nullptr,
                                                       nonce.data(), m_k->view().data());
    ++m_n;
    return {};
}

Done CipherState::decryptWithAd(ByteView associatedData, ByteView ciphertext, MutableByteView out)
{
    if (ciphertext.size() < kTagLength)
        return tl::unexpected(NoiseError::Truncated);
    const std::size_t size = ciphertext.size() - kTagLength;
    if (out.size() < size)
        return tl::unexpected(NoiseError::NoRoom);
    if (!m_k)
        return tl::unexpected(NoiseError::MissingKey);
    if (m_n == kReservedNonce)
        return tl::unexpected(NoiseError::NonceExhausted);
    const auto nonce = nonceBytes(m_n);
    // libsodium verifies first and writes only zeros when the tag is wrong.
    if (crypto_aead_chacha20poly1305_ietf_decrypt_detached(out.data(), nullptr, ciphertext.data(), size,
                                                           ciphertext.data() + size, associatedData.data(),
                                                           associatedData.size(), nonce.data(), m_k->view().data())
        != 0)
        return tl::unexpected(NoiseError::DecryptionFailed);
    ++m_n;
    return {};
}

} // namespace skyseal::noise
