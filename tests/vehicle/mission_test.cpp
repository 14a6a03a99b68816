// Missions against a scripted autopilot, by hand and through a radio that drops.
#include "core/vehicle/mission_client.h"
#include "mission_peers.h"
#include "tests/support/test_runner.h"
#include "transfer_measure.h"

using namespace skyseal;
using namespace skyseal::vehicle;

Q_DECLARE_METATYPE(skyseal::vehicle::Request)

class MissionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void uploadAnswersAsItIsAsked();
    void oldFirmwareGetsFloatsUnlessItTakesIntegers();
    void refusalsAreWorded();
    void parametersFiveAndSixAreScaledByTheCommand_data();
    void parametersFiveAndSixAreScaledByTheCommand();
    void numbersThatTheProtocolCannotCarryAreRefused();
    void itemZeroOfArduPilotIsItsHome_data();
    void itemZeroOfArduPilotIsItsHome();
    void homeOfAMissionIsNoFence();
    void uploadStopsWhenNobodyAsks();
    void lostAcknowledgementBeginsAnew();
    void downloadAsksUntilItHasAll();
    void arduPilotIsAskedForSeveralAtATime();
    void downloadThatTheVehicleEndedBeginsAnew();
    void refusedRepetitionStandsForALostRequest();
    void requestThatCrossedItsItemIsNotAnswered();
    void fenceAndRallyPointsAreListsOfTheirOwn();
    void listsThatTheAutopilotDoesNotNameAreLeftAlone_data();
    void listsThatTheAutopilotDoesNotNameAreLeftAlone();
    void withoutCapabilitiesNothingIsSent();
    void firmwareWithoutIntegersIsAskedForFloats();
    void oneTransferAtATime();
    void otherKindsOfPlansAreNotOurs();
    void uploadAndDownloadThroughABadRadio_data();
    void uploadAndDownloadThroughABadRadio();
    void lossCostsLittleTime_data();
    void lossCostsLittleTime();
    void acceptanceBeforeTheLastItemIsNone();
    void outagesDuringTransfers_data();
    void outagesDuringTransfers();
    void px4IsReleasedFromTheTransferBefore();
    void persistentRefusalIsReported();
    void px4IsSentTheNextItemAsWell();
    void timeOutOfTheUploadBeforeIsNoRefusal();
};

namespace {

std::vector<MissionItem> plan(std::size_t count)
{
    std::vector<MissionItem> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        out[i].sequence = static_cast<std::uint16_t>(i);
        out[i].latitude = 48 + static_cast<double>(i) * 1e-4;
        out[i].longitude = 11 - static_cast<double>(i) * 1e-4;
        out[i].altitude = 10.f + static_cast<float>(i);
        out[i].parameters[0] = static_cast<float>(i % 7);
    }
    return out;
}

/// Whether the mission protocol has the message.
bool speaksOfLists(const OutMessage &message)
{
    return message.id == mavlink::MissionClearAll::kId || message.id == mavlink::MissionCount::kId
        || message.id == mavlink::MissionRequestList::kId;
}

/// Seconds of a transfer of 500 items over 25 ms each way.
double transferTime(bool isPx4, bool isUpload, MissionType type, double loss, unsigned seed)
{
    constexpr Duration kLimit = std::chrono::seconds(600);
    Harness h = isPx4 ? Harness::px4() : Harness::copter();
    const auto peer = missionPeer(isPx4);
    if (!isUpload)
        peer->fill(500);
    LossyLink link(h, *peer, loss, seed, std::chrono::milliseconds(25));
    const TimePoint begin = h.now;
    if (isUpload)
        h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(500), type});
    else
        h.vehicle.perform(h.now, RequestId{1}, ReadMission{type});
    std::optional<MissionResult> result;
    const bool ended = link.run(kLimit, [&] { return (result = h.poll<MissionResult>()).has_value(); });
    if (!ended || !result->ok || result->type != type)
        return seconds(kLimit);
    for (std::size_t i = 0; i < 500; ++i) {
        if (isUpload ? peer->stored[i].seq != i : std::llround(result->items->at(i).latitude * 1e7) != int(i))
            return seconds(kLimit);
    }
    return seconds(h.now - begin);
}

} // namespace

void MissionTest::uploadAnswersAsItIsAsked()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(3)});
    QCOMPARE(h.sentOf<mavlink::MissionCount>().at(0).count, std::uint16_t(3));
    for (const std::uint16_t sequence : {0, 1, 1, 2}) { // asked twice for one: answered twice
        h.feed(toUs<mavlink::MissionRequestInt>(sequence));
        const auto item = h.sentOf<mavlink::MissionItemInt>();
        QCOMPARE(item.size(), std::size_t(1));
        QCOMPARE(item[0].seq, sequence);
        QCOMPARE(item[0].x, 480000000 + sequence * 1000);
        QCOMPARE(item[0].command, std::uint16_t(16));
    }
    h.feed(toUs<mavlink::MissionRequestInt>(9)); // there is none
    QVERIFY(h.sent().empty());
    QVERIFY(!h.vehicle.mission());
    h.feed(acknowledgement(0));
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && result->ok);
    QCOMPARE(*h.vehicle.mission(), plan(3));
}

void MissionTest::oldFirmwareGetsFloatsUnlessItTakesIntegers()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(1)});
    h.feed(toUs<mavlink::MissionRequest>(0));
    const auto item = h.sentOf<mavlink::MissionItem>();
    QCOMPARE(item.size(), std::size_t(1));
    QCOMPARE(item[0].x, 48.f);
    mavlink::AutopilotVersion version;
    version.capabilities = 4; // MAV_PROTOCOL_CAPABILITY_MISSION_INT
    h.feed(version);
    h.feed(toUs<mavlink::MissionRequest>(0));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().size(), std::size_t(1)); // a metre more exact
}

void MissionTest::refusalsAreWorded()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(2)});
    h.feed(acknowledgement(0)); // of something before: nothing was sent yet
    QVERIFY(!h.poll<MissionResult>());
    h.feed(acknowledgement(4));
    auto result = h.poll<MissionResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->reason.text(), std::string("no space left on the vehicle"));
    auto bad = plan(2);
    bad[1].latitude = 95;
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{bad});
    QCOMPARE(h.poll<MissionResult>()->reason.text(), std::string("item 1 is not on the globe"));
}

void MissionTest::parametersFiveAndSixAreScaledByTheCommand_data()
{
    QTest::addColumn<int>("command");
    QTest::addColumn<int>("frame");
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("wire");
    constexpr int waypoint = mavlink::MAV_CMD_NAV_WAYPOINT, photo = mavlink::MAV_CMD_DO_DIGICAM_CONTROL;
    QTest::newRow("degrees") << waypoint << int(mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT) << 47.3977421 << 473977421;
    QTest::newRow("unknown command") << 60000 << int(mavlink::MAV_FRAME_GLOBAL) << 47.5 << 475000000;
    QTest::newRow("local") << waypoint << int(mavlink::MAV_FRAME_LOCAL_NED) << 50. << 500000;
    QTest::newRow("body") << waypoint << int(mavlink::MAV_FRAME_BODY_FRD) << -0.5 << -5000;
    QTest::newRow("photo") << photo << int(mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT) << 1. << 1;
    QTest::newRow("photo in the frame of commands") << photo << int(mavlink::MAV_FRAME_MISSION) << 1. << 1;
    QTest::newRow("flags of a gimbal") << int(mavlink::MAV_CMD_DO_GIMBAL_MANAGER_PITCHYAW) << int(mavlink::MAV_FRAME_GLOBAL)
                                       << 12. << 12;
    QTest::newRow("own command with plain numbers") << 60000 << int(mavlink::MAV_FRAME_MISSION) << 7. << 7;
    const double unused = std::nan("");
    for (const int frame : {0, 1, 2, 3})
        QTest::addRow("not used in frame %d", frame) << waypoint << frame << unused << 2147483647;
    QTest::newRow("not used by a photo") << photo << 3 << unused << 2147483647;
}

void MissionTest::parametersFiveAndSixAreScaledByTheCommand()
{
    QFETCH(int, command);
    QFETCH(int, frame);
    QFETCH(double, value);
    QFETCH(int, wire);
    const MissionItem item{
        .command = std::uint16_t(command), .frame = std::uint8_t(frame), .latitude = value, .longitude = value};
    Harness h = Harness::px4();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{{item}});
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    const auto sent = h.sentOf<mavlink::MissionItemInt>();
    QCOMPARE(sent.size(), std::size_t(1));
    QCOMPARE(sent[0].x, wire);
    QCOMPARE(sent[0].y, wire);
    h.feed(acknowledgement(0));
    QVERIFY(h.poll<MissionResult>()->ok);

    h.vehicle.perform(h.now, RequestId{2}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(1));
    mavlink::MissionItemInt back = sent[0];
    back.target_system = 255;
    back.target_component = 190;
    h.feed(back);
    const auto read = h.poll<MissionResult>();
    QVERIFY(read && read->ok);
    const MissionItem &again = read->items->at(0);
    if (std::isnan(value))
        QVERIFY(std::isnan(again.latitude) && std::isnan(again.longitude));
    else
        QVERIFY(again.latitude == value && again.longitude == value);
}

void MissionTest::numbersThatTheProtocolCannotCarryAreRefused()
{
    Harness h = Harness::px4();
    const auto refusal = [&](MissionItem item) {
        h.vehicle.perform(h.now, RequestId{1}, WriteMission{{plan(1)[0], item}});
        const auto result = h.poll<MissionResult>();
        return result ? result->reason.text() : std::string();
    };
    QCOMPARE(refusal({.command = mavlink::MAV_CMD_DO_SET_ACTUATOR, .latitude = 0.5}),
             std::string("item 1, DO_SET_ACTUATOR: the mission protocol carries parameters 5 and 6 of this command as whole "
                         "numbers only"));
    QCOMPARE(refusal({.frame = mavlink::MAV_FRAME_LOCAL_NED, .longitude = 3e5}),
             std::string("item 1, NAV_WAYPOINT: parameters 5 and 6 are too large for the mission protocol"));
    // Rounded, it would mean "not used".
    QVERIFY(refusal({.frame = mavlink::MAV_FRAME_LOCAL_NED, .longitude = 214748.36466}).starts_with("item 1, NAV_WAYPOINT: "));
    QVERIFY(h.sent().empty());
}

void MissionTest::itemZeroOfArduPilotIsItsHome_data()
{
    QTest::addColumn<bool>("isPx4");
    QTest::addColumn<int>("command");
    QTest::addColumn<int>("frame");
    QTest::addColumn<bool>("withoutHome");
    QTest::addColumn<int>("items");
    QTest::addColumn<QByteArray>("remark");
    constexpr int waypoint = mavlink::MAV_CMD_NAV_WAYPOINT, takeOff = mavlink::MAV_CMD_NAV_TAKEOFF;
    QTest::newRow("home") << false << waypoint << 0 << false << 2 << QByteArray();
    QTest::newRow("take-off") << false << takeOff << 3 << false << 3
                              << QByteArray("this vehicle keeps its home position as item 0, which the mission lacked: it was "
                                            "inserted, and the items moved up by one");
    QTest::newRow("file of PX4") << false << waypoint << 0 << true << 3
                                 << QByteArray(
                                        "this vehicle keeps its home position as item 0, which the mission lacked: it was "
                                        "inserted, and the items moved up by one");
    QTest::newRow("other waypoint") << false << waypoint << 3 << false << 2
                                    << QByteArray(
                                           "this vehicle keeps its home position as item 0, so that it does not fly to the "
                                           "first waypoint of the mission");
    QTest::newRow("take-off of PX4") << true << takeOff << 3 << false << 2 << QByteArray();
    QTest::newRow("home for PX4") << true << waypoint << 0 << false << 2
                                  << QByteArray(
                                         "item 0 looks like the home position of an ArduPilot mission: this vehicle flies "
                                         "to it as its first waypoint");
}

void MissionTest::itemZeroOfArduPilotIsItsHome()
{
    QFETCH(bool, isPx4);
    QFETCH(int, command);
    QFETCH(int, frame);
    QFETCH(bool, withoutHome);
    QFETCH(int, items);
    QFETCH(QByteArray, remark);
    Harness h = isPx4 ? Harness::px4() : Harness::copter();
    const MissionItem first{.command = std::uint16_t(command), .frame = std::uint8_t(frame), .current = true, .latitude = 47};
    const MissionItem jump{.command = mavlink::MAV_CMD_DO_JUMP, .parameters = {0, 2}};
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{.items = {first, jump}, .withoutHome = withoutHome});
    QCOMPARE(int(h.sentOf<mavlink::MissionCount>().at(0).count), items);
    for (int i = 0; i < items; ++i)
        h.feed(toUs<mavlink::MissionRequestInt>(static_cast<std::uint16_t>(i)));
    const auto sent = h.sentOf<mavlink::MissionItemInt>();
    QCOMPARE(int(sent.size()), items);
    QCOMPARE(int(sent[0].command), items == 3 ? int(mavlink::MAV_CMD_NAV_WAYPOINT) : command);
    QCOMPARE(int(sent[0].frame), items == 3 ? 0 : frame);
    QCOMPARE(int(sent.back().param1), items - 2); // the jump leads to the same item
    h.feed(acknowledgement(0));
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && result->ok);
    QCOMPARE(QByteArray::fromStdString(result->remark.text()), remark);
}

/// Mission Planner writes the home position as the first line of every file.
void MissionTest::homeOfAMissionIsNoFence()
{
    Harness h = Harness::copter();
    const MissionItem home{.command = mavlink::MAV_CMD_NAV_WAYPOINT, .frame = 0, .current = true, .latitude = 47};
    const MissionItem corner{.command = mavlink::MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION, .frame = 3, .latitude = 47.1};
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{{home, corner}, MissionType::Fence});
    QCOMPARE(h.sentOf<mavlink::MissionCount>().at(0).count, std::uint16_t(1));
    auto request = toUs<mavlink::MissionRequestInt>(0);
    request.mission_type = mavlink::MAV_MISSION_TYPE_FENCE;
    h.feed(request);
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().at(0).command, corner.command);
    auto refused = acknowledgement(mavlink::MAV_MISSION_UNSUPPORTED);
    refused.mission_type = mavlink::MAV_MISSION_TYPE_FENCE;
    h.feed(refused);
    // With the number in the file.
    QCOMPARE(h.poll<MissionResult>()->reason.text(),
             std::string("item 1, NAV_FENCE_POLYGON_VERTEX_INCLUSION: command not supported"));
    h.vehicle.perform(h.now, RequestId{2}, WriteMission{{home, corner}, MissionType::Fence});
    h.feed(request);
    refused.type = mavlink::MAV_MISSION_ACCEPTED;
    h.feed(refused);
    const auto accepted = h.poll<MissionResult>();
    QVERIFY(accepted && accepted->ok);
    h.vehicle.perform(h.now, RequestId{3}, WriteMission{{home}, MissionType::Rally});
    QCOMPARE(h.poll<MissionResult>()->reason.text(),
             std::string("the only item is the home position of a mission; to remove what the vehicle has, clear its list"));
    QCOMPARE(accepted->remark.text(),
             std::string("the first item is the home position of a mission, which has no place in a "
                         "list of this kind: it was left out"));
}

void MissionTest::uploadStopsWhenNobodyAsks()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(2)});
    h.runUntil(at(150));
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(8));
    QCOMPARE(h.poll<MissionResult>()->reason.text(), std::string("no answer to 8 attempts"));
}

void MissionTest::lostAcknowledgementBeginsAnew()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(1)});
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.sent();
    h.runUntil(at(103));
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.feed(acknowledgement(0));
    QVERIFY(h.poll<MissionResult>()->ok);
}

void MissionTest::downloadAsksUntilItHasAll()
{
    Harness h = Harness::px4();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.runUntil(at(100.5));
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.feed(toUs<mavlink::MissionCount>(2));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).seq, std::uint16_t(0));
    auto item = toUs<mavlink::MissionItemInt>(0);
    item.x = 481234567;
    h.feed(item);
    h.feed(item); // twice
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().size(), std::size_t(1));
    h.runUntil(at(101));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).seq, std::uint16_t(1));
    item.seq = 1;
    h.feed(item);
    QCOMPARE(h.sentOf<mavlink::MissionAck>().at(0).type, std::uint8_t(0));
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && result->ok);
    QCOMPARE(h.vehicle.mission()->size(), std::size_t(2));
    QCOMPARE(result->items, h.vehicle.mission());
    QVERIFY(std::abs(h.vehicle.mission()->at(0).latitude - 48.1234567) < 1e-9);

    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(0)); // an empty one is a mission, too
    QVERIFY(h.poll<MissionResult>()->ok);
    QVERIFY(h.vehicle.mission()->empty());
}

void MissionTest::arduPilotIsAskedForSeveralAtATime()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(100));
    QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().size(), RequestWindow::kFirst);
    h.feed(toUs<mavlink::MissionItemInt>(3)); // in any order
    h.feed(toUs<mavlink::MissionItemInt>(0));
    const auto state = h.vehicle.state(h.now);
    QCOMPARE(state.transfers.size(), std::size_t(1));
    QCOMPARE(state.transfers[0].done, std::uint64_t(2));
    QCOMPARE(state.transfers[0].total, std::uint64_t(100));
    h.feed(toUs<mavlink::MissionItemInt>(100)); // there is none
    h.runUntil(h.now + std::chrono::seconds(60));
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && !result->ok && !result->items);
    QCOMPARE(result->reason.text(), std::string("the vehicle does not send item 1"));
    QVERIFY(h.vehicle.state(h.now).transfers.empty());
}

void MissionTest::downloadThatTheVehicleEndedBeginsAnew()
{
    Harness h = Harness::px4();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(2));
    h.feed(toUs<mavlink::MissionItemInt>(0));
    h.sent();
    h.feed(acknowledgement(mavlink::MAV_MISSION_ERROR));
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    h.feed(toUs<mavlink::MissionCount>(1));
    h.feed(toUs<mavlink::MissionItemInt>(0));
    QVERIFY(h.poll<MissionResult>()->ok);
    QCOMPARE(h.vehicle.mission()->size(), std::size_t(1));
    h.vehicle.perform(h.now, RequestId{2}, ReadMission{});
    for (int i = 0; i < 10; ++i) {
        h.feed(toUs<mavlink::MissionCount>(2));
        h.feed(acknowledgement(mavlink::MAV_MISSION_ERROR));
    }
    QCOMPARE(h.poll<MissionResult>()->reason.text(), std::string("the vehicle reports an error"));
}

void MissionTest::refusedRepetitionStandsForALostRequest()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(10)});
    h.now += std::chrono::milliseconds(50);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.sent();
    h.feed(acknowledgement(mavlink::MAV_MISSION_INVALID_SEQUENCE)); // of something before: nothing was repeated yet
    QVERIFY(h.sent().empty());
    const auto again = h.nextSent<mavlink::MissionItemInt>(at(110));
    QVERIFY(again && again->second.seq == 0);
    QVERIFY(again->first < h.now + std::chrono::milliseconds(200)); // from the round trip, not from the vehicle's timer
    for (std::uint16_t next = 1; next <= MissionClient::kInferred; ++next) {
        h.feed(acknowledgement(mavlink::MAV_MISSION_INVALID_SEQUENCE));
        QCOMPARE(h.sentOf<mavlink::MissionItemInt>().at(0).seq, next);
        QCOMPARE(h.nextSent<mavlink::MissionItemInt>(at(120))->second.seq, next);
    }
    h.feed(acknowledgement(mavlink::MAV_MISSION_INVALID_SEQUENCE)); // the rest is for the vehicle to say
    QVERIFY(h.sentOf<mavlink::MissionItemInt>().empty());
    h.feed(toUs<mavlink::MissionRequestInt>(2));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().at(0).seq, std::uint16_t(2));
}

void MissionTest::requestThatCrossedItsItemIsNotAnswered()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(3)});
    h.now += std::chrono::milliseconds(50);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.now += std::chrono::milliseconds(10);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().size(), std::size_t(1));
    h.now += std::chrono::milliseconds(40);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().size(), std::size_t(1));
}

void MissionTest::fenceAndRallyPointsAreListsOfTheirOwn()
{
    for (const auto type : {MissionType::Fence, MissionType::Rally}) {
        const auto number = static_cast<std::uint8_t>(type);
        const auto typed = [number](auto message) {
            message.mission_type = number;
            return message;
        };
        Harness h = Harness::copter();
        h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(1), type});
        QCOMPARE(h.sentOf<mavlink::MissionCount>().at(0).mission_type, number);
        h.feed(toUs<mavlink::MissionRequestInt>(0)); // for the flight plan
        QVERIFY(h.sent().empty());
        h.feed(typed(toUs<mavlink::MissionRequestInt>(0)));
        QCOMPARE(h.sentOf<mavlink::MissionItemInt>().at(0).mission_type, number);
        h.feed(typed(acknowledgement(0)));
        QVERIFY(h.poll<MissionResult>()->ok);
        h.vehicle.perform(h.now, RequestId{2}, ReadMission{type});
        QCOMPARE(h.sentOf<mavlink::MissionRequestList>().at(0).mission_type, number);
        h.feed(typed(toUs<mavlink::MissionCount>(1)));
        QCOMPARE(h.sentOf<mavlink::MissionRequestInt>().at(0).mission_type, number);
        h.feed(typed(toUs<mavlink::MissionItemInt>(0)));
        QCOMPARE(h.sentOf<mavlink::MissionAck>().at(0).mission_type, number);
        const auto read = h.poll<MissionResult>();
        QVERIFY(read && read->ok && read->type == type);
        QCOMPARE(read->items->size(), std::size_t(1));
        const auto kept = [&h, type] { return type == MissionType::Fence ? h.vehicle.fence() : h.vehicle.rally(); };
        QCOMPARE(kept(), read->items);
        h.vehicle.perform(h.now, RequestId{3}, ClearMission{type});
        QCOMPARE(h.sentOf<mavlink::MissionClearAll>().at(0).mission_type, number);
        h.feed(typed(acknowledgement(0)));
        QVERIFY(h.poll<MissionResult>()->ok);
        QVERIFY(kept() && kept()->empty());
        QVERIFY(!h.vehicle.mission()); // the flight plan is not concerned
        QVERIFY(type == MissionType::Fence ? !h.vehicle.rally() : !h.vehicle.fence());
    }
}

void MissionTest::listsThatTheAutopilotDoesNotNameAreLeftAlone_data()
{
    QTest::addColumn<Request>("request");
    QTest::addColumn<bool>("isFence");
    for (const auto type : {MissionType::Fence, MissionType::Rally}) {
        const bool isFence = type == MissionType::Fence;
        const char *name = isFence ? "fence" : "rally points";
        QTest::addRow("clear %s", name) << Request(ClearMission{type}) << isFence;
        QTest::addRow("upload %s", name) << Request(WriteMission{plan(2), type}) << isFence;
        QTest::addRow("read %s", name) << Request(ReadMission{type}) << isFence;
    }
}

/// ArduCopter 3.6 does not read mission_type: to clear its fence would clear its mission.
void MissionTest::listsThatTheAutopilotDoesNotNameAreLeftAlone()
{
    QFETCH(Request, request);
    QFETCH(bool, isFence);
    constexpr std::uint64_t kFence = mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_FENCE;
    constexpr std::uint64_t kRally = mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_RALLY;
    for (const bool knownBefore : {true, false}) {
        Harness h({.streams = StreamProfile::Quiet});
        h.feed(heartbeat());
        const auto tell = [&](std::uint64_t capabilities) { h.feed(mavlink::AutopilotVersion{.capabilities = capabilities}); };
        if (knownBefore)
            tell(isFence ? kRally : kFence); // the other one
        h.sent();
        h.vehicle.perform(h.now, RequestId{1}, request);
        if (!knownBefore) {
            h.runUntil(h.now);
            const auto asked = h.sentOf<mavlink::CommandLong>();
            QCOMPARE(asked.size(), std::size_t(1));
            QCOMPARE(asked[0].param1, float(mavlink::AutopilotVersion::kId));
            QVERIFY(!h.poll<MissionResult>());
            tell(isFence ? kRally : kFence);
        }
        const auto refused = h.poll<MissionResult>();
        QVERIFY(refused && !refused->ok && !refused->changeUnanswered);
        QVERIFY(refused->reason.text().starts_with(
            "nothing was sent: the autopilot does not say that the mission protocol reaches its"));
        h.runUntil(h.now + std::chrono::seconds(20));
        QVERIFY(std::ranges::none_of(h.sent(), speaksOfLists));

        tell(isFence ? kFence : kRally);
        h.vehicle.perform(h.now, RequestId{2}, request);
        QCOMPARE(std::ranges::count_if(h.sent(), speaksOfLists), 1);
        QVERIFY(!h.poll<MissionResult>());
    }
}

void MissionTest::withoutCapabilitiesNothingIsSent()
{
    Harness h({.streams = StreamProfile::Quiet});
    h.feed(heartbeat());
    h.runUntil(at(160)); // no longer asked for by itself
    h.sent();
    h.vehicle.perform(h.now, RequestId{1}, ClearMission{MissionType::Rally});
    const TimePoint begin = h.now;
    int attempts[2] = {};
    while (const auto asked = h.nextSent<mavlink::CommandLong>(begin + MissionClient::kCapabilitiesTimeout))
        ++attempts[asked->second.command == mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES];
    QCOMPARE(attempts[0], 3); // MAV_CMD_REQUEST_MESSAGE
    QCOMPARE(attempts[1], 3);
    const auto refused = h.poll<MissionResult>();
    QVERIFY(refused && !refused->ok && !refused->changeUnanswered);
    QCOMPARE(refused->reason.text(),
             std::string("nothing was sent: the autopilot does not answer what it can do (AUTOPILOT_VERSION): it could take "
                         "this for its mission"));
    // It waits for an answer that comes late.
    h.vehicle.perform(h.now, RequestId{2}, ClearMission{MissionType::Rally});
    h.runUntil(h.now + std::chrono::seconds(9));
    h.sent();
    h.feed(mavlink::AutopilotVersion{.capabilities = mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_RALLY});
    QCOMPARE(h.sentOf<mavlink::MissionClearAll>().at(0).mission_type, std::uint8_t(mavlink::MAV_MISSION_TYPE_RALLY));
}

void MissionTest::firmwareWithoutIntegersIsAskedForFloats()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.feed(toUs<mavlink::MissionCount>(1));
    const auto asked = h.nextSent<mavlink::MissionRequest>(at(110));
    QVERIFY(asked);
    auto item = toUs<mavlink::MissionItem>(0);
    item.x = 48.5f;
    h.feed(item);
    QVERIFY(h.poll<MissionResult>()->ok);
    QCOMPARE(h.vehicle.mission()->at(0).latitude, 48.5);
}

void MissionTest::oneTransferAtATime()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.vehicle.perform(h.now, RequestId{2}, ClearMission{});
    const auto result = h.poll<MissionResult>();
    QVERIFY(result && !result->ok);
    QCOMPARE(result->id, RequestId{2});
    QCOMPARE(result->transfer, MissionTransfer::Clear);
    QCOMPARE(result->reason.text(), std::string("another mission transfer is under way"));
}

void MissionTest::otherKindsOfPlansAreNotOurs()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    h.sent();
    auto fence = toUs<mavlink::MissionCount>(5);
    fence.mission_type = 1;
    h.feed(fence);
    auto others = toUs<mavlink::MissionCount>(5);
    others.target_system = 254;
    h.feed(others);
    QVERIFY(h.sent().empty());
}

void MissionTest::uploadAndDownloadThroughABadRadio_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("seed");
    QTest::addColumn<bool>("isPx4");
    for (int seed = 1; seed <= 10; ++seed) {
        for (const double loss : {0.0, 0.05, 0.2}) {
            QTest::addRow("ArduPilot, loss %.2f, seed %d", loss, seed) << loss << seed << false;
            QTest::addRow("PX4, loss %.2f, seed %d", loss, seed) << loss << seed << true;
        }
    }
}

void MissionTest::uploadAndDownloadThroughABadRadio()
{
    QFETCH(double, loss);
    QFETCH(int, seed);
    QFETCH(bool, isPx4);
    Harness h = isPx4 ? Harness::px4() : Harness::copter();
    const auto peer = missionPeer(isPx4);
    LossyLink link(h, *peer, loss, static_cast<unsigned>(seed));
    std::optional<MissionResult> result;
    const auto ended = [&] { return (result = h.poll<MissionResult>()).has_value(); };

    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(50)});
    QVERIFY(link.run(std::chrono::seconds(180), ended));
    QVERIFY2(result->ok, result->reason.text().c_str());
    QCOMPARE(peer->stored.size(), std::size_t(50));
    QCOMPARE(peer->stored[49].x, 480049000);

    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    QVERIFY(link.run(std::chrono::seconds(180), ended));
    QVERIFY2(result->ok, result->reason.text().c_str());
    QCOMPARE(h.vehicle.mission()->size(), std::size_t(50));
    for (std::size_t i = 0; i < 50; ++i)
        QVERIFY(std::abs(h.vehicle.mission()->at(i).latitude - plan(50)[i].latitude) < 1e-9);

    h.vehicle.perform(h.now, RequestId{1}, ClearMission{});
    QVERIFY(link.run(std::chrono::seconds(60), ended));
    QVERIFY(result->ok && peer->stored.empty() && h.vehicle.mission()->empty());
}

void MissionTest::lossCostsLittleTime_data()
{
    QTest::addColumn<bool>("isPx4");
    QTest::addColumn<bool>("isUpload");
    QTest::addColumn<int>("type");
    QTest::addColumn<double>("most"); // seconds without loss
    const auto rows = [](const char *plan, MissionType type) {
        const auto row = [=](const char *transfer, bool isPx4, bool isUpload, double most) {
            QTest::addRow("%s, %s", plan, transfer) << isPx4 << isUpload << int(type) << most;
        };
        row("download from ArduPilot", false, false, 1.2);
        row("download from PX4, one at a time", true, false, 26);
        row("upload to ArduPilot", false, true, 26);
        row("upload to PX4", true, true, 26);
    };
    rows("mission", MissionType::Mission);
    rows("fence", MissionType::Fence);
    rows("rally points", MissionType::Rally);
}

void MissionTest::lossCostsLittleTime()
{
    QFETCH(bool, isPx4);
    QFETCH(bool, isUpload);
    QFETCH(int, type);
    QFETCH(double, most);
    const auto timeOf = [=](double loss, unsigned seed) {
        return transferTime(isPx4, isUpload, static_cast<MissionType>(type), loss, seed);
    };
    const double clean = timeOf(0, 1);
    QVERIFY2(clean < most, std::to_string(clean).c_str());
    verifyCostOfLoss(timeOf, clean);
}

void MissionTest::acceptanceBeforeTheLastItemIsNone()
{
    Harness h = Harness::px4();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(5)});
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.sent();
    h.feed(acknowledgement(mavlink::MAV_MISSION_ACCEPTED)); // of a repeated item, after the vehicle's time-out
    QVERIFY(!h.poll<MissionResult>());
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
    for (std::uint16_t sequence = 0; sequence < 5; ++sequence)
        h.feed(toUs<mavlink::MissionRequestInt>(sequence));
    h.feed(acknowledgement(mavlink::MAV_MISSION_ACCEPTED));
    QVERIFY(h.poll<MissionResult>()->ok);
}

void MissionTest::outagesDuringTransfers_data()
{
    QTest::addColumn<bool>("isPx4");
    QTest::addColumn<bool>("isUpload");
    QTest::addColumn<double>("length");
    for (const double length : {2., 5.5, 7., 8.5}) {
        for (const bool isPx4 : {false, true}) {
            for (const bool isUpload : {false, true})
                QTest::addRow("%s %s, %.1f s", isUpload ? "upload to" : "download from", isPx4 ? "PX4" : "ArduPilot", length)
                    << isPx4 << isUpload << length;
        }
    }
}

/// The link is down in the middle of a transfer, at several places of the exchange, in both directions or in one.
void MissionTest::outagesDuringTransfers()
{
    QFETCH(bool, isPx4);
    QFETCH(bool, isUpload);
    QFETCH(double, length);
    for (const auto direction : {LossyLink::Direction::Both, LossyLink::Direction::Up, LossyLink::Direction::Down}) {
        for (int start = 0; start < 12; ++start) {
            Harness h = isPx4 ? Harness::px4() : Harness::copter();
            const auto peer = missionPeer(isPx4);
            if (!isUpload)
                peer->fill(100);
            LossyLink link(h, *peer, 0, 1);
            const TimePoint begin = h.now + std::chrono::milliseconds(100 + 7 * start);
            link.addOutage(begin, begin + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(length)),
                           direction);
            if (isUpload)
                h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(100)});
            else
                h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
            std::optional<MissionResult> result;
            QVERIFY(link.run(std::chrono::minutes(2), [&] { return (result = h.poll<MissionResult>()).has_value(); }));
            QVERIFY2(result->ok, result->reason.text().c_str());
            QCOMPARE(peer->stored.size(), std::size_t(100));
            QCOMPARE(result->items->size(), std::size_t(100));
            for (std::size_t i = 0; i < 100; ++i)
                QCOMPARE(std::llround(result->items->at(i).latitude * 1e7), std::int64_t(peer->stored[i].x));
        }
    }
}

void MissionTest::px4IsReleasedFromTheTransferBefore()
{
    Harness h = Harness::px4();
    Px4MissionPeer peer;
    peer.fill(3);
    LossyLink link(h, peer, 0, 1);
    std::optional<MissionResult> result;
    const auto ended = [&] { return (result = h.poll<MissionResult>()).has_value(); };
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    QVERIFY(link.run(std::chrono::seconds(10), ended));
    QVERIFY(result->ok);
    link.loseAllUnderWay(); // the acknowledgement of the last item is lost: the vehicle waits for 5 s
    const TimePoint begin = h.now;
    h.vehicle.perform(h.now, RequestId{2}, WriteMission{plan(4), MissionType::Fence});
    QVERIFY(link.run(std::chrono::seconds(30), ended));
    QVERIFY2(result->ok, result->reason.text().c_str());
    QVERIFY(h.now < begin + std::chrono::seconds(2));
    QCOMPARE(peer.stored.size(), std::size_t(4));
}

void MissionTest::persistentRefusalIsReported()
{
    Harness h = Harness::px4(); // which another station uses by another link
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(4)});
    for (int i = 0; i <= MissionClient::kReleases; ++i) {
        QVERIFY(!h.poll<MissionResult>());
        QVERIFY(!h.sentOf<mavlink::MissionCount>().empty());
        h.feed(acknowledgement(mavlink::MAV_MISSION_ERROR));
    }
    QCOMPARE(h.poll<MissionResult>()->reason.text(), std::string("the vehicle reports an error"));
    Harness copter = Harness::copter(); // ArduPilot has other reasons
    copter.vehicle.perform(copter.now, RequestId{1}, WriteMission{plan(4)});
    copter.feed(acknowledgement(mavlink::MAV_MISSION_ERROR));
    QVERIFY(!copter.poll<MissionResult>()->ok);
}

void MissionTest::px4IsSentTheNextItemAsWell()
{
    Harness h = Harness::px4();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(3)});
    h.now += std::chrono::milliseconds(50);
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.sent();
    const auto again = h.nextSent<mavlink::MissionItemInt>(at(110));
    QVERIFY(again && again->second.seq == 0);
    QVERIFY(again->first < h.now + std::chrono::milliseconds(200));
    const auto next = h.nextSent<mavlink::MissionItemInt>(h.now);
    QVERIFY(next && next->second.seq == 1);
}

void MissionTest::timeOutOfTheUploadBeforeIsNoRefusal()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{plan(3)});
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.sent();
    h.feed(acknowledgement(mavlink::MAV_MISSION_OPERATION_CANCELLED)); // of this upload: it begins again
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
    h.feed(acknowledgement(mavlink::MAV_MISSION_OPERATION_CANCELLED)); // of the one before
    QVERIFY(!h.poll<MissionResult>());
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    QCOMPARE(h.sentOf<mavlink::MissionItemInt>().size(), std::size_t(1));
}

SKYSEAL_TEST_APPLESS(MissionTest)
#include "mission_test.moc"
