// The drawn route is the flown one: every command with a place is on it, with splines, loiters and jumps.
#include "tests/support/test_runner.h"
#include "ui/map/altitude_profile.h"
#include "ui/map/axis_ticks.h"
#include "ui/map/mission_painter.h"
#include "ui/map/mission_route.h"

#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtTest/QTest>

#include <cmath>
#include <limits>

using namespace skyseal;
using namespace skyseal::ui;
using vehicle::MissionItem;

namespace {

// On the equator, where metres of the map are metres on the ground.
const QPointF kOrigin = mercator::project({0, 11});
const QPointF kHome = kOrigin + QPointF(-100, 0);

MissionItem at(std::uint16_t sequence, std::uint16_t command, double north, std::vector<float> parameters = {})
{
    MissionItem item{.sequence = sequence, .command = command, .latitude = north / mercator::kMetresPerDegree, .longitude = 11};
    std::copy(parameters.begin(), parameters.end(), item.parameters);
    return item;
}

/// Without a place.
MissionItem order(std::uint16_t sequence, std::uint16_t command, std::vector<float> parameters = {})
{
    MissionItem item{.sequence = sequence, .command = command};
    std::copy(parameters.begin(), parameters.end(), item.parameters);
    return item;
}

MissionRoute route(const std::vector<MissionItem> &items, bool firstIsHome = true)
{
    return routeOf(items, kHome, firstIsHome);
}

QList<int> sequences(const MissionRoute &route)
{
    QList<int> out;
    for (const RouteStop &stop : route.stops)
        out << stop.sequence;
    return out;
}

} // namespace

class MissionRouteTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void profileFollowsTheGround()
    {
        // On the equator, and at 60° north, where a metre on the ground is two of the map.
        for (const double latitude : {0.0, 60.0}) {
            std::vector<MissionItem> items;
            for (std::uint16_t i = 0; i < 3; ++i)
                items.push_back({.sequence = static_cast<std::uint16_t>(i + 1),
                                 .latitude = latitude + i * 100 / mercator::kMetresPerDegree,
                                 .longitude = 11,
                                 .altitude = 10.F * static_cast<float>(i)});
            const auto points = profileOf(routeOf(items, std::nullopt, true), 500);
            QCOMPARE(points.size(), std::size_t(3));
            for (std::size_t i = 0; i < 3; ++i) {
                QCOMPARE(points[i].sequence, static_cast<int>(i) + 1);
                QVERIFY2(std::abs(points[i].distance - 100 * static_cast<double>(i)) < 0.1,
                         qPrintable(QString::number(points[i].distance)));
                QCOMPARE(points[i].altitude, 10.0 * static_cast<double>(i));
            }
        }
    }

    void profileKnowsWhatAnAltitudeCountsFrom()
    {
        auto fromHome = at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 10), fromSea = at(2, mavlink::MAV_CMD_NAV_WAYPOINT, 20),
             fromTerrain = at(3, mavlink::MAV_CMD_NAV_WAYPOINT, 30);
        fromHome.altitude = fromTerrain.altitude = 40;
        fromSea.altitude = 540;
        fromSea.frame = mavlink::MAV_FRAME_GLOBAL;
        fromTerrain.frame = mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT;
        const MissionRoute made = route({fromHome, fromSea, fromTerrain, order(4, mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH)});
        const auto points = profileOf(made, 500);
        QCOMPARE(points.size(), std::size_t(4));
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(points[i].altitude, 40.0);
            QCOMPARE(points[i].overTerrain, i == 2);
        }
        QVERIFY(std::isnan(points[3].altitude)); // the altitude of a return is a parameter of the vehicle
        const auto unknown = profileOf(made, std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(unknown[0].altitude, 40.0);
        QVERIFY(std::isnan(unknown[1].altitude));
    }

    void impossibleAltitudesAreUnknown()
    {
        for (const float altitude : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                                     std::numeric_limits<float>::quiet_NaN(), 1e30F}) {
            auto item = at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 10);
            item.altitude = altitude;
            QVERIFY(std::isnan(profileOf(route({item}), 500).front().altitude));
        }
    }

    void axisTicksDiffer_data()
    {
        QTest::addColumn<double>("length");
        QTest::addColumn<int>("units");
        for (const double length : {0.4, 1.0, 3.0, 10.0, 47.0, 900.0, 9'900.0, 23'456.0, 1e6})
            for (const UnitSystem units : {UnitSystem::Metric, UnitSystem::Imperial, UnitSystem::Aviation})
                QTest::addRow("%g m, %d", length, int(units)) << length << int(units);
    }

    void axisTicksDiffer()
    {
        QFETCH(double, length);
        QFETCH(int, units);
        for (const UnitScale scale : {distanceScale(length, UnitSystem(units)), altitudeScale(UnitSystem(units))}) {
            const auto ticks = axisTicks(-0.2 * length, length, length / 6, scale);
            QVERIFY(!ticks.empty() && ticks.size() <= 8);
            QSet<QString> texts;
            for (const AxisTick &tick : ticks) {
                QVERIFY(tick.value >= -0.2001 * length && tick.value <= 1.0001 * length);
                texts.insert(tick.text);
            }
            QCOMPARE(std::size_t(texts.size()), ticks.size());
        }
    }

    void profileOfASplineIsLongerThanTheLine()
    {
        auto bend = at(2, mavlink::MAV_CMD_NAV_SPLINE_WAYPOINT, 0);
        bend.longitude += 100 / mercator::kMetresPerDegree;
        const auto points = profileOf(
            route({at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 0), bend, at(3, mavlink::MAV_CMD_NAV_WAYPOINT, 100)}), 0);
        QCOMPARE(points.size(), std::size_t(3));
        QVERIFY2(points[1].distance > 100.5 && points[1].distance < 130, qPrintable(QString::number(points[1].distance)));
    }

    void everyCommandWithAPlaceIsOnTheLine_data()
    {
        QTest::addColumn<int>("command");
        for (const int command :
             {mavlink::MAV_CMD_NAV_WAYPOINT, mavlink::MAV_CMD_NAV_LOITER_UNLIM, mavlink::MAV_CMD_NAV_LOITER_TURNS,
              mavlink::MAV_CMD_NAV_LOITER_TIME, mavlink::MAV_CMD_NAV_LAND, mavlink::MAV_CMD_NAV_TAKEOFF,
              mavlink::MAV_CMD_NAV_LOITER_TO_ALT, mavlink::MAV_CMD_NAV_SPLINE_WAYPOINT, mavlink::MAV_CMD_NAV_VTOL_TAKEOFF,
              mavlink::MAV_CMD_NAV_VTOL_LAND, mavlink::MAV_CMD_NAV_PAYLOAD_PLACE})
            QTest::addRow("%d", command) << command;
    }
    void everyCommandWithAPlaceIsOnTheLine()
    {
        QFETCH(int, command);
        const auto made = route({at(0, mavlink::MAV_CMD_NAV_WAYPOINT, -5), at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 10),
                                 at(2, static_cast<std::uint16_t>(command), 20), at(3, mavlink::MAV_CMD_NAV_WAYPOINT, 30)});
        QCOMPARE(sequences(made), (QList<int>{1, 2, 3}));
        QVERIFY(qAbs(made.stops[1].at.y() - 20) < 1e-3);
    }

    void firstItemIsHomeOnArduPilotOnly()
    {
        const std::vector<MissionItem> items{at(0, mavlink::MAV_CMD_NAV_WAYPOINT, 5), at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 10)};
        QCOMPARE(sequences(route(items, true)), (QList<int>{1}));
        QCOMPARE(sequences(route(items, false)), (QList<int>{0, 1}));
    }

    void beginsAndEndsAtHome()
    {
        const auto made = route({order(1, mavlink::MAV_CMD_NAV_TAKEOFF), at(2, mavlink::MAV_CMD_NAV_WAYPOINT, 10),
                                 order(3, mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH)});
        QCOMPARE(sequences(made), (QList<int>{-1, 1, 2, 3}));
        QCOMPARE(made.stops[0].at, kHome);
        QCOMPARE(made.stops[1].at, kHome); // takes off where it stands
        QCOMPARE(made.stops[3].at, kHome);
    }

    void loitersHaveTheirRadiusAndAmount()
    {
        const auto made = route({at(1, mavlink::MAV_CMD_NAV_LOITER_TURNS, 10, {3, 0, -25}),
                                 at(2, mavlink::MAV_CMD_NAV_LOITER_TIME, 20, {30, 0, 15}),
                                 at(3, mavlink::MAV_CMD_NAV_LOITER_UNLIM, 30),
                                 at(4, mavlink::MAV_CMD_NAV_LOITER_TO_ALT, 40, {1, 60})});
        QVERIFY(made.stops[0].loiter == RouteStop::Loiter::Turns && made.stops[0].amount == 3 && made.stops[0].radius == 25);
        QVERIFY(made.stops[1].loiter == RouteStop::Loiter::Time && made.stops[1].amount == 30 && made.stops[1].radius == 15);
        QVERIFY(made.stops[2].loiter == RouteStop::Loiter::Unlimited && made.stops[2].radius == 0);
        QVERIFY(made.stops[3].loiter == RouteStop::Loiter::ToAltitude && made.stops[3].radius == 60);
    }

    void splinesBend()
    {
        MissionItem aside = at(2, mavlink::MAV_CMD_NAV_SPLINE_WAYPOINT, 100);
        aside.longitude += 100 / mercator::kMetresPerDegree;
        const auto made = route({at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 0), aside, at(3, mavlink::MAV_CMD_NAV_WAYPOINT, 200)});
        const RouteStop &spline = made.stops[1];
        QVERIFY(spline.spline && !made.stops[2].spline);
        // At the stop the vehicle flies in parallel to the line between the neighbours: to the north.
        const QPointF arrival = spline.at - spline.controlOut;
        QVERIFY(arrival.y() > 10 && qAbs(arrival.x()) < 1e-3);
    }

    void jumpsAreShown()
    {
        const auto made = route({at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 10), at(2, mavlink::MAV_CMD_NAV_WAYPOINT, 20),
                                 at(3, mavlink::MAV_CMD_NAV_WAYPOINT, 30), order(4, mavlink::MAV_CMD_DO_JUMP, {2, 3}),
                                 order(5, mavlink::MAV_CMD_DO_JUMP, {1, -1})});
        QCOMPARE(made.jumps.size(), std::size_t(2));
        QVERIFY(made.jumps[0].from == 3 && made.jumps[0].to == 2 && made.jumps[0].times == 3);
        QVERIFY(made.jumps[1].from == 3 && made.jumps[1].to == 1 && made.jumps[1].times == -1);
    }

    void jumpsFollowTags()
    {
        const auto made = route({at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 10), order(2, mavlink::MAV_CMD_JUMP_TAG, {7}),
                                 at(3, mavlink::MAV_CMD_NAV_WAYPOINT, 30), order(4, mavlink::MAV_CMD_DO_JUMP_TAG, {7, 2}),
                                 order(5, mavlink::MAV_CMD_DO_JUMP_TAG, {8, 2})});
        QCOMPARE(made.jumps.size(), std::size_t(1));
        QVERIFY(made.jumps[0].from == 3 && made.jumps[0].to == 3 && made.jumps[0].times == 2);
    }

    void placesThatAreNotFlownToAreMarks()
    {
        const auto made = route({at(1, mavlink::MAV_CMD_NAV_WAYPOINT, 10), at(2, mavlink::MAV_CMD_DO_SET_ROI_LOCATION, 500),
                                 at(3, mavlink::MAV_CMD_NAV_ROI, 600), at(4, mavlink::MAV_CMD_NAV_WAYPOINT, 20)});
        QCOMPARE(sequences(made), (QList<int>{1, 4}));
        QCOMPARE(made.marks.size(), std::size_t(2));
        QCOMPARE(made.marks[0].sequence, 2);
    }

    /// Values of a vehicle, however wrong, are neither drawn far away nor do they end the program.
    void wrongValuesAreBorne()
    {
        const float nan = std::numeric_limits<float>::quiet_NaN(), huge = std::numeric_limits<float>::max();
        MissionItem nowhere = at(2, mavlink::MAV_CMD_NAV_WAYPOINT, 0);
        nowhere.latitude = std::numeric_limits<double>::quiet_NaN();
        MissionItem local = at(3, mavlink::MAV_CMD_NAV_WAYPOINT, 50);
        local.frame = mavlink::MAV_FRAME_LOCAL_NED;
        const auto made = route({at(1, mavlink::MAV_CMD_NAV_LOITER_TURNS, 10, {nan, nan, nan}), nowhere, local,
                                 order(4, mavlink::MAV_CMD_DO_JUMP, {nan, nan}),
                                 order(5, mavlink::MAV_CMD_DO_JUMP, {huge, huge})});
        for (const RouteStop &stop : made.stops)
            QVERIFY(qAbs(stop.at.y() - 10) < 1e-3); // executed where the vehicle is
        QCOMPARE(made.stops[0].radius, 0.0);
    }

    /// A route that the vehicle may no longer have is labelled, and its legs are broken.
    void outdatedRouteIsMarked()
    {
        const auto pictureOf = [](bool outdated) {
            QImage picture(200, 200, QImage::Format_RGB32);
            picture.fill(Qt::white);
            QPainter painter(&picture);
            MapViewport viewport;
            viewport.setSize({200, 200});
            viewport.setCentre(kOrigin);
            QPalette palette;
            palette.setColor(QPalette::Base, Qt::white);
            MissionPainter(painter, viewport, palette)
                .paint(route({at(1, mavlink::MAV_CMD_NAV_WAYPOINT, -40), at(2, mavlink::MAV_CMD_NAV_WAYPOINT, 40)}), -1,
                       outdated);
            painter.end();
            return picture;
        };
        const auto inkOf = [](const QImage &picture, const QRect &place) {
            int out = 0;
            for (int y = place.top(); y <= place.bottom(); ++y)
                for (int x = place.left(); x <= place.right(); ++x)
                    out += picture.pixelColor(x, y) != QColor(Qt::white);
            return out;
        };
        const QImage present = pictureOf(false), outdated = pictureOf(true);
        const QRect leg(99, 70, 2, 60);
        QVERIFY(inkOf(outdated, leg) > 0 && inkOf(outdated, leg) < inkOf(present, leg));
        QVERIFY(inkOf(outdated, outdated.rect()) > inkOf(present, present.rect())); // the label
    }

    /// Between two stops whose commands were not joined before, there is ink.
    void loiterIsJoinedOnThePicture()
    {
        QImage picture(200, 200, QImage::Format_RGB32);
        picture.fill(Qt::white);
        QPainter painter(&picture);
        MapViewport viewport;
        viewport.setSize({200, 200});
        viewport.setCentre(kOrigin); // 0.5 m per pixel
        QPalette palette;
        palette.setColor(QPalette::Base, Qt::white);
        MissionPainter(painter, viewport, palette)
            .paint(route({at(1, mavlink::MAV_CMD_NAV_WAYPOINT, -40), at(2, mavlink::MAV_CMD_NAV_LOITER_TURNS, 40, {1, 0, 5})}),
                   1, false);
        painter.end();
        int inked = 0;
        for (int y = 60; y < 140; ++y) // the legs' middle
            inked += picture.pixelColor(100, y) != Qt::white || picture.pixelColor(99, y) != Qt::white;
        QVERIFY2(inked > 70, qPrintable(QString::number(inked)));
    }
};

SKYSEAL_TEST_WIDGETS(MissionRouteTest)
#include "mission_route_test.moc"
