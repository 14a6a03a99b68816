// Cost of a frame: read with its checksum, written, signed and verified. The mix is a copter's telemetry, 37 bytes a
// frame in the mean.
#include "core/base/secret_bytes.h"
#include "core/mavlink/signing.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/stream_parser.h"

#include <benchmark/benchmark.h>

#include <random>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

/// Two thousand frames one after the other, fields filled with seeded noise so that nothing is trimmed away.
class Traffic
{
public:
    explicit Traffic(FrameSigner *signer = nullptr) : m_writer(1, 1)
    {
        m_writer.setSigner(signer);
        for (int i = 0; i < 250; ++i) {
            add<Attitude>();
            add<GlobalPositionInt>();
            add<VfrHud>();
            add<Heartbeat>();
            add<SystemTime>();
            add<SysStatus>();
            add<MissionCurrent>();
            add<Statustext>(i % 5 == 0);
        }
    }

    ByteView bytes() const { return m_bytes; }
    std::int64_t frames() const { return m_frames; }
    double meanLength() const { return static_cast<double>(m_bytes.size()) / static_cast<double>(m_frames); }

private:
    template<typename Message> void add(bool wanted = true)
    {
        if (!wanted)
            return;
        std::array<std::uint8_t, Message::kMaxLength> payload;
        for (std::uint8_t &byte : payload)
            byte = static_cast<std::uint8_t>(m_random() | 1);
        std::array<std::uint8_t, kMaxFrameLength> buffer;
        const auto frame = m_writer.write(Message::kId, Message::kCrcExtra, Message::kMinLength, payload, buffer);
        m_bytes.insert(m_bytes.end(), frame.begin(), frame.end());
        ++m_frames;
    }

    std::minstd_rand m_random{1};
    FrameWriter m_writer;
    Bytes m_bytes;
    std::int64_t m_frames = 0;
};

void report(benchmark::State &state, const Traffic &traffic)
{
    state.SetItemsProcessed(state.iterations() * traffic.frames());
    state.counters["bytes/frame"] = traffic.meanLength();
    state.counters["per frame"] = benchmark::Counter(
        static_cast<double>(traffic.frames()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void parse(benchmark::State &state)
{
    const Traffic traffic;
    for (auto _ : state) {
        FrameScanner scanner(traffic.bytes(), Dialect::builtin());
        std::uint32_t sum = 0;
        while (const auto item = scanner.next())
            sum += item->frame->messageId();
        benchmark::DoNotOptimize(sum);
    }
    report(state, traffic);
}
BENCHMARK(parse);

void parseDatagrams(benchmark::State &state)
{
    const Traffic traffic;
    std::vector<ByteView> datagrams;
    FrameScanner scanner(traffic.bytes(), Dialect::builtin());
    while (const auto item = scanner.next())
        datagrams.push_back(item->bytes);
    for (auto _ : state) {
        std::uint32_t sum = 0;
        for (const ByteView datagram : datagrams)
            sum += readFrame(datagram, Dialect::builtin())->messageId();
        benchmark::DoNotOptimize(sum);
    }
    report(state, traffic);
}
BENCHMARK(parseDatagrams);

void parseStream(benchmark::State &state)
{
    const Traffic traffic;
    for (auto _ : state) {
        StreamParser parser(Dialect::builtin());
        std::uint32_t sum = 0;
        for (ByteView rest = traffic.bytes(); !rest.empty();) {
            const ByteView piece = rest.first(std::min<std::size_t>(rest.size(), 1460));
            parser.feed(piece, [&sum](const ScanItem &item) { sum += item.frame->messageId(); });
            rest = rest.subspan(piece.size());
        }
        benchmark::DoNotOptimize(sum);
    }
    report(state, traffic);
}
BENCHMARK(parseStream);

/// The costliest datagrams of 2048 bytes, and random ones to compare with: of strangers, and as records deliver them.
void scanHostile(benchmark::State &state, std::uint8_t fill, WastedWork limit)
{
    Bytes bytes(2048, fill);
    if (fill == 0) {
        std::minstd_rand random{1};
        for (std::uint8_t &byte : bytes)
            byte = static_cast<std::uint8_t>(random() >> 8);
    }
    std::uint64_t crcBytes = 0;
    for (auto _ : state) {
        FrameScanner scanner(bytes, Dialect::builtin(), BufferEnd::Final, limit);
        while (const auto item = scanner.next())
            benchmark::DoNotOptimize(item->offset);
        crcBytes = scanner.crcBytes();
    }
    state.counters["crc bytes"] = static_cast<double>(crcBytes);
}
BENCHMARK_CAPTURE(scanHostile, random, 0, WastedWork::OfDatagram);
BENCHMARK_CAPTURE(scanHostile, all_0xFE, kMagic1, WastedWork::OfDatagram);
BENCHMARK_CAPTURE(scanHostile, all_0xFD, kMagic2, WastedWork::OfDatagram);
BENCHMARK_CAPTURE(scanHostile, sealed_random, 0, WastedWork::Unlimited);
BENCHMARK_CAPTURE(scanHostile, sealed_all_0xFE, kMagic1, WastedWork::Unlimited);

void parseAndDecodeAttitude(benchmark::State &state)
{
    FrameWriter writer(1, 1);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const ByteView bytes = writer.write(Attitude{.roll = 1, .pitch = 2, .yawspeed = 3}, buffer);
    for (auto _ : state) {
        const Attitude attitude = Attitude::decode(readFrame(bytes, Dialect::builtin())->payload());
        benchmark::DoNotOptimize(attitude.roll);
    }
}
BENCHMARK(parseAndDecodeAttitude);

template<typename Message> void encode(benchmark::State &state)
{
    FrameWriter writer(1, 1);
    Message message;
    std::array<std::uint8_t, Message::kMaxLength> noise;
    noise.fill(0x55);
    message = Message::decode(noise);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    for (auto _ : state) {
        benchmark::DoNotOptimize(message);
        benchmark::DoNotOptimize(writer.write(message, buffer).data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(encode<Heartbeat>);
BENCHMARK(encode<Attitude>);
BENCHMARK(encode<SysStatus>);

Key32 benchKey()
{
    Key32 key;
    for (std::size_t i = 0; i < key.size(); ++i)
        key.mutableView()[i] = static_cast<std::uint8_t>(7 * i + 3);
    return key;
}

void encodeSignedAttitude(benchmark::State &state)
{
    FrameSigner signer(benchKey(), 1);
    FrameWriter writer(1, 1);
    writer.setSigner(&signer);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const Attitude message{.roll = 1, .yawspeed = 2};
    for (auto _ : state) {
        benchmark::DoNotOptimize(writer.write(message, buffer).data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(encodeSignedAttitude);

void verifySigned(benchmark::State &state)
{
    FrameSigner signer(benchKey(), 1);
    const Traffic traffic(&signer);
    std::vector<Frame> frames;
    FrameScanner scanner(traffic.bytes(), Dialect::builtin());
    while (const auto item = scanner.next())
        frames.push_back(*item->frame);
    for (auto _ : state) {
        SignatureVerifier verifier(benchKey(), 0);
        for (const Frame &frame : frames)
            benchmark::DoNotOptimize(verifier.check(frame));
        if (verifier.count(SignatureVerdict::Good) != frames.size())
            state.SkipWithError("a good signature was refused");
    }
    report(state, traffic);
}
BENCHMARK(verifySigned);

} // namespace

BENCHMARK_MAIN();
