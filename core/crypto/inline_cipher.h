// Seals frame payloads at their length (inline framing, core/channel/PROTOCOL.md section 12). Only suites of a cipher and an
// HMAC offer it, because an HMAC may be truncated to 8 bytes. The keys differ from those of the records of the same direction
// and epoch.
//
// Keys: K(use) = HKDF-Expand-SHA256(direction secret, "skyseal v1 inline " + suite name + " " + use, length), with the uses
// and lengths of record_cipher.h, which also defines how nonces, IVs and RC4 keys are derived from the counter.
//
// aes-256-cbc keeps the length as follows. With IV = AES-256(iv key, 8 zero bytes | counter as 64-bit big-endian):
//   1..15 bytes        ciphertext = plaintext xor the first bytes of AES-256(key, IV)              (residual block termination)
//   16 bytes and more  CBC-CS1 of the addendum to NIST SP 800-38A: the last block is padded with zeros, and the last but
//                      one ciphertext block is truncated to the length of the plaintext's last block
//
// Tag: the first 8 bytes of HMAC-SHA-256(mac key, counter as 64-bit little-endian | length of the associated data as 32-bit
// little-endian | associated data | ciphertext).
#pragma once

#include "core/base/bytes.h"
#include "core/crypto/record_cipher.h"

#include <array>
#include <memory>

namespace skyseal::crypto {

/// One suite under the keys of one direction and epoch. Not thread-safe. Neither call allocates, but for OpenSSL
/// 3.0 in suites with HMAC (hmac_sha256.h).
class InlineCipher : public InLockedMemory
{
public:
    static constexpr std::size_t kTagLength = 8;
    using Tag = std::array<std::uint8_t, kTagLength>;

    InlineCipher() = default;
    virtual ~InlineCipher() = default;
    InlineCipher(const InlineCipher &) = delete;
    InlineCipher &operator=(const InlineCipher &) = delete;

    virtual SuiteId suite() const = 0;

    /// Encrypts `body` of any length (0 included) in place and returns the tag over it and the associated data. nullopt if the
    /// library fails; the content of `body` is then undefined. A counter must never be used twice for sealing.
    virtual std::optional<Tag> seal(std::uint64_t counter, ByteView associatedData, MutableByteView body) = 0;

    /// Verifies the tag, then decrypts `body` in place. Returns false on any failure; `body` is then never plaintext.
    [[nodiscard]] virtual bool open(std::uint64_t counter, ByteView associated, MutableByteView body, const Tag &tag) = 0;
};

/// True if the suite can seal in place. AEADs cannot: their tag is never truncated.
bool mayBeInline(SuiteId suite);

/// A cipher under keys derived from `secret`. Null if the suite cannot seal in place or is not available, and if a library
/// refuses.
std::unique_ptr<InlineCipher> makeInlineCipher(SuiteId suite, const DirectionSecret &secret);

} // namespace skyseal::crypto
