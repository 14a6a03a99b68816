#include "core/crypto/suite.h"

#include "core/crypto/suite_factories.h"

#include <algorithm>
#include <array>

namespace skyseal::crypto {

static constexpr std::array<SuiteInfo, kSuiteCount> kSuites{
    SuiteInfo{.id = SuiteId::None, .name = "none", .displayName = "None (plain MAVLink)", .authenticated = false},
    SuiteInfo{.id = SuiteId::ChaCha20Poly1305, .name = "chacha20-poly1305", .displayName = "ChaCha20-Poly1305", .aead = true},
    SuiteInfo{.id = SuiteId::Aes256Gcm, .name = "aes-256-gcm", .displayName = "AES-256-GCM", .aead = true},
    SuiteInfo{.id = SuiteId::Aes256Ctr, .name = "aes-256-ctr", .displayName = "AES-256-CTR"},
    SuiteInfo{.id = SuiteId::Aes256Cbc, .name = "aes-256-cbc", .displayName = "AES-256-CBC", .preservesLength = false},
    SuiteInfo{.id = SuiteId::ChaCha20, .name = "chacha20", .displayName = "ChaCha20"},
    SuiteInfo{.id = SuiteId::Rc4, .name = "rc4", .displayName = "RC4", .research = true},
};

static constexpr std::array<CipherFactory, kSuites.size()> kFactories{
    nullptr, makeChaCha20Poly1305, makeAes256Gcm, makeAes256Ctr, makeAes256Cbc, makeChaCha20, makeRc4,
};

std::span<const SuiteInfo> suites()
{
    return kSuites;
}

std::optional<SuiteId> suiteFromNumber(std::uint8_t number)
{
    return number < kSuites.size() ? std::optional(kSuites[number].id) : std::nullopt;
}

const SuiteInfo &suiteInfo(SuiteId id)
{
    return kSuites[suiteFromNumber(static_cast<std::uint8_t>(id)) ? static_cast<std::size_t>(id) : 0];
}

std::optional<SuiteId> suiteFromName(std::string_view name)
{
    const auto found = std::find_if(kSuites.begin(), kSuites.end(),
                                    [name](const SuiteInfo &info) { return info.name == name; });
    return found == kSuites.end() ? std::nullopt : std::optional(found->id);
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
    const CipherFactory factory = kFactories[static_cast<std::size_t>(suiteInfo(suite).id)];
    return factory ? factory(taken) : nullptr;
}

} // namespace skyseal::crypto
