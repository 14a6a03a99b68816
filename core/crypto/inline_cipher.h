// Seals the payloads of frames that keep their length (inline framing, core/channel/PROTOCOL.md): the four suites of a plain
// cipher and an HMAC, whose tag may be cut to 8 bytes. Nothing that is sealed here shares a key with the records of the same
// direction and epoch.
//
// Keys: K(use) = HKDF-Expand-SHA256(direction secret, "skyseal v1 inline " + suite name + " " + use, length), with the uses
// and lengths of record_cipher.h; there as well: how nonces, IVs and the keys of RC4 come from the counter.
//
// aes-256-cbc keeps the length, too. With IV = AES-256(iv key, 8 zero bytes | counter as 64-bit big-endian):
//   1..15 bytes        ciphertext = plaintext xor the front of AES-256(key, IV)              (residual block termination)
//   16 bytes and more  CBC-CS1 of the addendum to NIST SP 800-38A: the last block is filled up with zeros, and of the last
//                      but one ciphertext block only the front travels, so much as the plaintext's last block has
//
// Tag: the first 8 bytes of HMAC-SHA-256(mac key, counter as 64-bit little-endian | length of the associated data as 32-bit
// little-endian | associated data | ciphertext).
#pragma once

#include "core/base/bytes.h"
#include "core/crypto/record_cipher.h"

#include <array>
#include <memory>

namespace skyseal::crypto {

/// One suite under the keys of one direction and epoch. Not for use by two threads at once. Neither call allocates.
class InlineCipher
{
public:
    static constexpr std::size_t kTagLength = 8;
    using Tag = std::array<std::uint8_t, kTagLength>;

    InlineCipher() = default;
    virtual ~InlineCipher() = default;
    InlineCipher(const InlineCipher &) = delete;
    InlineCipher &operator=(const InlineCipher &) = delete;

    virtual SuiteId suite() const = 0;

    /// Encrypts `body` in place, whatever its length, 0 included, and gives the tag over it and the associated data. nullopt
    /// when the library failed: then `body` is worthless. A counter must never be used twice for sealing.
    virtual std::optional<Tag> seal(std::uint64_t counter, ByteView associatedData, MutableByteView body) = 0;

    /// Decrypts `body` in place, after the tag was found right; false when anything is wrong, and `body` is never plaintext.
    [[nodiscard]] virtual bool open(std::uint64_t counter, ByteView associated, MutableByteView body, const Tag &tag) = 0;
};

/// True for the suites that may keep a frame's length: a cipher and an HMAC. The tag of an AEAD is never cut.
bool mayBeInline(SuiteId suite);

/// A cipher under keys derived from `secret`, which stays the caller's. Null for a suite that may not be inline, that is not
/// available, and when a library refuses.
std::unique_ptr<InlineCipher> makeInlineCipher(SuiteId suite, const DirectionSecret &secret);

} // namespace skyseal::crypto
