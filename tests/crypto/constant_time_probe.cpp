// Runs under Valgrind with the keys marked as undefined: memcheck then reports every branch and every address that depends on
// them. Links the test build of the cryptography, which declassifies public results (declassified.h).
//
//   constant_time_probe open SUITE | inline SUITE | compare | self-test
#include "core/base/secret_bytes.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/inline_cipher.h"
#include "core/crypto/record_cipher.h"

#include <cstdio>
#include <string_view>

#if __has_include(<valgrind/memcheck.h>)
#include <valgrind/memcheck.h>
#else
#define VALGRIND_MAKE_MEM_UNDEFINED(bytes, count) (static_cast<void>(bytes), static_cast<void>(count))
#define VALGRIND_MAKE_MEM_DEFINED(bytes, count) (static_cast<void>(bytes), static_cast<void>(count))
#endif

using namespace skyseal;
using namespace skyseal::crypto;

namespace {

Key32 poisonedKey()
{
    Key32 key;
    for (std::size_t i = 0; i < 32; ++i)
        key.mutableView()[i] = static_cast<std::uint8_t>(i * 7 + 1);
    static_cast<void>(VALGRIND_MAKE_MEM_UNDEFINED(key.mutableView().data(), 32));
    return key;
}

/// Marks data that an attacker can see as defined.
void makePublic(ByteView bytes)
{
    static_cast<void>(VALGRIND_MAKE_MEM_DEFINED(bytes.data(), bytes.size()));
}

/// Opens valid records, and records with each kind of error that an attacker can produce.
bool open(SuiteId suite)
{
    const auto writer = makeRecordCipher(suite, poisonedKey()), reader = makeRecordCipher(suite, poisonedKey());
    if (!writer || !reader)
        return false;
    const Bytes head(9, 1);
    bool right = true;
    for (const std::size_t size : {0u, 1u, 9u, 16u, 28u, 64u, 255u}) {
        const Bytes frame(size, 0xfd);
        Bytes record(size + 40);
        record.resize(writer->seal(size, head, frame, record));
        makePublic(record);
        for (const std::size_t damaged : {record.size(), record.size() - 1, std::size_t(0)}) {
            Bytes copy = record;
            if (damaged < copy.size())
                copy[damaged] ^= 1;
            right = reader->open(size, head, copy).has_value() == (damaged == record.size()) && right;
        }
    }
    return right;
}

bool openInline(SuiteId suite)
{
    const auto writer = makeInlineCipher(suite, poisonedKey()), reader = makeInlineCipher(suite, poisonedKey());
    if (!writer || !reader)
        return false;
    const Bytes head(9, 1);
    bool right = true;
    for (const std::size_t size : {1u, 9u, 16u, 28u, 255u}) {
        Bytes body(size, 0x20);
        const auto tag = writer->seal(size, head, body);
        if (!tag)
            return false;
        makePublic(body);
        makePublic(*tag);
        InlineCipher::Tag wrong = *tag;
        wrong[0] ^= 1;
        Bytes copy = body;
        right = !reader->open(size, head, copy, wrong) && reader->open(size, head, body, *tag) && right;
    }
    return right;
}

bool compare()
{
    const Key32 one = poisonedKey(), two = poisonedKey();
    const bool results[] = {one.equals(two), one.isZero()};
    makePublic(ByteView(reinterpret_cast<const std::uint8_t *>(results), sizeof results));
    return results[0] && !results[1];
}

/// A faulty example: a comparison that stops at the first difference.
bool selfTest()
{
    const Key32 one = poisonedKey(), two = poisonedKey();
    for (std::size_t i = 0; i < 32; ++i) {
        if (one.view()[i] != two.view()[i])
            return false;
    }
    return true;
}

} // namespace

int main(int argc, char **argv)
{
    const std::string_view what = argc > 1 ? argv[1] : "";
    const auto suite = suiteFromName(argc > 2 ? argv[2] : "").value_or(SuiteId::None);
    const bool done = initCrypto()
        && (what == "open"          ? open(suite)
                : what == "inline"  ? openInline(suite)
                : what == "compare" ? compare()
                                    : what == "self-test" && selfTest());
    std::puts(done ? "done" : "failed");
    return done ? 0 : 1;
}
