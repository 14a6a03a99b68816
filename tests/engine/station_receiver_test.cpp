// StationReceiver alone, without sockets, channel and threads: where the frames of a link go.
#include "core/channel/handshake_messages.h"
#include "core/engine/station/station_receiver.h"
#include "core/link/address_text.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"
#include "tests/support/idle_link.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;

namespace {

constexpr LinkId kLink{1};
constexpr Node kStation{255, 190};
constexpr TimePoint kReceivedAt{std::chrono::seconds(100)};

struct FrameLog final : Feed
{
    void takeFrame(ByteView frame) override
    {
        bytes.append(reinterpret_cast<const char *>(frame.data()), qsizetype(frame.size()));
    }
    mqtt::PublisherStatus status() const override { return {}; }

    QByteArray bytes;
};

struct Rig final : private link::LinkListener, private StationReceiver::EventHandler
{
    explicit Rig(SecureMode mode = SecureMode::Off) : settings(mode, {}, std::nullopt)
    {
        carriers.setNode(kStation);
        receiver.setFeed(&feed);
    }
    void take(const QByteArray &bytes)
    {
        Bytes block(bytes.begin(), bytes.end());
        ingress.take(idle, {from, block, now});
    }
    std::vector<std::string> texts() const
    {
        std::vector<std::string> out;
        for (const vehicle::StatusText &text : fleet.vehicles().all().at(1).state(now).texts)
            out.push_back(text.text);
        return out;
    }
    template<typename Kind> qsizetype count() const
    {
        return std::ranges::count_if(events, [](const Event &event) { return std::holds_alternative<Kind>(event); });
    }

    TimePoint now = kReceivedAt;
    IdleLink idle{"udpin:127.0.0.1:0", kLink};
    Path from{kLink, *link::parseHost("127.0.0.1", 14551)};
    CarrierWriter carriers;
    LinkPool links{*this, [](link::Link &) {}};
    Ingress ingress{mavlink::Dialect::builtin(), carriers};
    Fleet fleet{StationConfig{}};
    RouteTable routes;
    SecuritySettings settings;
    std::vector<Event> events;
    FrameLog feed;
    StationReceiver receiver{
        kStation,
        {links, ingress, fleet, routes, settings, [this](Event event) { events.push_back(std::move(event)); }, *this}};

private:
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
    void handleEvents(TimePoint, std::optional<channel::SessionId>) override {}
};

const QByteArray kHeartbeat = clearHeartbeat(1, 1, false);

} // namespace

class StationReceiverTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void vehicleInClear();
    void recording();
    void ownFrames();
    void sealedOnly();
    void recordWithoutKeys();
    void removedLink();
    void textsOfTwoLinksAreReadOnce();
    void twoModemsLoseNothing();
    void radioOfTheVehicle();
    void vehicleWithTheStationsId();
    void satelliteModemIsARoute();
    void framesCutByABridge_data();
    void framesCutByABridge();
};

namespace {

/// A modem of vehicle 1: numbers its frames by itself, and has an address of its own.
class Modem
{
public:
    Modem(Rig &rig, std::uint16_t port, std::uint8_t sequence) : m_rig(rig), m_path(rig.from), m_writer(1, 1)
    {
        m_path.remote.port = port;
        for (std::uint8_t i = 0; i < sequence; ++i)
            bytesOf(mavlink::Heartbeat{});
    }
    template<typename Message> QByteArray bytesOf(const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const ByteView frame = m_writer.write(message, buffer);
        return QByteArray(reinterpret_cast<const char *>(frame.data()), qsizetype(frame.size()));
    }
    template<typename Message> void send(const Message &message)
    {
        m_rig.from = m_path;
        m_rig.take(bytesOf(message));
    }
    const Path &path() const { return m_path; }

private:
    Rig &m_rig;
    Path m_path;
    mavlink::FrameWriter m_writer;
};

mavlink::Statustext textOf(std::string_view text, std::uint16_t id = 0, std::uint8_t chunk = 0)
{
    mavlink::Statustext out{.severity = 4, .id = id, .chunk_seq = chunk};
    mavlink::setText(out.text, text);
    return out;
}

mavlink::Heartbeat copterHeartbeat()
{
    return {.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA, .base_mode = 81};
}

} // namespace

void StationReceiverTest::vehicleInClear()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    rig.take(kHeartbeat);
    rig.take(kHeartbeat);
    QVERIFY(rig.fleet.find(1));
    QCOMPARE(rig.count<VehicleFound>(), qsizetype(1));
    const Route *route = rig.routes.leadingTo(1);
    QVERIFY(route && !route->session && route->path == rig.from);
    QCOMPARE(rig.feed.bytes, kHeartbeat + kHeartbeat);
}

/// A vehicle of a recording is shown, but nothing can be sent to it, and no client takes it for a live one.
void StationReceiverTest::recording()
{
    Rig rig;
    rig.receiver.addLink(kLink, {.isRecording = true});
    rig.take(kHeartbeat);
    QVERIFY(rig.fleet.find(1));
    QVERIFY(!rig.routes.leadingTo(1));
    QVERIFY(rig.feed.bytes.isEmpty());
}

void StationReceiverTest::ownFrames()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    rig.take(clearHeartbeat(kStation.system, kStation.component, false));
    QVERIFY(!rig.fleet.find(kStation.system));
    QVERIFY(rig.feed.bytes.isEmpty());
}

void StationReceiverTest::sealedOnly()
{
    Rig rig(SecureMode::Required);
    rig.receiver.addLink(kLink, {});
    rig.take(kHeartbeat);
    QVERIFY(!rig.fleet.find(1));
    QVERIFY(!rig.routes.leadingTo(1));
    QVERIFY(rig.feed.bytes.isEmpty());
    QCOMPARE(rig.count<VehicleFound>(), qsizetype(0));
}

void StationReceiverTest::recordWithoutKeys()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    QByteArray record(40, '\x07');
    record[0] = static_cast<char>(channel::firstByte(channel::HandshakeMessage::First));
    rig.take(record);
    QCOMPARE(rig.receiver.datagrams().waitingCount, std::uint64_t(1));
    QCOMPARE(rig.receiver.datagrams().waitingBytes, std::uint64_t(record.size()));
    QVERIFY(rig.events.empty());
}

void StationReceiverTest::removedLink()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    rig.receiver.removeLink(kLink);
    rig.take(kHeartbeat);
    QVERIFY(!rig.fleet.find(1));
}

void StationReceiverTest::textsOfTwoLinksAreReadOnce()
{
    using namespace std::chrono_literals;
    Rig rig;
    rig.receiver.addLink(kLink, {});
    Modem fast(rig, 1, 0), slow(rig, 2, 100);
    fast.send(copterHeartbeat());
    const std::string first(50, 'a');
    for (std::uint16_t id = 7; id < 10; ++id) {
        fast.send(textOf("Battery failsafe")); // repeated, as vehicles do
        fast.send(textOf(first, id, 0));
        fast.send(textOf("end", id, 1));
        rig.now += 400ms;
        slow.send(textOf("Battery failsafe"));
        slow.send(textOf(first, id, 0));
        slow.send(textOf("end", id, 1));
        rig.now += 1s;
    }
    const std::vector<std::string> once{"Battery failsafe", first + "end"};
    std::vector<std::string> all;
    for (int i = 0; i < 3; ++i)
        all.insert(all.end(), once.begin(), once.end());
    QCOMPARE(rig.texts(), all);
    // What one link loses comes over the other, which is then the first.
    slow.send(textOf("lost on the fast one"));
    rig.now += 10s;
    fast.send(textOf("lost on the fast one")); // too late for a copy: the vehicle says it again
    QCOMPARE(rig.texts().size(), all.size() + 2);
}

void StationReceiverTest::twoModemsLoseNothing()
{
    using namespace std::chrono_literals;
    Rig rig;
    rig.receiver.addLink(kLink, {});
    Modem fast(rig, 1, 0), slow(rig, 2, 100);
    int sent = 0;
    for (int i = 0; i < 500; ++i, rig.now += 20ms) {
        if (i % 50 == 0) {
            fast.send(copterHeartbeat());
            slow.send(copterHeartbeat());
            sent += 2;
        }
        fast.send(mavlink::Attitude{});
        sent += 1;
        if (i % 17 == 0) {
            slow.send(mavlink::Attitude{});
            sent += 1;
        }
    }
    const MavlinkTotals totals = rig.fleet.totals();
    QCOMPARE(totals.frames, std::uint64_t(sent));
    QCOMPARE(totals.lost + totals.late + totals.duplicate, std::uint64_t(0));
    QCOMPARE(rig.routes.all().size(), std::size_t(2)); // each gets the station's heartbeat
    QVERIFY(rig.routes.leadingTo(1)->path == fast.path());
}

/// A SiK radio inserts RADIO_STATUS as 51/68 into the stream from the vehicle.
void StationReceiverTest::radioOfTheVehicle()
{
    Rig rig;
    rig.receiver.addLink(kLink, {});
    rig.take(kHeartbeat);
    const auto status = frameOf(mavlink::RadioStatus{.rssi = 180, .remrssi = 255, .txbuf = 96, .noise = 40, .remnoise = 41}, 51,
                                68);
    rig.take(status);
    const vehicle::RadioState radio = rig.fleet.find(1)->current().radio;
    QCOMPARE(radio.signal, 180.);
    QVERIFY(std::isnan(radio.remoteSignal));
    QCOMPARE(radio.noise, 40.);
    QCOMPARE(radio.remoteNoise, 41.);
    QCOMPARE(radio.buffer, 96.);
    // That of a vehicle at another address is not its own.
    rig.from.remote.port += 1;
    rig.take(frameOf(mavlink::RadioStatus{.rssi = 7}, 51, 68));
    QCOMPARE(rig.fleet.find(1)->current().radio.signal, 180.);
    QVERIFY(!rig.fleet.find(51));
}

void StationReceiverTest::vehicleWithTheStationsId()
{
    using namespace std::chrono_literals;
    Rig rig;
    rig.receiver.addLink(kLink, {});
    for (int second = 0; second < 60; ++second, rig.now += 1s) {
        rig.take(clearHeartbeat(kStation.system, 1, false));
        rig.take(frameOf(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_GCS, .autopilot = mavlink::MAV_AUTOPILOT_INVALID},
                         kStation.system, 191)); // another station with the customary id is no conflict
    }
    QVERIFY(!rig.fleet.find(kStation.system));
    QCOMPARE(rig.count<OwnIdClaimed>(), qsizetype(1));
    const auto claim = std::ranges::find_if(rig.events, [](const Event &e) { return std::holds_alternative<OwnIdClaimed>(e); });
    QCOMPARE(std::get<OwnIdClaimed>(*claim).remoteAddress, std::string("127.0.0.1:14551"));
    rig.take(clearHeartbeat(kStation.system, 1, false));
    QCOMPARE(rig.count<OwnIdClaimed>(), qsizetype(2));
}

void StationReceiverTest::satelliteModemIsARoute()
{
    using namespace std::chrono_literals;
    Rig rig;
    rig.receiver.addLink(kLink, {});
    mavlink::HighLatency2 message;
    message.type = mavlink::MAV_TYPE_FIXED_WING;
    message.autopilot = mavlink::MAV_AUTOPILOT_PX4;
    rig.take(frameOf(message, 1, 1));
    QVERIFY(rig.fleet.find(1));
    rig.now += 67s;
    rig.routes.forgetSilent(rig.now);
    const Route *route = rig.routes.leadingTo(1);
    QVERIFY(route && route->path == rig.from && route->highLatency);
    rig.take(kHeartbeat);
    QVERIFY(!rig.routes.leadingTo(1)->highLatency);
}

void StationReceiverTest::framesCutByABridge_data()
{
    QTest::addColumn<SecureMode>("mode");
    QTest::addColumn<int>("size");
    for (const int size : {5, 16, 64, 200, 1400}) {
        QTest::addRow("plain, %d bytes", size) << SecureMode::Off << size;
        QTest::addRow("where vehicles may be sealed, %d bytes", size) << SecureMode::Preferred << size;
    }
}

/// A transparent bridge from a serial line to UDP fills datagrams of one size.
void StationReceiverTest::framesCutByABridge()
{
    QFETCH(SecureMode, mode);
    QFETCH(int, size);
    Rig rig(mode);
    rig.receiver.addLink(kLink, {});
    Modem modem(rig, 1, 0);
    QByteArray stream = modem.bytesOf(copterHeartbeat());
    for (int i = 0; i < 400; ++i)
        stream += modem.bytesOf(mavlink::GlobalPositionInt{.time_boot_ms = std::uint32_t(i) * 0x01010101u, .lat = 0x41424344});
    while (stream.size() % size)
        stream += '\0';
    for (qsizetype at = 0; at < stream.size(); at += size, rig.now += std::chrono::milliseconds(20))
        rig.take(stream.mid(at, size));
    const MavlinkTotals totals = rig.fleet.totals();
    QCOMPARE(totals.frames, std::uint64_t(401));
    QCOMPARE(totals.lost + totals.late + totals.duplicate, std::uint64_t(0));
    QCOMPARE(rig.links.badFrames(), std::uint64_t(0));
}

SKYSEAL_TEST_APPLESS(StationReceiverTest)
#include "station_receiver_test.moc"
