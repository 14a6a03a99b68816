// Cost of an endpoint relative to the bare library call: seal() and handleDatagram() of a real session, with session look-up,
// header, associated data, replay window, counters and roaming, per suite and size, in one run. Fails if an AEAD suite costs
// more than 1.15 times the bare call.
#include "core/channel/endpoint.h"
#include "pair.h"
#include "record_sizes.h"

#include "core/channel/cookie.h"
#include "core/channel/epoch_exchange.h"
#include "core/channel/epochs.h"
#include "core/channel/handshake_messages.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/experiment/bare_calls.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>

using namespace skyseal;
using namespace skyseal::bench;
using crypto::SuiteId;
using experiment::BareCall;
using experiment::bareRecord;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// As many records as a wake-up takes from a socket; they fit into the first-level cache, as the bare call's bytes do.
constexpr std::size_t kBatch = 64;
constexpr int kBatches = 800; ///< of one measurement

/// A session under a suite, and room for a batch of its records.
struct Bench
{
    Pair pair;
    SessionId session{};
    Bytes frame;
    std::vector<std::array<std::uint8_t, 320>> records{kBatch};
    std::vector<std::size_t> lengths = std::vector<std::size_t>(kBatch);
    Path from;
    std::uint64_t failures = 0;

    Bench(SuiteId suite, std::size_t size) : frame(size, 0xfd)
    {
        pair.run(2s, [&] { return pair.bothUp(); });
        pair.run(1s);
        if (suite != SuiteId::ChaCha20Poly1305) {
            pair.ground().switchSuite(pair.now, suite);
            pair.run(5s); // Until the previous epoch is gone as well.
        }
        session = pair.air().session();
        from = pair.pathOf(Air);
    }

    void sealAll()
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            const auto size = pair.air().endpoint->seal(pair.now, session, frame, records[i]);
            lengths[i] = size.value_or(0);
        }
    }
    void openAll()
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            const auto bytes = MutableByteView(records[i]).first(lengths[i]);
            failures += !pair.ground().handleDatagram(pair.now, from, bytes);
        }
    }
};

/// The shortest time of the calls that it is given, of kBatch records each: a batch is short enough to be left undisturbed now
/// and then, also on a busy machine.
class Stopwatch
{
public:
    template<typename Call> void time(Call &&call)
    {
        const auto start = std::chrono::steady_clock::now();
        call();
        m_shortest = std::min<Nanoseconds>(m_shortest, std::chrono::steady_clock::now() - start);
    }
    double nanosecondsEach() const { return m_shortest.count() / kBatch; }

private:
    using Nanoseconds = std::chrono::duration<double, std::nano>;
    Nanoseconds m_shortest = Nanoseconds::max();
};

/// The greatest cost of an endpoint's seal() or handleDatagram() relative to the bare library call, under an AEAD suite. The
/// others have no limit: the bare call hashes from copied states, which EVP_MAC has no way to do (core/BENCHMARKS.md).
constexpr double kGreatestRatio = 1.15;
/// A row is measured again this often while it is above the limit: other programs can only make a ratio worse.
constexpr int kRepetitions = 8;

/// Nanoseconds for each record.
struct Costs
{
    double bareSealed = 0, sealed = 0, bareOpened = 0, opened = 0;
    std::uint64_t failures = 0; ///< records that did not open

    double sealRatio() const { return sealed / bareSealed; }
    double openRatio() const { return opened / bareOpened; }
    bool areWithin(double limit) const { return sealRatio() <= limit && openRatio() <= limit && failures == 0; }
};

/// Bare and whole calls in turn, so that both meet the same machine; the best batch counts.
Costs measureOnce(SuiteId suite, std::size_t size)
{
    Bench bench(suite, size);
    const BareCall sealCall = bareRecord(suite, experiment::RecordOperation::Seal);
    const BareCall openCall = bareRecord(suite, experiment::RecordOperation::Open);
    const auto repeat = [size](const BareCall &call) {
        for (std::size_t i = 0; i < kBatch; ++i) {
            call(size);
            benchmark::ClobberMemory();
        }
    };
    Stopwatch bareSeals, seals, bareOpens, opens;
    for (int i = 0; i < kBatches; ++i) {
        bareSeals.time([&] { repeat(sealCall); });
        seals.time([&] { bench.sealAll(); });
        bareOpens.time([&] { repeat(openCall); });
        opens.time([&] { bench.openAll(); });
    }
    Costs out{bareSeals.nanosecondsEach(), seals.nanosecondsEach(), bareOpens.nanosecondsEach(), opens.nanosecondsEach()};
    out.failures = bench.failures;
    return out;
}

/// Returns the repetition with the least ratio of each operation.
Costs measureUntilWithin(double limit, SuiteId suite, std::size_t size)
{
    Costs best = measureOnce(suite, size);
    for (int i = 1; i < kRepetitions && best.failures == 0 && !best.areWithin(limit); ++i) {
        const Costs again = measureOnce(suite, size);
        best.failures += again.failures;
        if (again.sealRatio() < best.sealRatio()) {
            best.sealed = again.sealed;
            best.bareSealed = again.bareSealed;
        }
        if (again.openRatio() < best.openRatio()) {
            best.opened = again.opened;
            best.bareOpened = again.bareOpened;
        }
    }
    return best;
}

/// Prints the table of ratios. Returns false if one of an AEAD suite is above the limit or a record did not open.
bool ratiosAreWithin(double aeadLimit)
{
    std::printf("%-18s %5s %9s %9s %9s %9s %7s %7s\n", "suite", "bytes", "bare seal", "seal ns", "bare open", "open ns",
                "seal x", "open x");
    bool within = true;
    for (const auto &info : crypto::suites()) {
        if (info.id == SuiteId::None || !crypto::suiteAvailable(info.id))
            continue;
        const double limit = info.isAead() ? aeadLimit : std::numeric_limits<double>::infinity();
        for (const std::size_t size : kSizes) {
            const Costs costs = measureUntilWithin(limit, info.id, size);
            within = within && costs.areWithin(limit);
            std::printf("%-18s %5zu %9.1f %9.1f %9.1f %9.1f %7.2f %7.2f%s\n", std::string(info.name).c_str(), size,
                        costs.bareSealed, costs.sealed, costs.bareOpened, costs.opened, costs.sealRatio(), costs.openRatio(),
                        costs.areWithin(limit) ? "" : "  FAIL");
        }
    }
    if (!within)
        std::fprintf(stderr, "FAIL: a record did not open, or its cost is above %.2f of the bare library call\n", aeadLimit);
    return within;
}

/// The limit of this run; SKYSEAL_GREATEST_RATIO sets another one, for a processor without AES instructions.
double greatestRatio()
{
    const char *text = std::getenv("SKYSEAL_GREATEST_RATIO");
    return text ? std::atof(text) : kGreatestRatio;
}

void sealRecords(benchmark::State &state, SuiteId suite)
{
    Bench bench(suite, static_cast<std::size_t>(state.range(0)));
    while (state.KeepRunningBatch(kBatch))
        bench.sealAll();
    if (bench.lengths.back() == 0)
        state.SkipWithError("the hard limit was reached");
}

void openRecords(benchmark::State &state, SuiteId suite)
{
    Bench bench(suite, static_cast<std::size_t>(state.range(0)));
    while (state.KeepRunningBatch(kBatch)) {
        state.PauseTiming();
        bench.sealAll();
        state.ResumeTiming();
        bench.openAll();
    }
    if (bench.failures > 0)
        state.SkipWithError("a record did not open");
}

/// A datagram that a stranger made: what it costs to refuse it.
void refuseForgeries(benchmark::State &state, bool handshake)
{
    Bench bench(SuiteId::ChaCha20Poly1305, 28);
    bench.sealAll();
    Bytes forged(bench.records[0].begin(), bench.records[0].begin() + static_cast<std::ptrdiff_t>(bench.lengths[0]));
    forged[5] = 0x40;
    if (handshake) {
        forged.assign(127, 0x11);
        forged[0] = 0x59;
    }
    Endpoint &endpoint = handshake ? *bench.pair.air().endpoint : *bench.pair.ground().endpoint;
    for (auto _ : state) {
        Bytes copy = forged;
        benchmark::DoNotOptimize(endpoint.handleDatagram(bench.pair.now, bench.from, copy));
    }
}

/// First messages of a flood, by what they get right; for an agent that is under load and has given out cookies.
enum class FloodOf { WithoutMac1, WithMac1, UnderCookie };

void refuseFlood(benchmark::State &state, FloodOf what)
{
    Bench bench(SuiteId::ChaCha20Poly1305, 28);
    Endpoint &endpoint = *bench.pair.air().endpoint;
    const auto &agent = bench.pair.air().identity->publicKey;
    const TimePoint now = bench.pair.now;
    FirstMessage first{};
    first[0] = firstByte(HandshakeMessage::First);
    first[1] = 9; // So that it is no point of small order; it fails after one Diffie-Hellman.
    Mac1(agent).sign(first);
    Cookie cookie{};
    for (int i = 0; i < 40; ++i) {
        FirstMessage copy = first;
        endpoint.handleDatagram(now, bench.from, copy);
        while (const auto out = endpoint.pollTransmit()) {
            if (const auto opened = openCookie(agent, ByteView(first).last(kMacLength), out->bytes))
                cookie = *opened;
        }
    }
    if (what == FloodOf::UnderCookie) {
        signWithCookie(cookie, first);
        for (int i = 0; i < 20; ++i) { // The source's share is used up.
            FirstMessage copy = first;
            endpoint.handleDatagram(now, bench.from, copy);
        }
    } else if (what == FloodOf::WithoutMac1) {
        first[20] ^= 1;
    }
    std::uint64_t answers = 0;
    for (auto _ : state) {
        FirstMessage copy = first;
        benchmark::DoNotOptimize(endpoint.handleDatagram(now, bench.from, copy));
        while (endpoint.pollTransmit())
            ++answers;
    }
    if ((answers > 0) != (what == FloodOf::WithMac1))
        state.SkipWithError("not what was meant to be measured");
}

/// The keys of a switch at both ends: key pairs, Diffie-Hellman, chain, ciphers of both directions.
void switchEpochs(benchmark::State &state, SuiteId suite)
{
    crypto::SystemRandom random;
    const Key32 one, two;
    const Bytes hash(64, 3);
    Epochs proposer(KeyChain(one, two, hash), true, false), answerer(KeyChain(one, two, hash), false, false);
    proposer.begin(suite);
    answerer.begin(suite);
    EpochExchange exchange;
    for (auto _ : state) {
        const auto answered = EpochExchange::answer(exchange.propose(random), random);
        answerer.prepareNext(suite, *answered);
        proposer.prepareNext(suite, *exchange.finish(answered->answerer));
        exchange.drop();
        answerer.advance();
        proposer.advance();
    }
}

} // namespace

int main(int argc, char **argv)
{
    if (!crypto::initCrypto())
        return 1;
    for (const auto &info : crypto::suites()) {
        if (info.id == SuiteId::None || !crypto::suiteAvailable(info.id))
            continue;
        benchmark::RegisterBenchmark(("switch_both_ends/" + std::string(info.name)).c_str(), switchEpochs, info.id);
        for (const std::size_t size : kSizes) {
            const auto bytes = static_cast<std::int64_t>(size);
            const std::string name(info.name);
            benchmark::RegisterBenchmark(("endpoint_seal/" + name).c_str(), sealRecords, info.id)->Arg(bytes);
            benchmark::RegisterBenchmark(("endpoint_open/" + name).c_str(), openRecords, info.id)->Arg(bytes);
        }
    }
    benchmark::RegisterBenchmark("refuse_forged_record", refuseForgeries, false);
    benchmark::RegisterBenchmark("refuse_first_message_without_mac1", refuseForgeries, true);
    benchmark::RegisterBenchmark("under_load/without_mac1", refuseFlood, FloodOf::WithoutMac1);
    benchmark::RegisterBenchmark("under_load/cookie_given", refuseFlood, FloodOf::WithMac1);
    benchmark::RegisterBenchmark("under_load/share_used_up", refuseFlood, FloodOf::UnderCookie);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return ratiosAreWithin(greatestRatio()) ? 0 : 1;
}
