// Cost of sealing and opening a record relative to the library calls that they consist of, per suite and size, in one run.
#include "core/base/secret_bytes.h"
#include "record_sizes.h"

#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"
#include "core/experiment/bare_calls.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using namespace skyseal;
using namespace skyseal::crypto;
using namespace skyseal::bench;
using namespace skyseal::experiment;

namespace {

DirectionSecret benchSecret()
{
    DirectionSecret secret;
    secret.mutableView()[0] = 1;
    return secret;
}

/// Nanoseconds of one call, over a stretch of time that is short enough to be left undisturbed now and then.
template<typename Call> double nanoseconds(Call &&call)
{
    constexpr int kCalls = 2000;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kCalls; ++i) {
        call(static_cast<std::uint64_t>(i));
        benchmark::ClobberMemory();
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    return taken.count() / kCalls;
}

struct OpenBench
{
    std::unique_ptr<RecordCipher> cipher;
    std::array<std::uint8_t, kAssociatedSize> associated{};
    std::vector<std::vector<std::uint8_t>> records;
    std::array<std::uint8_t, 512> work{};
    std::uint64_t failures = 0;

    OpenBench(SuiteId suite, std::size_t size) : cipher(makeRecordCipher(suite, benchSecret()))
    {
        const std::vector<std::uint8_t> plaintext(size, 7);
        for (std::uint64_t counter = 0; counter < 64; ++counter) {
            records.emplace_back(cipher->sealedSize(size));
            cipher->seal(counter, associated, plaintext, records.back());
        }
    }

    void operator()(std::uint64_t i)
    {
        const auto &record = records[i % 64];
        std::copy(record.begin(), record.end(), work.begin());
        failures += !cipher->open(i % 64, associated, MutableByteView(work).first(record.size()));
    }
};

/// The table of ratios: bare and measured calls in turn, so that both meet the same machine.
int printRatios()
{
    std::printf("%-18s %5s %9s %9s %9s %9s %9s %7s %7s\n", "suite", "bytes", "cipher ns", "bare seal", "seal ns", "bare open",
                "open ns", "seal x", "open x");
    bool ok = true;
    for (const SuiteInfo &info : suites()) {
        if (info.id == SuiteId::None || !suiteAvailable(info.id))
            continue;
        for (const std::size_t size : kSizes) {
            const BareCall cipherCall = info.isAead() ? BareCall() : bareCipher(info.id, RecordOperation::Seal);
            const BareCall sealCall = bareRecord(info.id, RecordOperation::Seal);
            const BareCall openCall = bareRecord(info.id, RecordOperation::Open);
            const auto sealing = makeRecordCipher(info.id, benchSecret());
            const std::array<std::uint8_t, kAssociatedSize> associated{};
            std::array<std::uint8_t, 512> text{};
            OpenBench opening(info.id, size);
            double cipher = 1e9, bareSealed = 1e9, sealed = 1e9, bareOpened = 1e9, opened = 1e9;
            std::uint64_t counter = 0;
            for (int round = 0; round < 15; ++round) {
                if (cipherCall)
                    cipher = std::min(cipher, nanoseconds([&](std::uint64_t) { cipherCall(size); }));
                bareSealed = std::min(bareSealed, nanoseconds([&](std::uint64_t) { sealCall(size); }));
                sealed = std::min(sealed, nanoseconds([&](std::uint64_t) {
                                      sealing->seal(counter++, associated, MutableByteView(text).first(size), text);
                                  }));
                bareOpened = std::min(bareOpened, nanoseconds([&](std::uint64_t) { openCall(size); }));
                opened = std::min(opened, nanoseconds(std::ref(opening)));
            }
            ok = ok && opening.failures == 0;
            std::printf("%-18s %5zu %9.1f %9.1f %9.1f %9.1f %9.1f %7.2f %7.2f\n", std::string(info.name).c_str(), size,
                        cipherCall ? cipher : 0.0, bareSealed, sealed, bareOpened, opened, sealed / bareSealed,
                        opened / bareOpened);
        }
    }
    return ok ? 0 : 1;
}

void seal(benchmark::State &state, SuiteId suite)
{
    const auto cipher = makeRecordCipher(suite, benchSecret());
    std::array<std::uint8_t, kAssociatedSize> associated{};
    std::array<std::uint8_t, 512> text{};
    const auto size = static_cast<std::size_t>(state.range(0));
    std::uint64_t counter = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(cipher->seal(counter++, associated, MutableByteView(text).first(size), text));
}

void open(benchmark::State &state, SuiteId suite)
{
    OpenBench bench(suite, static_cast<std::size_t>(state.range(0)));
    std::uint64_t i = 0;
    for (auto _ : state)
        bench(i++);
    if (bench.failures > 0)
        state.SkipWithError("a record did not open");
}

void bareSealing(benchmark::State &state, SuiteId suite)
{
    const BareCall call = bareRecord(suite, RecordOperation::Seal);
    for (auto _ : state) {
        call(static_cast<std::size_t>(state.range(0)));
        benchmark::ClobberMemory();
    }
}

} // namespace

int main(int argc, char **argv)
{
    if (!initCrypto())
        return 1;
    for (const SuiteInfo &info : suites()) {
        if (info.id == SuiteId::None || !suiteAvailable(info.id))
            continue;
        for (const std::size_t size : kSizes) {
            const std::string name(info.name);
            const auto bytes = static_cast<std::int64_t>(size);
            benchmark::RegisterBenchmark(("bare_seal/" + name).c_str(), bareSealing, info.id)->Arg(bytes);
            benchmark::RegisterBenchmark(("seal/" + name).c_str(), seal, info.id)->Arg(bytes);
            benchmark::RegisterBenchmark(("open/" + name).c_str(), open, info.id)->Arg(bytes);
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return printRatios();
}
