#include "core/crypto/inline_cipher.h"

#include "core/crypto/suite_factories.h"

namespace skyseal::crypto {

namespace {

struct Entry
{
    SuiteId suite;
    InlineCipherFactory make;
};

constexpr Entry kInline[] = {
    {SuiteId::Aes256Ctr, makeInlineAes256Ctr},
    {SuiteId::Aes256Cbc, makeInlineAes256Cbc},
    {SuiteId::ChaCha20, makeInlineChaCha20},
    {SuiteId::Rc4, makeInlineRc4},
};

} // namespace

bool mayBeInline(SuiteId suite)
{
    for (const Entry &entry : kInline) {
        if (entry.suite == suite)
            return true;
    }
    return false;
}

std::unique_ptr<InlineCipher> makeInlineCipher(SuiteId suite, const DirectionSecret &secret)
{
    for (const Entry &entry : kInline) {
        if (entry.suite == suite)
            return entry.make(RecordKeys::derive(secret, suite, "inline"));
    }
    return nullptr;
}

} // namespace skyseal::crypto
