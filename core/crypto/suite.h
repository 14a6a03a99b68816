// The cipher suites that a record can be sealed with: their numbers on the wire, their names, and what may be said of
// each. The table in suite.cpp is the only place that lists them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace skyseal::crypto {

/// Number of a suite on the wire and in files; never reused.
enum class SuiteId : std::uint8_t {
    None = 0,
    ChaCha20Poly1305 = 1,
    Aes256Gcm = 2,
    Aes256Ctr = 3,
    Aes256Cbc = 4,
    ChaCha20 = 5,
    Rc4 = 6,
};

/// Rows of the table, None included. The numbers are consecutive.
inline constexpr std::size_t kSuiteCount = 7;

struct SuiteInfo
{
    SuiteId id = SuiteId::None;
    std::string_view name;        ///< as in options, files and reports: "chacha20-poly1305"
    std::string_view displayName; ///< as people write it: "ChaCha20-Poly1305"
    bool research = false;        ///< broken cipher, for comparison only: both ends must allow it, never chosen automatically
    bool authenticated = true;    ///< false only for None
    bool preservesLength = true;  ///< ciphertext is as long as the plaintext (the tag not counted); false for CBC, which pads
    bool aead = false;            ///< a construction of its own rather than cipher then HMAC; its tag is never truncated
};

/// All suites in the order of their numbers, None first.
std::span<const SuiteInfo> suites();

/// The entry of a suite; that of None for a number that is not in the table.
const SuiteInfo &suiteInfo(SuiteId id);

/// A suite by its number on the wire; nullopt for numbers that this build does not know.
std::optional<SuiteId> suiteFromNumber(std::uint8_t number);

/// A suite by its `name`, exactly; nullopt for anything else.
std::optional<SuiteId> suiteFromName(std::string_view name);

/// False when the libraries of this machine do not provide it (RC4 where OpenSSL's legacy provider is missing).
bool suiteAvailable(SuiteId id);

} // namespace skyseal::crypto
