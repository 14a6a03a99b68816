// Fence and rally points: what their items mean, how the map takes them from snapshots, and how the mission panel reads them.
#include "scripted_snapshots.h"
#include "tests/support/test_runner.h"
#include "ui/map/fence.h"
#include "ui/map/map_view.h"
#include "ui/tiles/mercator.h"
#include "window_rig.h"

#include <QtTest/QTest>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include <cmath>
#include <limits>

using namespace skyseal;
using namespace skyseal::ui;
using namespace skyseal::mavlink;
using vehicle::MissionType;

namespace {

vehicle::MissionItem fenceItem(std::uint16_t command, float first, double latitude, double longitude)
{
    vehicle::MissionItem item{.command = command, .frame = MAV_FRAME_GLOBAL};
    item.parameters[0] = first;
    item.latitude = latitude;
    item.longitude = longitude;
    return item;
}

vehicle::MissionItem corner(double latitude, double longitude, float corners,
                            std::uint16_t command = MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION)
{
    return fenceItem(command, corners, latitude, longitude);
}

vehicle::MissionItems listOf(std::vector<vehicle::MissionItem> items)
{
    return std::make_shared<const std::vector<vehicle::MissionItem>>(std::move(items));
}

} // namespace

class FenceTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void itemsMakeAreas()
    {
        constexpr auto kOut = MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION;
        const FenceShapes fence = fenceOf(
            {corner(47, 8, 3), corner(47, 9, 3), corner(48, 9, 3), // one triangle, and another one
             corner(1, 1, 3), corner(1, 2, 3), corner(2, 2, 3), corner(5, 5, 4, kOut), corner(5, 6, 4, kOut),
             corner(6, 6, 4, kOut), corner(6, 5, 4, kOut), fenceItem(MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, 150, 47, 8),
             fenceItem(MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION, 20, 47.1, 8.1),
             fenceItem(MAV_CMD_NAV_FENCE_RETURN_POINT, 0, 47.2, 8.2)});
        QCOMPARE(fence.areas.size(), std::size_t(5));
        QCOMPARE(fence.areas[0].corners.size(), qsizetype(3));
        QVERIFY(fence.areas[0].inclusion && !fence.areas[0].centre);
        QCOMPARE(fence.areas[1].corners.front(), mercator::project({1, 1}));
        QVERIFY(!fence.areas[2].inclusion);
        QCOMPARE(fence.areas[2].corners.size(), qsizetype(4));
        QVERIFY(fence.areas[3].inclusion && fence.areas[3].centre);
        QCOMPARE(fence.areas[3].radius, 150.0);
        QVERIFY(!fence.areas[4].inclusion);
        QCOMPARE(*fence.areas[4].centre, mercator::project({47.1, 8.1}));
        QCOMPARE(fence.returnPoints.size(), std::size_t(1));
    }

    void itemsThatMakeNoAreaAreLeftOut_data()
    {
        QTest::addColumn<std::vector<vehicle::MissionItem>>("items");
        using Items = std::vector<vehicle::MissionItem>;
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("none") << Items{};
        QTest::newRow("a corner is missing") << Items{corner(47, 8, 4), corner(47, 9, 4), corner(48, 9, 4)};
        QTest::newRow("two corners") << Items{corner(47, 8, 2), corner(47, 9, 2)};
        QTest::newRow("no number of corners") << Items{corner(47, 8, 0), corner(47, 9, 0), corner(48, 9, 0)};
        QTest::newRow("number unknown") << Items{corner(47, 8, std::nanf("")), corner(47, 9, std::nanf(""))};
        QTest::newRow("corner without a place") << Items{corner(47, 8, 3), corner(kNone, 9, 3), corner(48, 9, 3)};
        QTest::newRow("another kind between")
            << Items{corner(47, 8, 3), corner(47, 9, 3), corner(48, 9, 3, MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION)};
        QTest::newRow("no radius") << Items{fenceItem(MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, 0, 47, 8)};
        QTest::newRow("negative radius") << Items{fenceItem(MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION, -5, 47, 8)};
        QTest::newRow("a waypoint") << Items{fenceItem(MAV_CMD_NAV_WAYPOINT, 0, 47, 8)};
    }

    void itemsThatMakeNoAreaAreLeftOut()
    {
        QFETCH(std::vector<vehicle::MissionItem>, items);
        const FenceShapes fence = fenceOf(items);
        QVERIFY(fence.areas.empty() && fence.returnPoints.empty());
    }

    void mapShowsThoseOfTheSelectedVehicle()
    {
        const auto &content = find<MapView>("map")->fence();
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().fence = listOf({corner(47, 8, 3), corner(47, 9, 3), corner(48, 9, 3)});
        snapshot.vehicles.front().rally = listOf({fenceItem(MAV_CMD_NAV_RALLY_POINT, 0, 47, 8)});
        m_station->show(snapshot);
        QCOMPARE(content.fence().areas.size(), std::size_t(1));
        QCOMPARE(content.rallyPoints().size(), std::size_t(1));
        snapshot.vehicles.front().fence = listOf({});
        ++snapshot.time;
        m_station->show(snapshot);
        QVERIFY(content.fence().areas.empty());
        QCOMPARE(content.rallyPoints().size(), std::size_t(1));
        snapshot.vehicles.front().state.systemId = 2;
        snapshot.vehicles.front().rally = nullptr;
        ++snapshot.time;
        m_station->show(snapshot);
        QVERIFY(content.rallyPoints().empty());
    }

    void panelReadsOneListAfterAnother()
    {
        showVehicle(MAV_PROTOCOL_CAPABILITY_MISSION_FENCE | MAV_PROTOCOL_CAPABILITY_MISSION_RALLY);
        clickRead();
        QCOMPARE(lastRead(), std::optional(MissionType::Mission));
        QVERIFY2(result().contains(QStringLiteral("Reading the mission…")), qPrintable(result()));
        clickRead(); // it reads already
        QCOMPARE(m_station->requests.size(), std::size_t(1));
        answer(MissionType::Mission, 5);
        QCOMPARE(lastRead(), std::optional(MissionType::Fence));
        answer(MissionType::Fence, 8);
        QCOMPARE(lastRead(), std::optional(MissionType::Rally));
        answer(MissionType::Rally, 2);
        QCOMPARE(m_station->requests.size(), std::size_t(3));
        QVERIFY2(result().contains(QStringLiteral("Read: mission items: 5, fence: 8, rally points: 2")), qPrintable(result()));
    }

    void panelReadsOnlyWhatTheVehicleHas()
    {
        showVehicle(MAV_PROTOCOL_CAPABILITY_MISSION_RALLY);
        clickRead();
        answer(MissionType::Mission, 5);
        QCOMPARE(lastRead(), std::optional(MissionType::Rally));
        answer(MissionType::Rally, 0);
        QCOMPARE(m_station->requests.size(), std::size_t(2));
        showVehicle(0); // not known
        clickRead();
        answer(MissionType::Mission, 5);
        QCOMPARE(m_station->requests.size(), std::size_t(3));
    }

    void failuresAreShown()
    {
        showVehicle(MAV_PROTOCOL_CAPABILITY_MISSION_FENCE | MAV_PROTOCOL_CAPABILITY_MISSION_RALLY);
        clickRead();
        answer(MissionType::Mission, 5);
        answer(MissionType::Fence, 0, "unsupported");
        QCOMPARE(lastRead(), std::optional(MissionType::Rally));
        answer(MissionType::Rally, 2);
        QVERIFY2(result().contains(QStringLiteral("Fence not read: unsupported")), qPrintable(result()));
        QVERIFY2(result().contains(QStringLiteral("rally points: 2")), qPrintable(result()));
        clickRead();
        const std::size_t before = m_station->requests.size();
        answer(MissionType::Mission, 0, "no answer to 8 attempts");
        QCOMPARE(m_station->requests.size(), before); // the others would not be answered either
        QVERIFY2(result().contains(QStringLiteral("Mission not read: no answer")), qPrintable(result()));
    }

    void anotherVehicleEndsTheReading()
    {
        showVehicle(MAV_PROTOCOL_CAPABILITY_MISSION_FENCE);
        clickRead();
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.vehicles.front().state.systemId = 2;
        m_station->show(snapshot);
        answer(MissionType::Mission, 5);
        QCOMPARE(m_station->requests.size(), std::size_t(1));
    }

private:
    void showVehicle(std::uint64_t capabilities)
    {
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.vehicles.front().state.capabilities = capabilities;
        m_station->show(snapshot);
        auto *dock = find<QDockWidget>("dockMission");
        dock->show();
        dock->raise();
    }
    void clickRead() { QTest::mouseClick(find<QPushButton>("missionRead"), Qt::LeftButton); }
    std::optional<MissionType> lastRead() const
    {
        const auto *read = m_station->requests.empty() ? nullptr
                                                       : std::get_if<vehicle::ReadMission>(&m_station->requests.back());
        return read ? std::optional(read->type) : std::nullopt;
    }
    QString result() const { return find<QLabel>("missionResult")->text(); }
    void answer(MissionType type, std::size_t items, const std::string &failure = {})
    {
        vehicle::MissionResult result{vehicle::RequestId{static_cast<std::uint32_t>(m_station->requests.size())},
                                      1,
                                      vehicle::MissionTransfer::Download,
                                      type,
                                      failure.empty(),
                                      failure};
        if (result.ok)
            result.items = listOf(std::vector<vehicle::MissionItem>(items));
        m_station->notify(result);
    }

    double m_time = 0;
};

SKYSEAL_TEST_WIDGETS(FenceTest)
#include "fence_test.moc"
