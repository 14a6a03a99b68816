// Commands that name a place or an altitude, as ArduPilot and PX4 expect them: messages, frames and fallbacks.
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

constexpr std::uint8_t kTaken = mavlink::MAV_RESULT_ACCEPTED, kUnknownCommand = mavlink::MAV_RESULT_UNSUPPORTED;
constexpr std::uint32_t kGuided = mavlink::COPTER_MODE_GUIDED, kLoiter = mavlink::COPTER_MODE_LOITER;

/// At 20 m above the field, which lies at 584 m.
void flyOver(Harness &h)
{
    mavlink::GlobalPositionInt position;
    position.lat = -353632610;
    position.lon = 1491652300;
    position.alt = 604000;
    position.relative_alt = 20000;
    h.feed(position);
}

Harness copterIn(std::uint32_t mode)
{
    Harness h = Harness::copter(mode, true);
    flyOver(h);
    return h;
}

/// After it has refused DO_REPOSITION, as an unknown command.
Harness copterOnItsWayToGuided()
{
    Harness h = copterIn(kLoiter);
    h.vehicle.perform(h.now, RequestId{1}, GoTo{-35.3625, 149.1655, 25, true});
    h.sent();
    h.ack(mavlink::MAV_CMD_DO_REPOSITION, kUnknownCommand);
    const auto modes = h.sentOf<mavlink::SetMode>();
    if (modes.size() != 1 || modes[0].custom_mode != kGuided)
        qFatal("GUIDED is not requested");
    return h;
}

Harness px4OverHome()
{
    Harness h = Harness::px4();
    flyOver(h);
    return h;
}

} // namespace

class PlaceCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void goToEntersGuidedWhenAllowed()
    {
        Harness h = copterIn(kLoiter);
        h.vehicle.perform(h.now, RequestId{1}, GoTo{-35.3625, 149.1655, 25});
        QVERIFY(h.sentOf<mavlink::CommandInt>().empty());
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Refused);
        h.vehicle.perform(h.now, RequestId{2}, GoTo{-35.3625, 149.1655, 25, true});
        const auto sent = h.sentOf<mavlink::CommandInt>();
        QCOMPARE(sent.size(), std::size_t(1));
        QCOMPARE(sent[0].param2, float(mavlink::MAV_DO_REPOSITION_FLAGS_CHANGE_MODE));
        QCOMPARE(sent[0].frame, std::uint8_t(mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT));
        h.ack(mavlink::MAV_CMD_DO_REPOSITION, kTaken);
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    }

    /// ArduCopter before 4.1 does not know DO_REPOSITION, and ignores targets outside GUIDED.
    void olderCopterEntersGuidedBeforeItsTarget()
    {
        Harness h = copterOnItsWayToGuided();
        h.feed(heartbeat(kLoiter, true)); // still
        QVERIFY(h.sentOf<mavlink::SetPositionTargetGlobalInt>().empty());
        h.ack(mavlink::SetMode::kId, kTaken); // not a proof of the mode, nor of the target
        QVERIFY(!h.poll<CommandResult>());
        h.runUntil(h.now + std::chrono::seconds(1));
        QCOMPARE(h.sentOf<mavlink::SetMode>().size(), std::size_t(1)); // again
        h.feed(heartbeat(kGuided, true));
        const auto targets = h.sentOf<mavlink::SetPositionTargetGlobalInt>();
        QCOMPARE(targets.size(), std::size_t(1));
        QCOMPARE(targets[0].lat_int, -353625000);
        QCOMPARE(targets[0].alt, 25.f);
        mavlink::PositionTargetGlobalInt reported;
        reported.lat_int = targets[0].lat_int;
        reported.lon_int = targets[0].lon_int;
        h.feed(reported);
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    }

    void refusedModeEndsTheWayToATarget()
    {
        Harness h = copterOnItsWayToGuided();
        h.ack(mavlink::SetMode::kId, mavlink::MAV_RESULT_FAILED);
        h.runUntil(h.now + std::chrono::seconds(2)); // for a reason in words
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Refused);
        QVERIFY(h.sentOf<mavlink::SetPositionTargetGlobalInt>().empty());
    }

    void modeThatIsNotEnteredEndsTheWayToATarget()
    {
        Harness h = copterOnItsWayToGuided();
        h.runUntil(h.now + std::chrono::seconds(10));
        const auto result = h.poll<CommandResult>();
        QCOMPARE(result->outcome, CommandOutcome::TimedOut);
        QCOMPARE(result->reason, std::string("it needs the mode GUIDED, the vehicle stays in LOITER"));
        QVERIFY(h.sentOf<mavlink::SetPositionTargetGlobalInt>().empty());
    }

    /// The pilot's switch, or a failsafe.
    void anotherModeEndsTheWayToATarget()
    {
        for (const bool entered : {false, true}) {
            Harness h = copterOnItsWayToGuided();
            if (entered)
                h.feed(heartbeat(kGuided, true));
            h.feed(heartbeat(mavlink::COPTER_MODE_RTL, true));
            h.sent();
            QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Refused);
            h.runUntil(h.now + std::chrono::seconds(10));
            QVERIFY(h.sentOf<mavlink::SetMode>().empty() && h.sentOf<mavlink::SetPositionTargetGlobalInt>().empty());
        }
    }

    /// Nothing of the earlier command is sent again once the operator wants something else.
    void newerCommandEndsTheWayToAPlace_data()
    {
        QTest::addColumn<bool>("older");
        QTest::newRow("DO_REPOSITION on its way") << false;
        QTest::newRow("GUIDED on its way") << true;
    }

    void newerCommandEndsTheWayToAPlace()
    {
        QFETCH(bool, older);
        Harness h = copterIn(kLoiter);
        if (older)
            h = copterOnItsWayToGuided();
        else
            h.vehicle.perform(h.now, RequestId{2}, GoTo{-35.3625, 149.1655, 25, true});
        h.sent();
        h.vehicle.perform(h.now, RequestId{3}, ReturnToLaunch{});
        QCOMPARE(h.poll<CommandResult>()->reason, std::string("replaced by a newer command"));
        h.sent();
        h.ack(mavlink::MAV_CMD_DO_SET_MODE, kTaken);
        h.feed(heartbeat(mavlink::COPTER_MODE_RTL, true));
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
        h.runUntil(h.now + std::chrono::seconds(10));
        QVERIFY(h.sentOf<mavlink::CommandInt>().empty());
    }

    void altitudeChangesWhereTheCopterIs()
    {
        Harness h = copterIn(kGuided);
        h.vehicle.perform(h.now, RequestId{1}, ChangeAltitude{35});
        const auto sent = h.sentOf<mavlink::CommandInt>();
        QCOMPARE(sent.size(), std::size_t(1));
        QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_DO_REPOSITION));
        QCOMPARE(sent[0].x, -353632610);
        QCOMPARE(sent[0].y, 1491652300);
        QCOMPARE(sent[0].z, 35.f);
        h.ack(mavlink::MAV_CMD_DO_REPOSITION, kTaken);
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    }

    /// PX4 keeps its target for NaN, and takes altitudes above mean sea level.
    void altitudeChangesOnTheWayOfPx4()
    {
        Harness h = px4OverHome();
        h.vehicle.perform(h.now, RequestId{1}, ChangeAltitude{35});
        const auto sent = h.sentOf<mavlink::CommandLong>();
        QCOMPARE(sent.size(), std::size_t(1));
        QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_DO_REPOSITION));
        QVERIFY(std::isnan(sent[0].param4) && std::isnan(sent[0].param5) && std::isnan(sent[0].param6));
        QCOMPARE(sent[0].param7, 619.f);
    }

    /// A copter in LOITER would follow a throttle stick that is down.
    void pauseIsAMode()
    {
        Harness h = copterIn(kGuided);
        h.vehicle.perform(h.now, RequestId{1}, Loiter{});
        QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).param2, float(mavlink::COPTER_MODE_BRAKE));
        h.feed(heartbeat(mavlink::COPTER_MODE_BRAKE, true));
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);

        Harness plane;
        plane.feed(heartbeat(mavlink::PLANE_MODE_AUTO, true, mavlink::MAV_TYPE_FIXED_WING));
        plane.sent();
        plane.vehicle.perform(plane.now, RequestId{1}, Loiter{});
        QCOMPARE(plane.sentOf<mavlink::CommandLong>().at(0).param2, float(mavlink::PLANE_MODE_LOITER));

        Harness px4 = px4OverHome();
        px4.vehicle.perform(px4.now, RequestId{1}, Loiter{});
        const auto sent = px4.sentOf<mavlink::CommandLong>();
        QCOMPARE(sent.at(0).param2, 4.f); // AUTO
        QCOMPARE(sent.at(0).param3, 3.f); // LOITER
    }

    void pointsAtThePlaceOnTheGround()
    {
        Harness h = copterIn(kGuided);
        h.vehicle.perform(h.now, RequestId{1}, PointAt{-35.3625, 149.1655});
        auto sent = h.sentOf<mavlink::CommandInt>();
        QCOMPARE(sent.size(), std::size_t(1));
        QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_DO_SET_ROI_LOCATION));
        QCOMPARE(sent[0].frame, std::uint8_t(mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT));
        QCOMPARE(sent[0].x, -353625000);
        QCOMPARE(sent[0].y, 1491655000);
        QCOMPARE(sent[0].z, 0.f);
        h.ack(mavlink::MAV_CMD_DO_SET_ROI_LOCATION, kUnknownCommand); // older firmware
        sent = h.sentOf<mavlink::CommandInt>();
        QCOMPARE(sent.size(), std::size_t(1));
        QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_DO_SET_ROI));
        QCOMPARE(sent[0].x, -353625000);
        h.ack(mavlink::MAV_CMD_DO_SET_ROI, kTaken);
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);

        Harness px4 = px4OverHome();
        px4.vehicle.perform(px4.now, RequestId{1}, PointAt{-35.3625, 149.1655});
        sent = px4.sentOf<mavlink::CommandInt>();
        QCOMPARE(sent.at(0).frame, std::uint8_t(mavlink::MAV_FRAME_GLOBAL));
        QCOMPARE(sent.at(0).z, 584.f);
    }

    void pointingEnds()
    {
        Harness h = copterIn(kGuided);
        h.vehicle.perform(h.now, RequestId{1}, StopPointing{});
        QCOMPARE(h.sentOf<mavlink::CommandLong>().at(0).command, std::uint16_t(mavlink::MAV_CMD_DO_SET_ROI_NONE));
        h.ack(mavlink::MAV_CMD_DO_SET_ROI_NONE, kUnknownCommand);
        const auto sent = h.sentOf<mavlink::CommandLong>();
        QCOMPARE(sent.at(0).command, std::uint16_t(mavlink::MAV_CMD_DO_SET_ROI));
        QCOMPARE(sent.at(0).param5, 0.f);
        h.ack(mavlink::MAV_CMD_DO_SET_ROI, kTaken);
        QCOMPARE(h.poll<CommandResult>()->outcome, CommandOutcome::Accepted);
    }

    void homeMovesAtItsAltitude()
    {
        Harness h = copterIn(kGuided);
        h.vehicle.perform(h.now, RequestId{1}, SetHome{-35.3625, 149.1655});
        const auto sent = h.sentOf<mavlink::CommandInt>();
        QCOMPARE(sent.size(), std::size_t(1));
        QCOMPARE(sent[0].command, std::uint16_t(mavlink::MAV_CMD_DO_SET_HOME));
        QCOMPARE(sent[0].frame, std::uint8_t(mavlink::MAV_FRAME_GLOBAL));
        QCOMPARE(sent[0].param1, 0.f); // not the present place
        QCOMPARE(sent[0].x, -353625000);
        QCOMPARE(sent[0].z, 584.f);
    }

    void nothingIsSentWithoutWhatIsNeeded_data()
    {
        QTest::addColumn<bool>("px4");
        QTest::addColumn<int>("command");
        QTest::addColumn<QString>("reason");
        QTest::newRow("altitude") << false << 0 << QStringLiteral("changing the altitude needs a known position");
        QTest::newRow("altitude, PX4") << true << 0 << QStringLiteral("changing the altitude needs a known home altitude");
        QTest::newRow("home") << false << 1 << QStringLiteral("moving home needs a known home altitude");
        QTest::newRow("point, PX4") << true << 2 << QStringLiteral("pointing at a location needs a known home altitude");
        QTest::newRow("go, PX4") << true << 3 << QStringLiteral("going to a location needs a known home altitude");
        QTest::newRow("off the globe") << false << 4 << QStringLiteral("the location is not on the globe");
    }

    void nothingIsSentWithoutWhatIsNeeded()
    {
        QFETCH(bool, px4);
        QFETCH(int, command);
        QFETCH(QString, reason);
        Harness h = px4 ? Harness::px4() : Harness::copter(kGuided, true);
        const VehicleCommand commands[] = {ChangeAltitude{30}, SetHome{1, 2}, PointAt{1, 2}, GoTo{1, 2, 3}, SetHome{91, 2}};
        h.vehicle.perform(h.now, RequestId{1}, commands[command]);
        QVERIFY(h.sent().empty());
        QCOMPARE(QString::fromStdString(h.poll<CommandResult>()->reason.text()), QStringLiteral("nothing was sent: ") + reason);
    }

    void roversDoNotClimb()
    {
        Harness h;
        h.feed(heartbeat(mavlink::ROVER_MODE_GUIDED, true, mavlink::MAV_TYPE_GROUND_ROVER));
        h.vehicle.perform(h.now, RequestId{1}, ChangeAltitude{30});
        QCOMPARE(h.poll<CommandResult>()->reason.text(), std::string("nothing was sent: this kind of vehicle does not fly"));
    }
};

SKYSEAL_TEST_APPLESS(PlaceCommandTest)
#include "place_command_test.moc"
