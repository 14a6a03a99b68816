// Cost of the engines for each frame, in CPU time of their thread, over real sockets: the agent that forwards and seals,
// against a forwarder that does nothing but recvmmsg and sendmmsg; the station that receives, opens and parses; and opening
// and parsing alone, against verifying the signature of the frame, which is the protection that stock MAVLink offers.
#include "core/mavlink/signing.h"
#include "tests/engine/agent_rig.h"
#include "tests/engine/bare_forwarder.h"
#include "tests/engine/receiver_rig.h"
#include "tests/engine/station_rig.h"

#include "core/crypto/init_crypto.h"
#include "core/experiment/bare_calls.h"
#include "core/link/steady_now.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_scanner.h"

#include <QtCore/QCoreApplication>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>

using namespace skyseal;
using namespace skyseal::test;
using crypto::SuiteId;

namespace {

/// The least that a receiver does: recvmmsg, the library's call that opens, and reading the frame.
class BareReceiver
{
public:
    explicit BareReceiver(SuiteId suite) : m_open(experiment::bareRecord(suite, experiment::RecordOperation::Open)) {}

    double receive()
    {
        CpuTimer cpu;
        m_from.send(m_to.port(), m_datagrams);
        std::size_t frames = 0;
        cpu.time([&] {
            while (const std::size_t count = m_to.receive()) {
                for (std::size_t i = 0; i < count; ++i) {
                    m_open(kMeanFrame);
                    frames += mavlink::readFrame(m_telemetry.frames()[frames], mavlink::Dialect::builtin()).has_value();
                }
            }
        });
        return frames == kFrames ? cpu.nanosecondsEach(kFrames) : 1e9;
    }

private:
    static constexpr std::size_t kMeanFrame = 40;

    BareSocket m_from, m_to;
    SampleTraffic m_telemetry{kFrames};
    Bytes m_record = Bytes(kMeanFrame + 22);
    std::vector<ByteView> m_datagrams = std::vector<ByteView>(kFrames, ByteView(m_record));
    experiment::BareCall m_open;
};

/// Opening a record of one frame and parsing it, from memory; and verifying a frame of the same length.
class OpenAndVerify
{
public:
    OpenAndVerify()
        : m_ground(m_keys, channel::Role::Station, everySuite()),
          m_air(m_keys, channel::Role::Agent, everySuite(), m_ground.port()), m_records(kFrames)
    {
        while (!m_ground.up() || !m_air.up()) {
            m_ground.pump();
            m_air.pump();
        }
        mavlink::FrameSigner signer(benchKey(), 1);
        for (const ByteView frame : m_telemetry.frames()) {
            Bytes &out = m_signed.emplace_back(mavlink::kMaxFrameLength);
            const auto read = mavlink::readFrame(frame, mavlink::Dialect::builtin());
            const mavlink::MessageInfo &info = read->info();
            const ByteView written = mavlink::writeFrame(out, 2, read->sequence(), 1, 1, read->messageId(), info.crcExtra,
                                                         info.minLength, read->payload(), mavlink::kFlagSigned);
            out.resize(written.size());
            signer.sign(out);
        }
    }

    double open()
    {
        m_ground.pump();
        m_air.pump();
        for (std::size_t i = 0; i < kFrames; ++i)
            m_records[i] = m_air.seal(m_telemetry.frames()[i]);
        const TimePoint now = steadyNow();
        std::size_t frames = 0;
        CpuTimer cpu;
        cpu.time([&] {
            for (std::size_t i = 0; i < kFrames; ++i) {
                mavlink::FrameScanner scanner(m_ground.open(now, m_records[i]), mavlink::Dialect::builtin());
                while (const auto item = scanner.next())
                    frames += item->frame.has_value();
            }
        });
        return frames == kFrames ? cpu.nanosecondsEach(kFrames) : 1e9;
    }

    double verify()
    {
        mavlink::SignatureVerifier verifier(benchKey(), 0);
        std::size_t good = 0;
        CpuTimer cpu;
        cpu.time([&] {
            for (const Bytes &bytes : m_signed) {
                const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
                good += verifier.check(*frame) == mavlink::SignatureVerdict::Good;
            }
        });
        return good == kFrames ? cpu.nanosecondsEach(kFrames) : 1e9;
    }

private:
    static Key32 benchKey()
    {
        Key32 key;
        key.mutableView()[0] = 1;
        return key;
    }

    Introduced m_keys;
    BareEnd m_ground, m_air;
    SampleTraffic m_telemetry{kFrames};
    std::vector<Bytes> m_records;
    std::vector<Bytes> m_signed;
};

struct Case
{
    std::string name;
    std::function<double()> round; ///< nanoseconds per frame
    std::vector<double> results{};

    double median()
    {
        std::nth_element(results.begin(), results.begin() + static_cast<std::ptrdiff_t>(results.size() / 2), results.end());
        return results[results.size() / 2];
    }
};

/// Rounds of all cases in turn, so that all meet the same machine; the first is what the others are divided by.
void compare(const char *title, std::vector<Case> cases, int rounds = 41)
{
    for (int i = 0; i < rounds; ++i) {
        for (Case &one : cases)
            one.results.push_back(one.round());
    }
    const double base = cases.front().median();
    std::printf("%s\n", title);
    for (Case &one : cases)
        std::printf("  %-44s %8.0f ns/frame %6.2f x\n", one.name.c_str(), one.median(), one.median() / base);
}

/// As a benchmark of its own beside the table.
void registerCase(const std::string &name, std::function<double()> round)
{
    benchmark::RegisterBenchmark(name.c_str(), [round = std::move(round)](benchmark::State &state) {
        for (auto _ : state)
            state.SetIterationTime(round() * static_cast<double>(kFrames) / 1e9);
        state.counters["per_frame"] = benchmark::Counter(
            static_cast<double>(kFrames), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    })->UseManualTime();
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    if (!crypto::initCrypto())
        return 1;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;

    BareForwarder bare;
    AgentRig chacha(SuiteId::ChaCha20Poly1305);
    AgentRig gcm(SuiteId::Aes256Gcm);
    AgentRig signedSide(SuiteId::ChaCha20Poly1305, AgentRig::VehicleSide::Signed);
    BareReceiver bareChacha(SuiteId::ChaCha20Poly1305);
    BareReceiver bareGcm(SuiteId::Aes256Gcm);
    Receiver chachaReceiver(SuiteId::ChaCha20Poly1305);
    Receiver gcmReceiver(SuiteId::Aes256Gcm);
    StationRig station(SuiteId::ChaCha20Poly1305);
    OpenAndVerify memory;
    std::printf("telemetry of %.1f bytes a frame\n", SampleTraffic(kFrames).meanLength());

    for (const std::size_t burst : {std::size_t(1), std::size_t(8), kFrames}) {
        const std::string suffix = "/" + std::to_string(burst);
        registerCase("forward/bare" + suffix, [&, burst] { return bare.forward(burst); });
        registerCase("forward/agent_chacha20-poly1305" + suffix, [&, burst] { return chacha.toGround(burst); });
        registerCase("forward/agent_aes-256-gcm" + suffix, [&, burst] { return gcm.toGround(burst); });
        registerCase("forward/agent_chacha20-poly1305_to_vehicle" + suffix, [&, burst] { return chacha.toVehicle(burst); });
    }
    registerCase("receive_open_parse/chacha20-poly1305", [&] { return chachaReceiver.receive(); });
    registerCase("receive_open_parse/aes-256-gcm", [&] { return gcmReceiver.receive(); });
    benchmark::RunSpecifiedBenchmarks();

    for (const std::size_t burst : {std::size_t(1), std::size_t(8), kFrames}) {
        const std::string title = "forwarding, " + std::to_string(burst) + " frame(s) at a time";
        compare(title.c_str(),
                {{"recvmmsg + sendmmsg, in clear", [&] { return bare.forward(burst); }},
                 {"agent to ground, ChaCha20-Poly1305", [&] { return chacha.toGround(burst); }},
                 {"agent to ground, AES-256-GCM", [&] { return gcm.toGround(burst); }},
                 {"ground to vehicle, ChaCha20-Poly1305", [&] { return chacha.toVehicle(burst); }},
                 {"the same, signed for the vehicle", [&] { return signedSide.toVehicle(burst); }},
                 {"agent to ground, signatures verified", [&] { return signedSide.toGround(burst); }}});
    }
    const std::uint64_t before = station.frames();
    const int rounds = 41;
    compare("station, one frame a record, saturated, ChaCha20-Poly1305",
            {{"recvmmsg + library's open + parse", [&] { return bareChacha.receive(); }},
             {"receive + open + parse", [&] { return chachaReceiver.receive(); }},
             {"the same in a whole station with its vehicle", [&] { return station.receive(); }}},
            rounds);
    compare("station, one frame a record, saturated, AES-256-GCM",
            {{"recvmmsg + library's open + parse", [&] { return bareGcm.receive(); }},
             {"receive + open + parse", [&] { return gcmReceiver.receive(); }}},
            rounds);
    compare("from memory, ChaCha20-Poly1305",
            {{"parse and verify a signed frame", [&] { return memory.verify(); }},
             {"open and parse a record of one frame", [&] { return memory.open(); }}});
    const std::uint64_t taken = station.frames() - before;
    if (taken != static_cast<std::uint64_t>(rounds) * kFrames) {
        std::fprintf(stderr, "the station took %llu frames only\n", static_cast<unsigned long long>(taken));
        return 1;
    }
    return 0;
}
