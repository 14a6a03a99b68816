// What the subscribers of a broker receive of a station: states of the vehicles, events of each, frames.
#include "core/engine/headless/fleet_feed.h"

#include "core/engine/headless/event_json.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mqtt/topics.h"
#include "core/vehicle/state_fields.h"
#include "tests/support/json_values.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonObject>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using test::parsed;

namespace {

using Puts = std::vector<std::pair<std::string, std::string>>; ///< topics and payloads

struct Recorded
{
    Puts states, events;
    std::map<std::uint8_t, Bytes> frames;
};

class RecordingSink final : public mqtt::MessageSink
{
public:
    explicit RecordingSink(Recorded &out) : m_out(out) {}
    void putState(std::string topic, std::string payload) override { m_out.states.emplace_back(topic, payload); }
    void putEvent(std::string topic, std::string payload) override { m_out.events.emplace_back(topic, payload); }
    void putRaw(std::uint8_t systemId, ByteView frame) override
    {
        m_out.frames[systemId].insert(m_out.frames[systemId].end(), frame.begin(), frame.end());
    }
    mqtt::PublisherStatus status() const override { return {.connected = true}; }

private:
    Recorded &m_out;
};

/// Vehicles 7 and 8 behind session 1, vehicle 9 behind session 2.
Snapshot fleet(double time)
{
    Snapshot out;
    out.time = time;
    for (const std::uint32_t id : {1u, 2u}) {
        SessionSnapshot &session = out.sessions.emplace_back();
        session.info.session = channel::SessionId(id);
        session.info.peerName = "air-" + std::to_string(id);
        session.info.suite = crypto::suiteFromName("aes-256-gcm").value();
    }
    for (const std::uint8_t systemId : {7, 8, 9}) {
        VehicleSnapshot &vehicle = out.vehicles.emplace_back();
        vehicle.state.systemId = systemId;
        vehicle.session = channel::SessionId(systemId == 9 ? 2 : 1);
    }
    out.vehicles[0].state.altitudeRelative = 12.5;
    return out;
}

struct Rig
{
    Recorded received;
    FleetFeed feed;

    explicit Rig(bool raw = false) : feed(std::make_unique<RecordingSink>(received), raw) {}
    QStringList topicsOf(const Event &event)
    {
        received.events.clear();
        feed.handleEvent(event);
        QStringList out;
        for (const auto &[topic, payload] : received.events)
            out << QString::fromStdString(topic);
        return out;
    }
};

channel::SessionUp upOf(std::uint32_t session)
{
    channel::SessionUp out;
    out.session = channel::SessionId(session);
    out.peerName = "air-1";
    return out;
}

channel::SessionDown downOf(std::uint32_t session)
{
    channel::SessionDown out;
    out.session = channel::SessionId(session);
    return out;
}

} // namespace

class FleetFeedTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stateIsThatOfTheMonitor();
    void statesComeTwiceASecond();
    void eventsGoToTheVehiclesTheyConcern();
    void eventsHaveTheFormOfTheMonitor();
    void strangersClaimMakesNoTopic();
    void framesOnlyWhereAskedFor();
};

void FleetFeedTest::stateIsThatOfTheMonitor()
{
    Rig rig;
    Snapshot snapshot = fleet(1);
    snapshot.vehicles[2].session.reset(); // plain
    rig.feed.take(snapshot, WallTime(std::chrono::milliseconds(1'700'000'000'250)));
    QCOMPARE(rig.received.states.size(), std::size_t(3));
    QCOMPARE(rig.received.states[0].first, std::string("vehicle/7/state"));
    const QJsonObject state = parsed(rig.received.states[0].second);
    QCOMPARE(state[QLatin1String("event")].toString(), QStringLiteral("state"));
    QCOMPARE(state[QLatin1String("time")].toDouble(), 1'700'000'000.25);
    QCOMPARE(state[QLatin1String("alt_rel")].toDouble(), 12.5);
    QCOMPARE(state[QLatin1String("sealed")].toBool(), true);
    QCOMPARE(state[QLatin1String("peer")].toString(), QStringLiteral("air-1"));
    QCOMPARE(state[QLatin1String("suite")].toString(), QStringLiteral("aes-256-gcm"));
    const QJsonObject monitored = parsed(statsEvent("stats", snapshot, 1))[QLatin1String("vehicles")][0].toObject();
    QVERIFY(monitored.size() > 30);
    for (auto field = monitored.begin(); field != monitored.end(); ++field)
        QCOMPARE(state[field.key()], field.value());
    const QJsonObject plain = parsed(rig.received.states[2].second);
    QCOMPARE(plain[QLatin1String("sealed")].toBool(true), false);
    QVERIFY(!plain.contains(QLatin1String("peer")));
}

/// Of snapshots that come four or thirty times a second.
void FleetFeedTest::statesComeTwiceASecond()
{
    for (const int rate : {4, 30}) {
        Rig rig;
        for (int i = 0; i < 10 * rate; ++i)
            rig.feed.take(fleet(double(i) / rate), {});
        QCOMPARE(rig.received.states.size(), std::size_t(3 * 20));
        rig.feed.take(fleet(1000), {}); // after a pause there is nothing to make up for
        rig.feed.take(fleet(1000.25), {});
        QCOMPARE(rig.received.states.size(), std::size_t(3 * 21));
    }
}

void FleetFeedTest::eventsGoToTheVehiclesTheyConcern()
{
    Rig rig;
    rig.feed.take(fleet(1), {});
    const channel::SessionId session{1};
    const QStringList both{QStringLiteral("vehicle/7/event"), QStringLiteral("vehicle/8/event")},
        one{QStringLiteral("vehicle/9/event")}, gateway{QStringLiteral("gateway/event")};
    QCOMPARE(rig.topicsOf(channel::SwitchDone{.session = session}), both);
    QCOMPARE(rig.topicsOf(channel::ForgeryAlarm{session, 3, 1}), both);
    QCOMPARE(rig.topicsOf(downOf(1)), both);
    QCOMPARE(rig.topicsOf(upOf(5)), gateway); // no vehicle was heard over it
    QCOMPARE(rig.topicsOf(VehicleLost{9}), one);
    QCOMPARE(rig.topicsOf(VehicleFound{.systemId = 30}), QStringList(QStringLiteral("vehicle/30/event")));
    QCOMPARE(rig.topicsOf(vehicle::TextReceived{9, {}}), one);
    QCOMPARE(rig.topicsOf(ClientGone{"planner", "127.0.0.1:1"}), gateway);
    QCOMPARE(rig.topicsOf(channel::SwitchPending{.session = session}), QStringList()); // no script sees it
    QCOMPARE(rig.topicsOf(vehicle::CommandResult{}), QStringList());
}

void FleetFeedTest::eventsHaveTheFormOfTheMonitor()
{
    Rig rig;
    rig.feed.take(fleet(1), {});
    PeerNames names;
    const Event up = upOf(1);
    const Event down = downOf(1);
    const Event text = vehicle::TextReceived{7, {}};
    for (const Event &event : {up, down, text}) {
        names.note(event);
        rig.received.events.clear();
        rig.feed.handleEvent(event);
        QVERIFY(!rig.received.events.empty());
        QCOMPARE(rig.received.events[0].second, eventJson(event, names));
    }
    QVERIFY(eventJson(down, names).find("air-1") == std::string::npos); // the names are needed, and kept while they are
}

void FleetFeedTest::strangersClaimMakesNoTopic()
{
    Rig rig;
    rig.feed.take(fleet(1), {});
    for (int claimed = 0; claimed < 256; ++claimed) {
        const QStringList topics = rig.topicsOf(PlaintextRefused{std::uint8_t(claimed), "10.0.0.9:1", 1});
        const bool isKnown = claimed >= 7 && claimed <= 9;
        QCOMPARE(topics,
                 QStringList(isKnown ? QStringLiteral("vehicle/%1/event").arg(claimed) : QStringLiteral("gateway/event")));
    }
}

void FleetFeedTest::framesOnlyWhereAskedFor()
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView frame = mavlink::FrameWriter(7, 1).write(mavlink::Heartbeat{}, buffer);
    for (const bool raw : {false, true}) {
        Rig rig(raw);
        rig.feed.takeFrame(frame);
        QCOMPARE(rig.received.frames.size(), std::size_t(raw));
        if (raw)
            QVERIFY(std::ranges::equal(rig.received.frames[7], frame));
    }
}

SKYSEAL_TEST_APPLESS(FleetFeedTest)
#include "fleet_feed_test.moc"
