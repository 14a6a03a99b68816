// Seals and opens the records of one direction of one epoch. Keyed once; neither call allocates (hmac_sha256.h: OpenSSL).
//
// Keys: K(use) = HKDF-Expand-SHA256(direction secret, "skyseal v1 record " + suite name + " " + use, length), with the
// suite names of suite.h, without a terminator (RFC 5869). A shorter key is a prefix of the longer output. Lengths:
//
//   suite               use "key"   use "iv"     use "mac"
//   chacha20-poly1305   32          12           -
//   aes-256-gcm         32          12           -
//   aes-256-ctr         32          12           32
//   aes-256-cbc         32          32 (a key)   32
//   chacha20            32          12           32
//   rc4                 32 (HMAC)   -            32
//
// Nonce (12 bytes) = iv xor (4 zero bytes, counter as 64-bit big-endian), as in RFC 8446 5.3. The first block of
// aes-256-ctr is the nonce followed by a 32-bit big-endian block number from 0; chacha20 is RFC 8439 with block number 0.
// The IV of aes-256-cbc is AES-256(iv key, 8 zero bytes, counter as 64-bit big-endian), which is unpredictable without the
// key. The plaintext is padded to whole blocks by PKCS#7 (1..16 bytes). The RC4 key of a record is
// HMAC-SHA-256(key, counter as 64-bit little-endian), all 32 bytes; the first 768 bytes of its key stream are
// discarded. Each epoch has new direction secrets.
//
// Tag of the four cipher-then-MAC suites: the first 16 bytes of HMAC-SHA-256(mac key,
//   counter as 64-bit little-endian | length of the associated data as 32-bit little-endian | associated data | ciphertext).
// The fixed-length head makes the split between associated data and ciphertext unambiguous.
#pragma once

#include "core/base/bytes.h"
#include "core/base/locked_memory.h"
#include "core/base/secret_bytes_fwd.h"
#include "core/crypto/suite.h"

#include <memory>
#include <optional>

namespace skyseal::crypto {

/// Derived from the handshake: one for each direction of each epoch.
using DirectionSecret = Key32;

/// One suite under the keys of one direction and epoch. Not thread-safe.
class RecordCipher : public InLockedMemory
{
public:
    RecordCipher() = default;
    virtual ~RecordCipher() = default;
    RecordCipher(const RecordCipher &) = delete;
    RecordCipher &operator=(const RecordCipher &) = delete;

    virtual SuiteId suite() const = 0;
    /// Bytes of the tag that follows the ciphertext.
    virtual std::size_t tagLength() const { return 16; }
    /// Bytes of ciphertext and tag for `plaintextSize` bytes of plaintext.
    virtual std::size_t sealedSize(std::size_t plaintextSize) const { return plaintextSize + tagLength(); }
    /// The longest plaintext whose `sealedSize` is at most `room`; nullopt if not even an empty one fits.
    virtual std::optional<std::size_t> plaintextCapacity(std::size_t room) const
    {
        return room < tagLength() ? std::nullopt : std::optional(room - tagLength());
    }

    /// Writes ciphertext and tag to the start of `out`, which needs `sealedSize` bytes, and returns their length; 0 if `out` is
    /// too small or the library fails. `out` either starts at the plaintext's address or does not overlap it. A counter must
    /// never be used twice for sealing.
    virtual std::size_t seal(std::uint64_t counter, ByteView associatedData, ByteView plaintext, MutableByteView out) = 0;

    /// Decrypts in place and returns the plaintext, a part of `sealed`. nullopt on any failure; the content of `sealed` is then
    /// unspecified (unchanged or zeros), but never plaintext.
    virtual std::optional<MutableByteView> open(std::uint64_t counter, ByteView associatedData, MutableByteView sealed) = 0;
};

/// A cipher under keys derived from `secret`, which is wiped. Null for None, for a suite that is not available, and if a
/// library refuses.
std::unique_ptr<RecordCipher> makeRecordCipher(SuiteId suite, DirectionSecret &&secret);

} // namespace skyseal::crypto
