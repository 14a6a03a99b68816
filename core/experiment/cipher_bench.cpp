#include "core/experiment/cipher_bench.h"

#include "core/base/secret_bytes.h"
#include "core/crypto/record_cipher.h"
#include "core/experiment/bare_calls.h"
#include "core/experiment/record_pair.h"
#include "core/experiment/statistics.h"

#include <algorithm>
#include <array>
#include <functional>

#include <time.h>

namespace skyseal::experiment {

namespace {

constexpr std::size_t kBatch = 64; ///< records read from a socket in one wake-up
constexpr int kBatches = 24;       ///< per timing: short enough that some rounds run undisturbed
constexpr int kRounds = 15;
constexpr std::size_t kContexts = 64, kSessions = 12; ///< number over which the memory is averaged
using Buffer = std::array<std::uint8_t, kMostBareBytes + 64>;

crypto::DirectionSecret benchSecret()
{
    crypto::DirectionSecret secret;
    secret.mutableView()[0] = 1;
    return secret;
}

/// CPU time of this thread; other load on the machine has an effect only through the caches.
double threadNanoseconds()
{
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

/// Keeps the compiler from removing calls whose output is not read.
void touchMemory()
{
    asm volatile("" : : : "memory");
}

/// A call to measure in batches, and its preparation, which is not measured.
struct Timed
{
    std::function<void()> batch;
    std::function<void()> prepare;
    std::vector<double> rounds;

    void round()
    {
        double taken = 0;
        for (int i = 0; i < kBatches; ++i) {
            if (prepare)
                prepare();
            const double begin = threadNanoseconds();
            batch();
            taken += threadNanoseconds() - begin;
        }
        rounds.push_back(taken / (kBatches * static_cast<double>(kBatch)));
    }
    CallCost cost() const
    {
        if (rounds.empty())
            return {};
        return {*std::min_element(rounds.begin(), rounds.end()), quantile(rounds, 0.5)};
    }
};

Timed timedBare(const BareCall &call, std::size_t size)
{
    Timed out;
    out.batch = [&call, size] {
        for (std::size_t i = 0; i < kBatch; ++i) {
            call(size);
            touchMemory();
        }
    };
    return out;
}

/// Ciphers, records and buffers of one suite.
struct Rig
{
    explicit Rig(crypto::SuiteId id)
        : suite(id), sealing(crypto::makeRecordCipher(id, benchSecret())), opening(crypto::makeRecordCipher(id, benchSecret())),
          pair(RecordPair::create(id))
    {}

    crypto::SuiteId suite;
    std::unique_ptr<crypto::RecordCipher> sealing, opening;
    std::unique_ptr<RecordPair> pair;
    std::array<std::uint8_t, kAssociated> associated{};
    std::vector<Buffer> records{kBatch}, copies{kBatch};
    std::array<std::size_t, kBatch> lengths{};
    Buffer plain{};
    std::uint64_t counter = 0;
    bool failed = false;

    bool ready() const { return sealing && opening && pair; }

    void sealWithSuite(std::size_t size)
    {
        for (std::size_t i = 0; i < kBatch; ++i)
            lengths[i] = sealing->seal(counter++, associated, ByteView(plain).first(size), records[i]);
    }
    void openWithSuite()
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            std::copy_n(records[i].begin(), lengths[i], copies[i].begin()); // as in the bare calls
            const auto sealed = MutableByteView(copies[i]).first(lengths[i]);
            failed = failed || !opening->open(counter - kBatch + i, associated, sealed);
        }
    }
    void sealRecords(std::size_t size)
    {
        for (std::size_t i = 0; i < kBatch; ++i)
            lengths[i] = pair->seal(ByteView(plain).first(size), records[i]);
    }
    void openRecords()
    {
        for (std::size_t i = 0; i < kBatch; ++i)
            failed = failed || !pair->open(MutableByteView(records[i]).first(lengths[i]));
    }
};

SizeCosts benchSize(Rig &rig, std::size_t size)
{
    rig.plain[0] = 0xFD; // a session carries MAVLink frames, not its own messages
    const BareCall sealCipher = bareCipher(rig.suite, RecordOperation::Seal),
                   openCipher = bareCipher(rig.suite, RecordOperation::Open);
    const BareCall sealBare = bareRecord(rig.suite, RecordOperation::Seal),
                   openBare = bareRecord(rig.suite, RecordOperation::Open);
    // Interleaved in each round, so that all are measured under the same conditions.
    std::array<Timed, 8> timed{timedBare(sealCipher, size),
                               timedBare(sealBare, size),
                               Timed{[&] { rig.sealWithSuite(size); }, {}, {}},
                               Timed{[&] { rig.sealRecords(size); }, {}, {}},
                               timedBare(openCipher, size),
                               timedBare(openBare, size),
                               Timed{[&] { rig.openWithSuite(); }, [&] { rig.sealWithSuite(size); }, {}},
                               Timed{[&] { rig.openRecords(); }, [&] { rig.sealRecords(size); }, {}}};
    for (int round = 0; round < kRounds; ++round) {
        for (Timed &each : timed)
            each.round();
    }
    SizeCosts out;
    out.size = size;
    out.seal = {timed[0].cost(), timed[1].cost(), timed[2].cost(), timed[3].cost()};
    out.open = {timed[4].cost(), timed[5].cost(), timed[6].cost(), timed[7].cost()};
    return out;
}

} // namespace

std::optional<double> contextBytes(crypto::SuiteId suite)
{
    if (!crypto::makeRecordCipher(suite, benchSecret()))
        return std::nullopt;
    std::vector<std::unique_ptr<crypto::RecordCipher>> contexts;
    contexts.reserve(2 * kContexts);
    return heapOfEach(kContexts, [&] { contexts.push_back(crypto::makeRecordCipher(suite, benchSecret())); });
}

std::optional<double> sessionBytes(crypto::SuiteId suite)
{
    if (!RecordPair::create(suite))
        return std::nullopt;
    std::vector<std::unique_ptr<RecordPair>> pairs(2 * kSessions); // made before, so that only the sessions are counted
    for (auto &pair : pairs)
        pair = std::make_unique<RecordPair>();
    auto next = pairs.begin();
    const auto ofBothEnds = heapOfEach(kSessions, [&] { (*next++)->connect(suite); });
    return ofBothEnds ? std::optional(*ofBothEnds / 2) : std::nullopt;
}

SuiteCosts benchSuite(crypto::SuiteId suite, const std::vector<std::size_t> &sizes)
{
    SuiteCosts out;
    out.suite = suite;
    out.contextBytes = contextBytes(suite);
    out.sessionBytes = sessionBytes(suite);
    Rig rig(suite);
    out.failed = !rig.ready();
    if (out.failed)
        return out;
    for (const std::size_t size : sizes)
        out.sizes.push_back(benchSize(rig, size));
    out.failed = rig.failed;
    return out;
}

} // namespace skyseal::experiment
