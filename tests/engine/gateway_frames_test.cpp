// All frames of a vehicle through the gateway to ten clients at once, most of which must receive each of them.
#include "core/engine/station/snapshot.h"
#include "core/mavlink/frame_intake.h"
#include "tests/engine/flown_frames.h"
#include "tests/engine/served_flight.h"
#include "tests/support/bare_socket.h"
#include "tests/support/clear_frames.h"
#include "tests/support/eventually.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QTimer>
#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

#include <algorithm>

#include <netinet/tcp.h>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// Of the clients, without sleeping in between, before the test begins to wait.
constexpr int kLooks = 20'000;

/// Length and hash of the bytes of frames, the same whether they came as datagrams or in a stream.
struct ByteSum
{
    void add(ByteView bytes)
    {
        length += bytes.size();
        for (const std::uint8_t byte : bytes)
            hash = (hash ^ byte) * 0x100000001b3; // FNV-1a
    }

    std::uint64_t length = 0;
    std::uint64_t hash = 0xcbf29ce484222325;
};

/// Counts the datagrams of a socket.
struct DatagramEnd
{
    void drain()
    {
        while (const std::size_t arrived = socket.receive()) {
            for (std::size_t i = 0; i < arrived; ++i)
                note(socket.received(i));
        }
    }
    void note(ByteView datagram)
    {
        ++count;
        sum.add(datagram);
    }

    BareSocket socket;
    std::uint64_t count = 0;
    ByteSum sum;
};

/// A program that is connected by TCP.
class StreamEnd
{
public:
    enum class Room : std::uint8_t {
        Usual,
        Little ///< the system buffers little for the connection at either end
    };

    explicit StreamEnd(std::uint16_t port, Room room = Room::Usual) : m_fd(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        // The system chooses the size of the sender's buffer by that of a segment.
        const int buffer = 4096, segment = 536;
        if (room == Room::Little) {
            ::setsockopt(m_fd, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
            ::setsockopt(m_fd, IPPROTO_TCP, TCP_MAXSEG, &segment, sizeof segment);
        }
        sockaddr_in gateway{};
        gateway.sin_family = AF_INET;
        gateway.sin_port = htons(port);
        gateway.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (m_fd < 0 || ::connect(m_fd, reinterpret_cast<const sockaddr *>(&gateway), sizeof gateway) != 0)
            qFatal("no connection");
    }
    ~StreamEnd() { ::close(m_fd); }
    StreamEnd(const StreamEnd &) = delete;
    StreamEnd &operator=(const StreamEnd &) = delete;

    /// Passes on all that has arrived.
    template<typename Take> void read(Take take)
    {
        ssize_t length;
        while ((length = ::recv(m_fd, m_bytes.data(), m_bytes.size(), MSG_DONTWAIT)) > 0)
            take(ByteView(m_bytes).first(static_cast<std::size_t>(length)));
    }
    void drain()
    {
        read([this](ByteView bytes) { sum.add(bytes); });
    }

    ByteSum sum;

private:
    const int m_fd;
    std::array<std::uint8_t, 64 << 10> m_bytes{};
};

/// The links of the gateway, by their ids.
enum class ServedLink : std::size_t { Datagrams, Streams, SlowStream, Gone };

} // namespace

class GatewayFramesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyFrameReachesEveryClient();
};

/// Ten clients, one of which does not read and one of which is gone, receive a recorded flight again and again, byte for byte.
/// SKYSEAL_FRAMES of the environment is the number of frames.
void GatewayFramesTest::everyFrameReachesEveryClient()
{
    using enum ServedLink;
    const int frames = qEnvironmentVariableIsSet("SKYSEAL_FRAMES") ? qEnvironmentVariableIntValue("SKYSEAL_FRAMES") : 20'000;
    FlightRig rig;
    Ground ground(gatewayConfig(rig));
    DatagramEnd vehicle; // what it sent
    std::array<DatagramEnd, 6> datagramClients;
    QUdpSocket gone;
    QVERIFY(gone.bind(QHostAddress::LocalHost));
    const quint16 gonePort = gone.localPort();
    gone.close();
    ground.station->serve({*engine::ServeConfig::parse("udpin:0"), *engine::ServeConfig::parse("tcpin:0"),
                           *engine::ServeConfig::parse("tcpin:0"),
                           *engine::ServeConfig::parse("udpout:127.0.0.1:" + std::to_string(gonePort))});
    rig.startAgent(ground.ears->listening());
    const auto served = [&ground](ServedLink link) {
        const std::vector<engine::LinkSnapshot> &all = ground.ears->snapshot->served;
        const auto index = static_cast<std::size_t>(link);
        return index < all.size() ? all[index] : engine::LinkSnapshot();
    };
    const auto isListening = [&](ServedLink link) { return served(link).phase == engine::LinkPhase::Listening; };
    EVENTUALLY(ground.up() && isListening(Datagrams) && isListening(Streams) && isListening(SlowStream));
    const quint16 streamPort = portOf(served(Streams).localAddress);
    std::array<StreamEnd, 2> streamClients{StreamEnd(streamPort), StreamEnd(streamPort)};
    StreamEnd slow(portOf(served(SlowStream).localAddress), StreamEnd::Room::Little); // reads nothing for now
    const QByteArray hello = clearHeartbeat(255, 190, false);
    const auto greet = [&, port = portOf(served(Datagrams).localAddress)] { // a silent client is forgotten after a minute
        for (DatagramEnd &client : datagramClients)
            client.socket.send(port, std::array{viewOf(hello)});
    };
    greet();
    QTimer again;
    QObject::connect(&again, &QTimer::timeout, &again, greet);
    again.start(int(engine::Client::kForgetAfter / 6 / std::chrono::milliseconds(1))); // by time: the frames may be slow
    EVENTUALLY_EQUAL(ground.ears->snapshot->clients.size(), std::size_t(10));

    const FlownFrames flight;
    QVERIFY2(flight.kinds.size() > 20 && flight.lengths.size() > 20, flight.text().c_str());
    std::array<ByteView, 128> batch; // fits the receive buffer of every client
    while (vehicle.count < std::uint64_t(frames)) {
        for (ByteView &frame : batch) {
            frame = flight.frames[vehicle.count % flight.frames.size()];
            vehicle.note(frame);
        }
        vehicle.socket.send(portOf(rig.vehicleAddress()), batch);
        const auto arrived = [&] {
            std::ranges::for_each(datagramClients, &DatagramEnd::drain);
            std::ranges::for_each(streamClients, &StreamEnd::drain);
            const auto hasAll = [&](const auto &client) { return client.sum.length >= vehicle.sum.length; };
            return std::ranges::all_of(datagramClients, hasAll) && std::ranges::all_of(streamClients, hasAll);
        };
        // Between two looks, QtTest sleeps for 10 ms, and with it the agent, which lives on this thread.
        const auto arrivesSoon = [&arrived] {
            for (int looks = 0; looks < kLooks && !arrived(); ++looks)
                QCoreApplication::processEvents();
            return arrived();
        };
        QVERIFY2(arrivesSoon() || eventually(arrived), std::to_string(vehicle.count).c_str());
    }
    for (const DatagramEnd &client : datagramClients) {
        QCOMPARE(client.count, vehicle.count);
        QCOMPARE(client.sum.length, vehicle.sum.length);
        QCOMPARE(client.sum.hash, vehicle.sum.hash);
    }
    for (const StreamEnd &client : streamClients) {
        QCOMPARE(client.sum.length, vehicle.sum.length);
        QCOMPARE(client.sum.hash, vehicle.sum.hash);
    }
    QCOMPARE(ground.ears->snapshot->channel.rx.lost, std::uint64_t(0));

    // The slow client is still there. Each frame was either sent to it or dropped for it, and those that were sent arrive whole
    // and in order once it reads.
    EVENTUALLY_EQUAL(served(SlowStream).txDatagrams + served(SlowStream).dropped, vehicle.count);
    QVERIFY(served(SlowStream).dropped > 0);
    QCOMPARE(ground.ears->snapshot->clients.size(), std::size_t(10));
    Bytes late;
    const auto lateLength = [&] {
        slow.read([&late](ByteView bytes) { late.insert(late.end(), bytes.begin(), bytes.end()); });
        return late.size();
    };
    EVENTUALLY_EQUAL(lateLength(), std::size_t(served(SlowStream).txBytes));
    std::uint64_t wholeFrames = 0, next = 0;
    std::size_t wholeLength = 0;
    mavlink::scanFrames(late, mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
        if (!mavlink::isWholeFrame(item))
            return;
        ++wholeFrames;
        wholeLength += item.bytes.size();
        while (next < vehicle.count && !std::ranges::equal(flight.frames[next % flight.frames.size()], item.bytes))
            ++next; // this one was dropped
        ++next;
    });
    QCOMPARE(wholeLength, late.size());
    QCOMPARE(wholeFrames, served(SlowStream).txDatagrams);
    QVERIFY(next <= vehicle.count);

    // Nothing was dropped for the others, and the one that is gone disturbed nobody.
    QCOMPARE(served(Datagrams).dropped, std::uint64_t(0));
    QCOMPARE(served(Streams).dropped, std::uint64_t(0));
    QCOMPARE(int(served(Gone).phase), int(engine::LinkPhase::Connected));
    EVENTUALLY_EQUAL(served(Gone).txDatagrams, vehicle.count);
    qInfo("%llu frames to each of six clients by UDP and two by TCP: %s; %llu dropped for the slow one",
          static_cast<unsigned long long>(vehicle.count), flight.text().c_str(),
          static_cast<unsigned long long>(served(SlowStream).dropped));
}

SKYSEAL_TEST(GatewayFramesTest)
#include "gateway_frames_test.moc"
