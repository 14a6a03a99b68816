// Cost of receiving and sending one datagram through a UDP link, against the bare system calls in the same run. The
// socket is saturated: 512 datagrams wait in it, and the CPU time of draining them (filling is not timed) is divided by
// their number. The limit that the project sets itself is 1.2 times recvmmsg for the link with batches.
#include "core/link/make_link.h"
#include "core/metrics/process_usage.h"
#include "tests/support/bare_socket.h"

#include <QtCore/QCoreApplication>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <vector>

using namespace skyseal;
using test::BareSocket;

namespace {

constexpr std::size_t kBurst = 8 * BareSocket::kBatch;

/// A burst of datagrams of one size.
struct Burst
{
    explicit Burst(std::size_t size) : bytes(size), views(kBurst, ByteView(bytes)) {}
    Bytes bytes;
    std::vector<ByteView> views;
};

struct Counter : link::LinkListener
{
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock> received) override
    {
        blocks += received.size();
        for (const link::ReceivedBlock &block : received)
            benchmark::DoNotOptimize(block.bytes.data());
    }
    std::size_t blocks = 0;
};

std::unique_ptr<link::Link> open(const std::string &url, Counter &counter, bool portable)
{
    link::LinkOptions options;
    options.portableUdp = portable;
    options.receiveBufferBytes = BareSocket::kReceiveBuffer;
    auto out = link::makeLink(*link::LinkUrl::parse(url), LinkId{1}, counter, options);
    out->open();
    if (!out->localEndpoint())
        std::abort();
    return out;
}

template<typename F> void timeBurst(benchmark::State &state, F &&work)
{
    const Duration start = metrics::threadCpuTime();
    work();
    state.SetIterationTime(seconds(metrics::threadCpuTime() - start));
    // Shown as the time of one datagram, e.g. 562n.
    state.counters["per_datagram"] = benchmark::Counter(
        double(kBurst), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void receiveBare(benchmark::State &state)
{
    const Burst burst(std::size_t(state.range(0)));
    BareSocket sender;
    BareSocket receiver;
    for (auto _ : state) {
        sender.send(receiver.port(), burst.views);
        timeBurst(state, [&] {
            for (std::size_t count = 0; count < kBurst;)
                count += receiver.receive();
        });
    }
}

void receiveLink(benchmark::State &state, bool portable)
{
    const Burst burst(std::size_t(state.range(0)));
    BareSocket sender;
    Counter counter;
    const auto link = open("udpin:127.0.0.1:0", counter, portable);
    QCoreApplication::processEvents();
    for (auto _ : state) {
        counter.blocks = 0;
        sender.send(link->localEndpoint()->port, burst.views);
        timeBurst(state, [&] {
            while (counter.blocks < kBurst)
                QCoreApplication::processEvents();
        });
    }
    if (link->counters().rxKernelDrops > 0)
        state.SkipWithError("the system dropped datagrams");
}

void sendBare(benchmark::State &state)
{
    const Burst burst(std::size_t(state.range(0)));
    BareSocket sender;
    BareSocket receiver;
    for (auto _ : state) {
        timeBurst(state, [&] { sender.send(receiver.port(), burst.views); });
        while (receiver.receive() > 0) {}
    }
}

void sendLink(benchmark::State &state, bool portable)
{
    BareSocket receiver;
    Counter counter;
    const auto link = open("udpout:127.0.0.1:" + std::to_string(receiver.port()), counter, portable);
    const Bytes datagram(std::size_t(state.range(0)));
    for (auto _ : state) {
        timeBurst(state, [&] {
            for (std::size_t i = 0; i < kBurst; ++i)
                link->send({}, datagram);
            link->flush();
        });
        while (receiver.receive() > 0) {}
    }
}

} // namespace

// 60 bytes: a sealed telemetry frame; 280: the longest MAVLink frame.
BENCHMARK(receiveBare)->Name("udp_receive/recvmmsg")->Arg(60)->Arg(280)->UseManualTime();
BENCHMARK_CAPTURE(receiveLink, batch, false)->Name("udp_receive/link_batch")->Arg(60)->Arg(280)->UseManualTime();
BENCHMARK_CAPTURE(receiveLink, portable, true)->Name("udp_receive/link_portable")->Arg(60)->Arg(280)->UseManualTime();
BENCHMARK(sendBare)->Name("udp_send/sendmmsg")->Arg(60)->Arg(280)->UseManualTime();
BENCHMARK_CAPTURE(sendLink, batch, false)->Name("udp_send/link_batch")->Arg(60)->Arg(280)->UseManualTime();
BENCHMARK_CAPTURE(sendLink, portable, true)->Name("udp_send/link_portable")->Arg(60)->Arg(280)->UseManualTime();

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
