// What receiving and sending one datagram costs through a UDP link, against the bare system calls in the same run. The
// socket is saturated: 512 datagrams wait in it, and the CPU time of draining them (filling is not timed) is divided by
// their number. The limit that the project sets itself is 1.2 times recvmmsg for the link with batches.
#include "core/link/make_link.h"
#include "core/metrics/process_usage.h"

#include <QtCore/QCoreApplication>

#include <benchmark/benchmark.h>

#include <cstdlib>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace skyseal;

namespace {

constexpr std::size_t kBatch = 64;
constexpr std::size_t kBurst = 8 * kBatch;
constexpr int kReceiveBuffer = 4 << 20;

/// A plain socket with buffers for a batch of calls, as small as it can be.
class BareSocket
{
public:
    BareSocket() : m_fd(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0))
    {
        sockaddr_in any{};
        any.sin_family = AF_INET;
        any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (m_fd < 0 || ::bind(m_fd, reinterpret_cast<const sockaddr *>(&any), sizeof any) != 0)
            std::abort();
        ::setsockopt(m_fd, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer);
        for (std::size_t i = 0; i < kBatch; ++i) {
            m_vectors[i] = {m_bytes[i].data(), m_bytes[i].size()};
            m_headers[i] = {};
            m_headers[i].msg_hdr.msg_iov = &m_vectors[i];
            m_headers[i].msg_hdr.msg_iovlen = 1;
            m_headers[i].msg_hdr.msg_name = &m_addresses[i];
            m_headers[i].msg_hdr.msg_namelen = sizeof m_addresses[i];
        }
    }
    ~BareSocket() { ::close(m_fd); }
    BareSocket(const BareSocket &) = delete;
    BareSocket &operator=(const BareSocket &) = delete;

    std::uint16_t port() const
    {
        sockaddr_in address{};
        socklen_t length = sizeof address;
        ::getsockname(m_fd, reinterpret_cast<sockaddr *>(&address), &length);
        return ntohs(address.sin_port);
    }

    void send(std::uint16_t port, std::size_t count, std::size_t size)
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            m_vectors[i].iov_len = size;
            m_addresses[i] = {};
            m_addresses[i].sin_family = AF_INET;
            m_addresses[i].sin_port = htons(port);
            m_addresses[i].sin_addr.s_addr = htonl(INADDR_LOOPBACK);
            m_headers[i].msg_hdr.msg_namelen = sizeof m_addresses[i];
        }
        while (count > 0) {
            const int sent = ::sendmmsg(m_fd, m_headers.data(), unsigned(std::min(count, kBatch)), 0);
            if (sent <= 0)
                std::abort();
            count -= std::size_t(sent);
        }
    }

    std::size_t receive()
    {
        for (std::size_t i = 0; i < kBatch; ++i) {
            m_vectors[i].iov_len = m_bytes[i].size();
            m_headers[i].msg_hdr.msg_namelen = sizeof m_addresses[i];
        }
        const int count = ::recvmmsg(m_fd, m_headers.data(), kBatch, MSG_DONTWAIT, nullptr);
        return count > 0 ? std::size_t(count) : 0;
    }

private:
    int m_fd;
    std::array<mmsghdr, kBatch> m_headers;
    std::array<iovec, kBatch> m_vectors;
    std::array<sockaddr_in, kBatch> m_addresses;
    std::array<std::array<std::uint8_t, 2048>, kBatch> m_bytes{};
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
    options.receiveBufferBytes = kReceiveBuffer;
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
    BareSocket sender;
    BareSocket receiver;
    for (auto _ : state) {
        sender.send(receiver.port(), kBurst, std::size_t(state.range(0)));
        timeBurst(state, [&] {
            for (std::size_t count = 0; count < kBurst;)
                count += receiver.receive();
        });
    }
}

void receiveLink(benchmark::State &state, bool portable)
{
    BareSocket sender;
    Counter counter;
    const auto link = open("udpin:127.0.0.1:0", counter, portable);
    QCoreApplication::processEvents();
    for (auto _ : state) {
        counter.blocks = 0;
        sender.send(link->localEndpoint()->port, kBurst, std::size_t(state.range(0)));
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
    BareSocket sender;
    BareSocket receiver;
    for (auto _ : state) {
        timeBurst(state, [&] { sender.send(receiver.port(), kBurst, std::size_t(state.range(0))); });
        while (receiver.receive() > 0) {
        }
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
        while (receiver.receive() > 0) {
        }
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
