#include "core/noise/symmetric_state.h"

#include <algorithm>

namespace skyseal::noise {

using HashSecret = SecretBytes<crypto::kBlake2bLength>;

/// HKDF of 4.3: two or three outputs of 64 bytes.
static void hkdf(const HashSecret &chainingKey, ByteView inputKeyMaterial, HashSecret &first, HashSecret &second,
                 HashSecret *third = nullptr)
{
    static constexpr std::uint8_t kNumbers[] = {1, 2, 3};
    HashSecret tempKey;
    crypto::hmacBlake2b(tempKey.mutableView(), chainingKey.view(), {inputKeyMaterial});
    crypto::hmacBlake2b(first.mutableView(), tempKey.view(), {ByteView(kNumbers, 1)});
    crypto::hmacBlake2b(second.mutableView(), tempKey.view(), {first.view(), ByteView(kNumbers + 1, 1)});
    if (third)
        crypto::hmacBlake2b(third->mutableView(), tempKey.view(), {second.view(), ByteView(kNumbers + 2, 1)});
}

/// A hash output that is used as a cipher key is truncated to 32 bytes.
static Key32 asKey(const HashSecret &secret)
{
    return Key32(secret.view().first<32>());
}

void SymmetricState::initializeSymmetric(std::string_view protocolName)
{
    m_hash.fill(0);
    if (protocolName.size() <= m_hash.size())
        std::copy(protocolName.begin(), protocolName.end(), m_hash.begin());
    else
        m_hash = crypto::blake2b({asBytes(protocolName)});
    m_chainingKey = HashSecret(std::span<const std::uint8_t, crypto::kBlake2bLength>(m_hash));
    m_cipher = CipherState();
}

SymmetricState SymmetricState::clone() const
{
    SymmetricState copy;
    copy.m_hash = m_hash;
    copy.m_chainingKey = m_chainingKey.clone();
    copy.m_cipher = m_cipher.clone();
    return copy;
}

void SymmetricState::mixKey(ByteView inputKeyMaterial)
{
    HashSecret chainingKey;
    HashSecret key;
    hkdf(m_chainingKey, inputKeyMaterial, chainingKey, key);
    m_chainingKey = std::move(chainingKey);
    m_cipher.initializeKey(asKey(key));
}

void SymmetricState::mixHash(ByteView data)
{
    m_hash = crypto::blake2b({m_hash, data});
}

void SymmetricState::mixKeyAndHash(ByteView inputKeyMaterial)
{
    HashSecret chainingKey;
    HashSecret hash;
    HashSecret key;
    hkdf(m_chainingKey, inputKeyMaterial, chainingKey, hash, &key);
    m_chainingKey = std::move(chainingKey);
    mixHash(hash.view());
    m_cipher.initializeKey(asKey(key));
}

Result<std::size_t, NoiseError> SymmetricState::encryptAndHash(ByteView plaintext, MutableByteView out)
{
    const auto written = m_cipher.encryptWithAd(m_hash, plaintext, out);
    if (written)
        mixHash(out.first(*written));
    return written;
}

Result<std::size_t, NoiseError> SymmetricState::decryptAndHash(ByteView ciphertext, MutableByteView out)
{
    const auto read = m_cipher.decryptWithAd(m_hash, ciphertext, out);
    if (read)
        mixHash(ciphertext);
    return read;
}

std::pair<Key32, Key32> SymmetricState::split() const
{
    HashSecret first;
    HashSecret second;
    hkdf(m_chainingKey, {}, first, second);
    return {asKey(first), asKey(second)};
}

} // namespace skyseal::noise
