// SymmetricState of the Noise specification (revision 34, 5.2) with BLAKE2b: the chaining key, the hash of all
// messages so far, and the cipher derived from them.
#pragma once

#include "core/crypto/hash.h"
#include "core/noise/cipher_state.h"

#include <string_view>
#include <utility>

namespace skyseal::noise {

class SymmetricState
{
public:
    /// `protocolName` in full, for instance "Noise_IKpsk2_25519_ChaChaPoly_BLAKE2b".
    void initializeSymmetric(std::string_view protocolName);
    SymmetricState clone() const;

    void mixKey(ByteView inputKeyMaterial);
    void mixHash(ByteView data);
    void mixKeyAndHash(ByteView inputKeyMaterial);
    const crypto::Hash64 &handshakeHash() const { return m_hash; }

    Result<std::size_t, NoiseError> encryptAndHash(ByteView plaintext, MutableByteView out);
    Result<std::size_t, NoiseError> decryptAndHash(ByteView ciphertext, MutableByteView out);

    bool hasKey() const { return m_cipher.hasKey(); }
    std::size_t overhead() const { return m_cipher.overhead(); }

    /// The two transport keys: the initiator's sending key, then the responder's.
    std::pair<Key32, Key32> split() const;

private:
    crypto::Hash64 m_hash{};
    SecretBytes<crypto::kBlake2bLength> m_chainingKey;
    CipherState m_cipher;
};

} // namespace skyseal::noise
