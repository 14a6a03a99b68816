// Missions, fences, rally points, parameters, files and flight logs through the gateway, as a station that knows nothing of
// sealing transfers them, while the suite of the sealed link changes five times a second.
#include "core/channel/policy.h"
#include "core/mavlink/messages.h"
#include "core/vehicle/request.h"
#include "tests/engine/served_flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTimer>
#include <QtTest/QTest>

#include <algorithm>
#include <span>

using namespace skyseal;
using namespace skyseal::test;
using vehicle::MissionType;

namespace {

/// A flight behind a gateway, and a client of it that is a whole ground station.
struct TransferFlight : ServedFlight
{
    explicit TransferFlight(const std::string &options)
        : ServedFlight(options), aircraft(&fly().vehicle),
          client(plainConfig(), urlOf("udpout:127.0.0.1:" + std::to_string(port())))
    {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { switchNext(); });
        m_timer.start(200);
        if (!eventually([this] { return !client.ears->snapshot->vehicles.empty(); }))
            qFatal("the client sees no vehicle");
    }

    vehicle::RequestId ask(vehicle::Request request) { return client.station->perform(1, std::move(request)); }
    /// The result of a request by the client.
    template<typename Result> Result result(vehicle::Request request) { return resultOf<Result>(ask(std::move(request))); }
    template<typename Result> Result resultOf(vehicle::RequestId id)
    {
        std::optional<Result> found;
        const bool came = eventually([&] {
            for (const Result &one : client.ears->all<Result>()) {
                if (one.id == id)
                    found = one;
            }
            return found.has_value();
        });
        return came ? *found : Result{.reason = "no result"};
    }
    /// Whether the gateway's own station has written a plan.
    bool gatewayWrote(vehicle::RequestId id) const
    {
        const auto results = ground.ears->all<vehicle::MissionResult>();
        return std::ranges::any_of(results, [id](const auto &result) { return result.id == id && result.ok; });
    }
    /// How many messages of a kind the client has received from the vehicle since it inspects them.
    std::uint64_t received(std::uint32_t messageId) const
    {
        const auto &rows = client.ears->snapshot->inspector;
        const auto row = std::ranges::find(rows, messageId, &engine::InspectorRow::messageId);
        return row == rows.end() ? 0 : row->count;
    }
    std::size_t switches() const
    {
        const auto done = ground.ears->all<channel::SwitchDone>();
        return static_cast<std::size_t>(std::ranges::count_if(
            done, [](const channel::SwitchDone &one) { return one.failure == channel::SwitchFailure::None && !one.rekey; }));
    }

    sim::SimulatedVehicle *const aircraft;
    Ground client;

private:
    void switchNext()
    {
        if (ground.ears->snapshot->sessions.empty())
            return;
        const std::vector<crypto::SuiteId> suites = channel::defaultSuites();
        ground.station->switchSuite(ground.ears->snapshot->sessions[0].info.session, suites[m_next++ % suites.size()]);
    }

    QTimer m_timer;
    std::size_t m_next = 0;
};

vehicle::MissionItem itemAt(std::uint16_t command, float size, double north, double east)
{
    vehicle::MissionItem item;
    item.command = command;
    const bool hasHeight = command < mavlink::MAV_CMD_NAV_FENCE_RETURN_POINT || command == mavlink::MAV_CMD_NAV_RALLY_POINT;
    item.frame = hasHeight ? mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT : mavlink::MAV_FRAME_GLOBAL;
    item.parameters[0] = size;
    item.latitude = -35.363261 + north;
    item.longitude = 149.165230 + east;
    item.altitude = hasHeight ? 30.f : 0.f;
    return item;
}

/// A take-off, some legs and a landing, after the place of home.
std::vector<vehicle::MissionItem> someMission()
{
    std::vector<vehicle::MissionItem> out{itemAt(mavlink::MAV_CMD_NAV_WAYPOINT, 0, 0, 0),
                                          itemAt(mavlink::MAV_CMD_NAV_TAKEOFF, 0, 0, 0)};
    for (int leg = 0; leg < 50; ++leg)
        out.push_back(itemAt(mavlink::MAV_CMD_NAV_WAYPOINT, float(leg % 4), 0.0001 * leg, -0.0002 * leg));
    out.push_back(itemAt(mavlink::MAV_CMD_NAV_LAND, 0, 0.001, 0));
    return out;
}

std::vector<vehicle::MissionItem> someItems(MissionType type)
{
    if (type == MissionType::Mission)
        return someMission();
    if (type == MissionType::Rally)
        return {itemAt(mavlink::MAV_CMD_NAV_RALLY_POINT, 0, 0.0005, 0), itemAt(mavlink::MAV_CMD_NAV_RALLY_POINT, 0, 0, 0.0007)};
    constexpr std::uint16_t kVertex = mavlink::MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION;
    return {itemAt(kVertex, 4, 0.002, -0.002), itemAt(kVertex, 4, 0.002, 0.002), itemAt(kVertex, 4, -0.002, 0.002),
            itemAt(kVertex, 4, -0.002, -0.002), itemAt(mavlink::MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION, 20, 0.001, 0)};
}

/// On the wire, places have steps of 1e-7 degrees.
bool isSame(const vehicle::MissionItem &a, const vehicle::MissionItem &b)
{
    return a.command == b.command && a.frame == b.frame && a.parameters[0] == b.parameters[0] && a.altitude == b.altitude
        && std::abs(a.latitude - b.latitude) < 1e-6 && std::abs(a.longitude - b.longitude) < 1e-6;
}

/// The vehicle has its home as item 0 of a mission, in place of what was written.
bool isSamePlan(const std::vector<vehicle::MissionItem> &a, const std::vector<vehicle::MissionItem> &b, MissionType type)
{
    const std::size_t first = type == MissionType::Mission ? 1 : 0;
    return a.size() == b.size() && std::ranges::equal(std::span(a).subspan(first), std::span(b).subspan(first), isSame);
}

std::size_t itemsOf(const sim::SimulatedVehicle &aircraft, MissionType type)
{
    switch (type) {
    case MissionType::Mission: return aircraft.autopilot().modes().mission().mission().size();
    case MissionType::Fence: return aircraft.autopilot().flight().fence.areas().items().size();
    case MissionType::Rally: return aircraft.autopilot().flight().rallyPoints.items().size();
    }
    return 0;
}

} // namespace

class GatewayTransferTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plansAreWrittenAndRead_data() { types(); }
    void plansAreWrittenAndRead();
    void readerReadsPlans_data() { types(); }
    void readerReadsPlans();
    void wholeParameterListIsRead_data();
    void wholeParameterListIsRead();
    void filesAndLogsAreTransferred();
    void readerChangesNothing();

private:
    static void types()
    {
        QTest::addColumn<int>("type");
        QTest::newRow("mission") << int(MissionType::Mission);
        QTest::newRow("fence") << int(MissionType::Fence);
        QTest::newRow("rally points") << int(MissionType::Rally);
    }
};

void GatewayTransferTest::plansAreWrittenAndRead()
{
    QFETCH(int, type);
    TransferFlight flight(",write=mission");
    const MissionType kind{static_cast<std::uint8_t>(type)};
    const std::vector<vehicle::MissionItem> items = someItems(kind);
    const auto written = flight.result<vehicle::MissionResult>(vehicle::WriteMission{items, kind});
    QVERIFY2(written.ok, written.reason.text().c_str());
    QCOMPARE(itemsOf(*flight.aircraft, kind), items.size());
    const auto read = flight.result<vehicle::MissionResult>(vehicle::ReadMission{kind});
    QVERIFY2(read.ok, read.reason.text().c_str());
    QVERIFY(isSamePlan(*read.items, items, kind));
    const auto cleared = flight.result<vehicle::MissionResult>(vehicle::ClearMission{kind});
    QVERIFY2(cleared.ok, cleared.reason.text().c_str());
    QCOMPARE(itemsOf(*flight.aircraft, kind), std::size_t(0));
    EVENTUALLY(flight.switches() > 5);
    QCOMPARE(flight.client.ears->snapshot->mavlink.lost, std::uint64_t(0));
}

void GatewayTransferTest::readerReadsPlans()
{
    QFETCH(int, type);
    TransferFlight flight("");
    const MissionType kind{static_cast<std::uint8_t>(type)};
    const std::vector<vehicle::MissionItem> items = someItems(kind);
    const vehicle::RequestId id = flight.ground.station->perform(1, vehicle::WriteMission{items, kind});
    EVENTUALLY(flight.gatewayWrote(id));
    const auto read = flight.result<vehicle::MissionResult>(vehicle::ReadMission{kind});
    QVERIFY2(read.ok, read.reason.text().c_str());
    QVERIFY(isSamePlan(*read.items, items, kind));
}

void GatewayTransferTest::wholeParameterListIsRead_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<bool>("isFile");
    QTest::newRow("by messages, a reader") << QString() << false;
    QTest::newRow("as a file, a client that may use FTP") << QStringLiteral(",write=ftp") << true;
}

void GatewayTransferTest::wholeParameterListIsRead()
{
    QFETCH(QString, options);
    QFETCH(bool, isFile);
    TransferFlight flight(options.toStdString());
    sim::Parameters &own = flight.aircraft->autopilot().parameters();
    EVENTUALLY_EQUAL(own.integer("SR0_EXTRA3"), 3); // the last change of the gateway's own station
    QVERIFY(own.set("WPNAV_SPEED", 321) == sim::Parameters::SetResult::Stored);
    QVERIFY(own.set("ATC_RAT_PIT_P", 0.1234567f) == sim::Parameters::SetResult::Stored);
    flight.client.station->setInspecting(true);
    const auto values = [&] { return flight.received(mavlink::ParamValue::kId); };
    const auto parts = [&] { return flight.received(mavlink::FileTransferProtocol::kId); };

    const std::size_t switchesBefore = flight.switches();
    const auto read = flight.result<vehicle::ParameterResult>(vehicle::ReadParameters{});
    QVERIFY2(read.ok, read.reason.text().c_str());
    QCOMPARE(read.all->size(), own.count());
    for (const vehicle::Parameter &parameter : *read.all) {
        const auto index = own.find(parameter.name);
        QVERIFY2(index.has_value(), parameter.name.c_str());
        QVERIFY2(static_cast<float>(parameter.value) == own.value(*index), parameter.name.c_str());
        QCOMPARE(int(parameter.type), int(own.info(*index).type));
    }
    if (isFile) {
        EVENTUALLY(parts() > 10);
        QVERIFY(values() < 10);
    } else {
        EVENTUALLY(values() >= own.count());
        QCOMPARE(parts(), std::uint64_t(0));
        QVERIFY(flight.switches() > switchesBefore + 1); // the list takes a second or more
    }
    EVENTUALLY(flight.switches() > 5);
    QCOMPARE(flight.ground.ears->snapshot->channel.rx.lost, std::uint64_t(0));
}

void GatewayTransferTest::filesAndLogsAreTransferred()
{
    TransferFlight flight(",write=ftp");
    const vehicle::RequestId refused = flight.ask(vehicle::ClearMission{MissionType::Fence}); // is given up in the end
    const auto content = std::make_shared<Bytes>(20'000);
    for (std::size_t i = 0; i < content->size(); ++i)
        (*content)[i] = static_cast<std::uint8_t>(i * 131 + i / 256);
    const auto written = flight.result<vehicle::FileResult>(vehicle::WriteFile{"APM/terrain.dat", content});
    QVERIFY2(written.ok && written.verified, written.reason.text().c_str());
    const auto read = flight.result<vehicle::FileResult>(vehicle::ReadFile{"APM/terrain.dat"});
    QVERIFY2(read.ok && read.verified, read.reason.text().c_str());
    QCOMPARE(*read.content, *content);
    const auto parameters = flight.result<vehicle::FileResult>(vehicle::ReadFile{"@PARAM/param.pck"});
    QVERIFY2(parameters.ok, parameters.reason.text().c_str());
    QVERIFY(parameters.content->size() > 1000);
    const auto removed = flight.result<vehicle::FileResult>(vehicle::RemoveFile{"APM/terrain.dat"});
    QVERIFY2(removed.ok, removed.reason.text().c_str());

    // A flight makes a log, which comes by both protocols.
    QVERIFY(!flight.aircraft->autopilot().arming().arm(true));
    const std::uint64_t armedAt = flight.aircraft->autopilot().time();
    EVENTUALLY(flight.aircraft->autopilot().time() > armedAt + 1'000'000);
    flight.aircraft->autopilot().arming().disarm(true);
    const auto logs = flight.result<vehicle::LogResult>(vehicle::ListLogs{});
    QVERIFY2(logs.ok && logs.entries->size() == 1, logs.reason.text().c_str());
    const auto log = flight.result<vehicle::LogResult>(vehicle::ReadLog{logs.entries->front().id});
    QVERIFY2(log.ok, log.reason.text().c_str());
    QVERIFY(log.content->size() > 1000);
    const auto file = flight.result<vehicle::FileResult>(vehicle::ReadFile{"APM/LOGS/00000001.BIN"});
    QVERIFY2(file.ok, file.reason.text().c_str());
    QCOMPARE(*file.content, *log.content);
    const auto erased = flight.result<vehicle::LogResult>(vehicle::EraseLogs{});
    QVERIFY2(erased.ok, erased.reason.text().c_str());
    QVERIFY(flight.switches() > 5);
    QCOMPARE(flight.client.ears->snapshot->mavlink.lost, std::uint64_t(0));

    // The class opens nothing else.
    const auto cleared = flight.resultOf<vehicle::MissionResult>(refused);
    QVERIFY(!cleared.ok && cleared.changeUnanswered);
}

/// By FTP a client could write and remove files, and logs take the vehicle's downlink, so that both need write=ftp.
void GatewayTransferTest::readerChangesNothing()
{
    TransferFlight flight("");
    const std::vector<vehicle::MissionItem> items = someItems(MissionType::Rally);
    const vehicle::RequestId own = flight.ground.station->perform(1, vehicle::WriteMission{items, MissionType::Rally});
    EVENTUALLY(flight.gatewayWrote(own));
    // The client has heard that another station sent the list.
    const vehicle::RequestId plan = flight.ask(vehicle::ClearMission{.type = MissionType::Rally, .overwrite = true});
    const vehicle::RequestId files = flight.ask(vehicle::ListFolder{"APM"});
    const vehicle::RequestId logs = flight.ask(vehicle::ListLogs{});
    const vehicle::RequestId parameter = flight.ask(vehicle::WriteParameter{"WPNAV_SPEED", 333});
    const auto cleared = flight.resultOf<vehicle::MissionResult>(plan);
    QVERIFY2(!cleared.ok && cleared.changeUnanswered, cleared.reason.text().c_str());
    QCOMPARE(itemsOf(*flight.aircraft, MissionType::Rally), items.size());
    QVERIFY(!flight.resultOf<vehicle::FileResult>(files).ok);
    QVERIFY(!flight.resultOf<vehicle::LogResult>(logs).ok);
    QVERIFY(!flight.resultOf<vehicle::ParameterResult>(parameter).ok);
    QVERIFY(flight.aircraft->autopilot().parameters().value("WPNAV_SPEED") != 333.f);
    QVERIFY(flight.ground.ears->snapshot->clients[0].counters.denied > 3);
}

SKYSEAL_TEST(GatewayTransferTest)
#include "gateway_transfer_test.moc"
