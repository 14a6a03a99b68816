// CipherState of the Noise specification (revision 34, 5.1) with ChaChaPoly: a key k and the nonce n of its next message.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/secret_bytes.h"
#include "core/noise/noise_error.h"

#include <optional>

namespace skyseal::noise {

/// Bytes by which a ciphertext is longer than its plaintext.
inline constexpr std::size_t kTagLength = 16;

/// Without a key, both directions fail with MissingKey: the specification copies the plaintext instead, but in this handshake
/// every payload and static key has a key. A call that fails leaves the nonce unchanged.
class CipherState
{
public:
    CipherState() = default;
    CipherState clone() const;

    void initializeKey(Key32 &&key);
    void setNonce(std::uint64_t nonce) { m_n = nonce; }

    /// Writes the ciphertext to the first plaintext + 16 bytes of `out`.
    Result<void, NoiseError> encryptWithAd(ByteView associatedData, ByteView plaintext, MutableByteView out);

    /// Writes the plaintext to the first ciphertext - 16 bytes of `out`, which contains no plaintext after a failure.
    Result<void, NoiseError> decryptWithAd(ByteView associatedData, ByteView ciphertext, MutableByteView out);

private:
    std::optional<Key32> m_k;
    std::uint64_t m_n = 0;
};

} // namespace skyseal::noise
