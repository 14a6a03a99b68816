// Fences, rally points, files and flight logs through the gateway, as a station that knows nothing of sealing transfers them,
// while the suite of the sealed link changes five times a second.
#include "core/channel/policy.h"
#include "core/vehicle/request.h"
#include "tests/engine/served_flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTimer>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::test;
using vehicle::MissionType;

namespace {

engine::StationConfig plainConfig()
{
    engine::StationConfig config;
    config.secure = engine::SecureMode::Off;
    config.record = false;
    return config;
}

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
    item.frame = command == mavlink::MAV_CMD_NAV_RALLY_POINT ? mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT
                                                             : mavlink::MAV_FRAME_GLOBAL;
    item.parameters[0] = size;
    item.latitude = -35.363261 + north;
    item.longitude = 149.165230 + east;
    item.altitude = command == mavlink::MAV_CMD_NAV_RALLY_POINT ? 30.f : 0.f;
    return item;
}

std::vector<vehicle::MissionItem> someItems(MissionType type)
{
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

std::size_t itemsOf(const sim::SimulatedVehicle &aircraft, MissionType type)
{
    return type == MissionType::Rally ? aircraft.autopilot().flight().rallyPoints.items().size()
                                      : aircraft.autopilot().flight().fence.areas().items().size();
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
    void filesAndLogsAreTransferred();
    void readerChangesNothing();

private:
    static void types()
    {
        QTest::addColumn<int>("type");
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
    QVERIFY(std::ranges::equal(*read.items, items, isSame));
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
    QVERIFY(std::ranges::equal(*read.items, items, isSame));
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
    const vehicle::RequestId plan = flight.ask(vehicle::ClearMission{MissionType::Rally});
    const vehicle::RequestId files = flight.ask(vehicle::ListFolder{"APM"});
    const vehicle::RequestId logs = flight.ask(vehicle::ListLogs{});
    const vehicle::RequestId parameter = flight.ask(vehicle::WriteParameter{"WPNAV_SPEED", 333});
    const auto cleared = flight.resultOf<vehicle::MissionResult>(plan);
    QVERIFY(!cleared.ok && cleared.changeUnanswered);
    QCOMPARE(itemsOf(*flight.aircraft, MissionType::Rally), items.size());
    QVERIFY(!flight.resultOf<vehicle::FileResult>(files).ok);
    QVERIFY(!flight.resultOf<vehicle::LogResult>(logs).ok);
    QVERIFY(!flight.resultOf<vehicle::ParameterResult>(parameter).ok);
    QVERIFY(flight.aircraft->autopilot().parameters().value("WPNAV_SPEED") != 333.f);
    QVERIFY(flight.ground.ears->snapshot->clients[0].counters.denied > 3);
}

SKYSEAL_TEST(GatewayTransferTest)
#include "gateway_transfer_test.moc"
