#include "core/crypto/suite.h"

#include "core/base/research.h"
#include "core/crypto/inline_cipher.h"
#include "core/crypto/record_keys.h"

#include <algorithm>

namespace skyseal::crypto {

// The descriptors, each in the file of its suite in suites/.
SuiteInfo chaCha20Poly1305Suite();
SuiteInfo aes256GcmSuite();
SuiteInfo aes256CtrSuite();
SuiteInfo aes256CbcSuite();
SuiteInfo chaCha20Suite();
SuiteInfo rc4Suite();

std::span<const SuiteInfo> suites()
{
    /// In order of preference, research suites last.
    static const std::vector<SuiteInfo> table = [] {
        std::vector<SuiteInfo> out{
            SuiteInfo{.name = "none", .displayName = "None (plain MAVLink)", .authenticated = false},
            chaCha20Poly1305Suite(),
            aes256GcmSuite(),
            aes256CtrSuite(),
            aes256CbcSuite(),
            chaCha20Suite(),
        };
        if constexpr (kResearch) {
            out.push_back(rc4Suite());
        } else {
            for (SuiteInfo &suite : out)
                suite.makeInline = nullptr; // Sealing in place is a framing for comparison.
        }
        return out;
    }();
    return table;
}

std::vector<SuiteId> sealedSuites()
{
    std::vector<SuiteId> out;
    for (const SuiteInfo &info : suites()) {
        if (info.authenticated)
            out.push_back(info.id);
    }
    return out;
}

SuiteId weakestSealedSuite()
{
    const std::vector<SuiteId> sealed = sealedSuites();
    return *std::min_element(sealed.begin(), sealed.end(),
                             [](SuiteId one, SuiteId other) { return suiteInfo(one).strength < suiteInfo(other).strength; });
}

const SuiteInfo &suiteInfo(SuiteId id)
{
    const auto table = suites();
    const auto found = std::find_if(table.begin(), table.end(), [id](const SuiteInfo &info) { return info.id == id; });
    return found == table.end() ? table.front() : *found;
}

std::optional<SuiteId> suiteFromNumber(std::uint8_t number)
{
    const SuiteId id = suiteInfo(SuiteId{number}).id;
    return static_cast<std::uint8_t>(id) == number ? std::optional(id) : std::nullopt;
}

std::optional<SuiteId> suiteFromName(std::string_view name)
{
    const auto table = suites();
    const auto found = std::find_if(table.begin(), table.end(), [name](const SuiteInfo &info) { return info.name == name; });
    return found == table.end() ? std::nullopt : std::optional(found->id);
}

bool suiteAvailable(SuiteId id)
{
    return id == SuiteId::None || makeRecordCipher(id, DirectionSecret()) != nullptr;
}

std::unique_ptr<RecordCipher> makeRecordCipher(SuiteId suite, DirectionSecret &&secret)
{
    const DirectionSecret taken = std::move(secret);
    return makeRecordCipherFromKeys(suite, RecordKeys::derive(taken, suite));
}

std::unique_ptr<RecordCipher> makeRecordCipherFromKeys(SuiteId suite, RecordKeys &&keys)
{
    const RecordKeys taken = std::move(keys);
    const RecordCipherFactory make = suiteInfo(suite).makeRecord;
    return make ? make(taken) : nullptr;
}

bool mayBeInline(SuiteId suite)
{
    return suiteInfo(suite).makeInline != nullptr;
}

std::unique_ptr<InlineCipher> makeInlineCipher(SuiteId suite, const DirectionSecret &secret)
{
    const InlineCipherFactory make = suiteInfo(suite).makeInline;
    return make ? make(RecordKeys::derive(secret, suite, "inline")) : nullptr;
}

} // namespace skyseal::crypto
