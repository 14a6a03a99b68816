// SymmetricState of the Noise specification (revision 34, 5.2) with BLAKE2b: the chaining key ck, the hash h of all messages so
// far, and the cipher derived from them.
#pragma once

#include "core/crypto/hash.h"
#include "core/noise/cipher_state.h"

#include <utility>

namespace skyseal::noise {

class SymmetricState
{
public:
    /// InitializeSymmetric("Noise_IKpsk2_25519_ChaChaPoly_BLAKE2b").
    SymmetricState();
    SymmetricState clone() const;

    void mixKey(ByteView inputKeyMaterial);
    void mixHash(ByteView data);
    void mixKeyAndHash(ByteView inputKeyMaterial);
    const crypto::Hash64 &handshakeHash() const { return m_h; }

    /// Both fail as CipherState does, and change nothing then.
    Result<void, NoiseError> encryptAndHash(ByteView plaintext, MutableByteView out);
    Result<void, NoiseError> decryptAndHash(ByteView ciphertext, MutableByteView out);

    /// The two transport keys: the initiator's sending key, then the responder's.
    std::pair<Key32, Key32> split() const;

private:
    crypto::Hash64 m_h{};
    SecretBytes<crypto::kBlake2bLength> m_ck;
    CipherState m_cipher;
};

} // namespace skyseal::noise
