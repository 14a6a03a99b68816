// The cipher suites that seal records. Each one is described in its own file in suites/; the table in suite.cpp lists them.
// Everything that enumerates suites (offers, help texts, menus, charts, benchmarks, tests) derives from that table.
#pragma once

#include "core/crypto/suite_primitives.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace skyseal::crypto {

class InlineCipher;
class RecordCipher;
struct RecordKeys;

/// Number of a suite on the wire and in files; never reused. Suites that no code needs to name have no constant here.
enum class SuiteId : std::uint8_t {
    None = 0,
    ChaCha20Poly1305 = 1,
    Aes256Gcm = 2,
    Aes256Ctr = 3,
    Aes256Cbc = 4,
    ChaCha20 = 5,
    Rc4 = 6,
};

/// Order of the suites by strength, so that a user can name the weakest one that is allowed. Suites of equal strength
/// are considered equally good.
enum class SuiteStrength : std::uint8_t {
    None,           ///< not sealed
    Broken,         ///< a broken cipher with HMAC, for research
    PaddedWithHmac, ///< encrypt-then-MAC with padding and a second key for the IV: offers the most room for errors
    CipherWithHmac, ///< encrypt-then-MAC, sound by the theorem for this composition, but composed here
    Aead,           ///< a construction that was standardised and studied as a whole
};

using RecordCipherFactory = std::unique_ptr<RecordCipher> (*)(const RecordKeys &keys);
using InlineCipherFactory = std::unique_ptr<InlineCipher> (*)(const RecordKeys &keys);

/// The descriptor of a suite.
struct SuiteInfo
{
    SuiteId id = SuiteId::None;
    std::string_view name;        ///< as in options, files and reports: "chacha20-poly1305"; part of the key derivation
    std::string_view displayName; ///< as in windows: "ChaCha20-Poly1305"
    SuiteStrength strength = SuiteStrength::None;
    bool research = false;          ///< for comparison only: both ends must allow it, never chosen automatically
    bool authenticated = true;      ///< false only for None
    std::size_t blockSize = 1;      ///< bytes of a block that plaintext is padded to (always by 1..blockSize); 1: no padding
    std::uint32_t color = 0x999999; ///< 0xRRGGBB, in charts, on the map and in legends
    RecordCipherFactory makeRecord = nullptr; ///< gives null when a library lacks the cipher
    InlineCipherFactory makeInline = nullptr; ///< for frames sealed in place (inline_cipher.h); null: not offered there
    SuitePrimitives primitives = {};
    /// Known answer of the self-test (self_test_crypto.cpp) in hex: the record sealed from its fixed inputs.
    std::string_view knownRecord = {};

    /// The suite is a construction of its own rather than cipher then HMAC; its tag is never truncated.
    bool isAead() const { return authenticated && !std::holds_alternative<HmacSha256Tag>(primitives.authentication); }
    /// Bytes of ciphertext, without the tag, for `size` bytes of plaintext.
    std::size_t ciphertextSize(std::size_t size) const { return blockSize == 1 ? size : (size / blockSize + 1) * blockSize; }
    /// The longest plaintext whose ciphertext fits into `room` bytes, which must be at least `blockSize`.
    std::size_t plaintextRoom(std::size_t room) const { return blockSize == 1 ? room : room / blockSize * blockSize - 1; }
};

/// All suites: None first, then in order of preference, research suites last.
std::span<const SuiteInfo> suites();

/// The suites that seal, in order of preference, research suites last.
std::vector<SuiteId> sealedSuites();

/// The weakest of them by SuiteStrength: as a lower limit it admits all.
SuiteId weakestSealedSuite();

/// The descriptor of a suite; that of None for a number that is not in the table.
const SuiteInfo &suiteInfo(SuiteId id);

/// A suite by its number on the wire; nullopt for numbers that this build does not know.
std::optional<SuiteId> suiteFromNumber(std::uint8_t number);

/// A suite by its exact `name`; nullopt for anything else.
std::optional<SuiteId> suiteFromName(std::string_view name);

/// False if the libraries of this machine do not provide the suite (RC4 without OpenSSL's legacy provider).
bool suiteAvailable(SuiteId id);

} // namespace skyseal::crypto
