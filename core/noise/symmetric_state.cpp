#include "core/noise/symmetric_state.h"

#include <algorithm>
#include <string_view>

namespace skyseal::noise {

using Done = Result<void, NoiseError>;
using HashSecret = SecretBytes<crypto::kBlake2bLength>;

/// HKDF of 4.3: two or three outputs of 64 bytes. `ck` may be the first output.
static void hkdf(const HashSecret &ck, ByteView inputKeyMaterial, HashSecret &first, HashSecret &second,
                 HashSecret *third = nullptr)
{
    static constexpr std::uint8_t kNumbers[] = {1, 2, 3};
    HashSecret tempKey;
    crypto::hmacBlake2b(tempKey.mutableView(), ck.view(), {inputKeyMaterial});
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

SymmetricState::SymmetricState()
{
    // A name no longer than a hash is not hashed, but filled up with zeros.
    static constexpr std::string_view kProtocolName("Noise_IKpsk2_25519_ChaChaPoly_BLAKE2b");
    static_assert(kProtocolName.size() <= crypto::kBlake2bLength);
    std::copy(kProtocolName.begin(), kProtocolName.end(), m_h.begin());
    m_ck = HashSecret(m_h);
}

SymmetricState SymmetricState::clone() const
{
    SymmetricState copy;
    copy.m_h = m_h;
    copy.m_ck = m_ck.clone();
    copy.m_cipher = m_cipher.clone();
    return copy;
}

void SymmetricState::mixKey(ByteView inputKeyMaterial)
{
    HashSecret tempK;
    hkdf(m_ck, inputKeyMaterial, m_ck, tempK);
    m_cipher.initializeKey(asKey(tempK));
}

void SymmetricState::mixHash(ByteView data)
{
    m_h = crypto::blake2b({m_h, data});
}

void SymmetricState::mixKeyAndHash(ByteView inputKeyMaterial)
{
    HashSecret tempH, tempK;
    hkdf(m_ck, inputKeyMaterial, m_ck, tempH, &tempK);
    mixHash(tempH.view());
    m_cipher.initializeKey(asKey(tempK));
}

Done SymmetricState::encryptAndHash(ByteView plaintext, MutableByteView out)
{
    return m_cipher.encryptWithAd(m_h, plaintext, out).map([&] { mixHash(out.first(plaintext.size() + kTagLength)); });
}

Done SymmetricState::decryptAndHash(ByteView ciphertext, MutableByteView out)
{
    return m_cipher.decryptWithAd(m_h, ciphertext, out).map([&] { mixHash(ciphertext); });
}

std::pair<Key32, Key32> SymmetricState::split() const
{
    HashSecret tempK1, tempK2;
    hkdf(m_ck, {}, tempK1, tempK2);
    return {asKey(tempK1), asKey(tempK2)};
}

} // namespace skyseal::noise
