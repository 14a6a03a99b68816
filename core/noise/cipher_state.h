// CipherState of the Noise specification (revision 34, 5.1) with ChaChaPoly: a key and the nonce of its next message.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/secret_bytes.h"
#include "core/noise/noise_error.h"

namespace skyseal::noise {

/// Bytes by which a ciphertext is longer than its plaintext.
inline constexpr std::size_t kTagLength = 16;

class CipherState
{
public:
    CipherState() = default;
    CipherState clone() const;

    void initializeKey(Key32 &&key);
    bool hasKey() const { return m_hasKey; }
    void setNonce(std::uint64_t nonce) { m_nonce = nonce; }
    std::uint64_t nonce() const { return m_nonce; }
    /// Bytes that encryption adds: 16, or 0 without a key.
    std::size_t overhead() const { return m_hasKey ? kTagLength : 0; }

    /// Writes plaintext + `overhead()` bytes to `out` and returns their number. Without a key the plaintext is copied.
    Result<std::size_t, NoiseError> encryptWithAd(ByteView associatedData, ByteView plaintext, MutableByteView out);

    /// Writes ciphertext - `overhead()` bytes to `out` and returns their number. On failure the nonce is unchanged and `out`
    /// contains no plaintext.
    Result<std::size_t, NoiseError> decryptWithAd(ByteView associatedData, ByteView ciphertext, MutableByteView out);

private:
    Key32 m_key;
    std::uint64_t m_nonce = 0;
    bool m_hasKey = false;
};

} // namespace skyseal::noise
