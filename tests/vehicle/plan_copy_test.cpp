// Lists that another station changes: what shows it, and that nothing is written over them unasked.
#include "core/vehicle/mission_client.h"
#include "mission_peers.h"
#include "tests/support/test_runner.h"

#include <functional>

using namespace skyseal;
using namespace skyseal::vehicle;

using Say = std::function<void(Harness &)>;
Q_DECLARE_METATYPE(Say)

class PlanCopyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anotherIdIsAnotherList_data();
    void anotherIdIsAnotherList();
    void ownUploadHasAnIdOfItsOwn();
    void idThatOnlyMissionCurrentNamesIsTaken();
    void countOfAMissionWithoutIds_data();
    void countOfAMissionWithoutIds();
    void whatTheVehicleSaysToAnotherStation_data();
    void whatTheVehicleSaysToAnotherStation();
    void stationWithTheSameIds();
    void lateMessageIsNoChange();
    void changedListIsNotOverwrittenUnasked_data();
    void changedListIsNotOverwrittenUnasked();
    void editedListIsSentOnlyOverItsBasis_data();
    void editedListIsSentOnlyOverItsBasis();
    void editedListOfAWatchedVehicleIsSentAtOnce();
    void ownFailureDoesNotForbidAnotherAttempt();
};

namespace {

const Reason kChanged = "changed by another station";

std::vector<mavlink::MissionItemInt> itemsAboard(std::uint16_t count)
{
    std::vector<mavlink::MissionItemInt> out(count);
    for (std::uint16_t i = 0; i < count; ++i) {
        out[i] = toUs<mavlink::MissionItemInt>(i);
        out[i].command = mavlink::MAV_CMD_NAV_WAYPOINT;
        out[i].frame = mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT;
        out[i].autocontinue = 1;
        out[i].x = 480000000 + i;
        out[i].y = 110000000;
        out[i].z = 20;
        out[i].param1 = std::nanf("");
    }
    return out;
}

/// Answers a read that was requested.
void answerRead(Harness &h, std::vector<mavlink::MissionItemInt> items, std::uint32_t id = 0,
                std::uint8_t type = mavlink::MAV_MISSION_TYPE_MISSION)
{
    auto count = toUs<mavlink::MissionCount>(static_cast<std::uint16_t>(items.size()));
    count.opaque_id = id;
    count.mission_type = type;
    h.feed(count);
    for (mavlink::MissionItemInt &item : items) {
        item.mission_type = type;
        h.feed(item);
    }
}

void read(Harness &h, const std::vector<mavlink::MissionItemInt> &items, std::uint32_t id = 0,
          MissionType type = MissionType::Mission)
{
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{type});
    answerRead(h, items, id, static_cast<std::uint8_t>(type));
    QVERIFY(h.poll<MissionResult>()->ok);
    h.sent();
}

/// What the vehicle streams. `total` of a mission.
void current(Harness &h, std::uint16_t total, std::uint32_t missionId, std::uint32_t fenceId = 0, std::uint32_t rallyId = 0)
{
    mavlink::MissionCurrent m;
    m.total = total;
    m.mission_state = mavlink::MISSION_STATE_NOT_STARTED;
    m.mission_id = missionId;
    m.fence_id = fenceId;
    m.rally_points_id = rallyId;
    h.now += std::chrono::seconds(1);
    h.feed(m);
}

template<typename Message> Message toAnother(Message message)
{
    message.target_system = 254;
    message.target_component = 190;
    return message;
}

const Reason &outdated(const Harness &h, MissionType type = MissionType::Mission)
{
    return h.vehicle.outdated(type);
}

/// Uploads what is requested, one item, to its end.
void serveUpload(Harness &h, std::uint32_t id)
{
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    auto accepted = acknowledgement(mavlink::MAV_MISSION_ACCEPTED);
    accepted.opaque_id = id;
    h.feed(accepted);
    QVERIFY(h.poll<MissionResult>()->ok);
    h.sent();
}

} // namespace

void PlanCopyTest::anotherIdIsAnotherList_data()
{
    QTest::addColumn<int>("type");
    QTest::newRow("mission") << int(MissionType::Mission);
    QTest::newRow("fence") << int(MissionType::Fence);
    QTest::newRow("rally points") << int(MissionType::Rally);
}

void PlanCopyTest::anotherIdIsAnotherList()
{
    QFETCH(int, type);
    const auto changed = static_cast<MissionType>(type);
    Harness h = Harness::px4();
    for (const MissionType each : {MissionType::Mission, MissionType::Fence, MissionType::Rally})
        read(h, itemsAboard(3), 10 + static_cast<std::uint32_t>(each), each);
    const auto stream = [&](std::uint32_t id) {
        std::uint32_t ids[] = {10, 11, 12};
        ids[type] = id;
        current(h, ids[0] == 0 ? 0 : 3, ids[0], ids[1], ids[2]);
    };
    stream(10 + static_cast<std::uint32_t>(type));
    for (const MissionType each : {MissionType::Mission, MissionType::Fence, MissionType::Rally})
        QVERIFY(outdated(h, each).empty());
    for (const std::uint32_t other : {99u, 0u}) { // another list, and none
        stream(other);
        for (const MissionType each : {MissionType::Mission, MissionType::Fence, MissionType::Rally})
            QCOMPARE(outdated(h, each).empty(), each != changed);
        QVERIFY(outdated(h, changed).text().starts_with(kChanged.text()));
        read(h, itemsAboard(other == 0 ? 0 : 3), other, changed);
        QVERIFY(outdated(h, changed).empty());
    }
    stream(0);
    QVERIFY(outdated(h, changed).empty());
    stream(7); // the first list since it was empty
    QVERIFY(outdated(h, changed).text().starts_with(kChanged.text()));
}

void PlanCopyTest::ownUploadHasAnIdOfItsOwn()
{
    Harness h = Harness::px4();
    read(h, itemsAboard(3), 10);
    current(h, 3, 10);
    h.vehicle.perform(h.now, RequestId{2}, WriteMission{{MissionItem{}}});
    current(h, 3, 10);
    serveUpload(h, 20);
    current(h, 3, 10); // was on its way
    QVERIFY(outdated(h).empty());
    for (int i = 0; i < 5; ++i)
        current(h, 1, 20);
    QVERIFY(outdated(h).empty());
    current(h, 1, 30);
    QVERIFY(outdated(h) == kChanged);
}

void PlanCopyTest::idThatOnlyMissionCurrentNamesIsTaken()
{
    Harness h = Harness::px4();
    read(h, itemsAboard(3));
    current(h, 3, 10);
    h.vehicle.perform(h.now, RequestId{2}, WriteMission{{MissionItem{}}});
    serveUpload(h, 0);
    current(h, 3, 10);
    for (int i = 0; i < 5; ++i)
        current(h, 1, 20);
    QVERIFY(outdated(h).empty());
    current(h, 1, 30);
    QVERIFY(outdated(h) == kChanged);
}

void PlanCopyTest::countOfAMissionWithoutIds_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("then");
    QTest::addColumn<int>("state");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("same") << 3 << 3 << 2 << QByteArray();
    QTest::newRow("longer") << 3 << 6 << 2 << QByteArray("changed by another station: 6 items instead of 3");
    QTest::newRow("shorter") << 3 << 1 << 2 << QByteArray("changed by another station: 1 items instead of 3");
    QTest::newRow("cleared") << 3 << 0 << 1 << QByteArray("changed by another station: 0 items instead of 3");
    QTest::newRow("before the first report") << 6 << 6 << 2 << QByteArray("changed by another station");
    QTest::newRow("old firmware") << 0 << 0 << 0 << QByteArray();
    QTest::newRow("home counted") << 4 << 4 << 2 << QByteArray();
}

void PlanCopyTest::countOfAMissionWithoutIds()
{
    QFETCH(int, first);
    QFETCH(int, then);
    QFETCH(int, state);
    QFETCH(QByteArray, reason);
    Harness h = Harness::copter();
    read(h, itemsAboard(4)); // of which one is home
    for (const int total : {first, then}) {
        mavlink::MissionCurrent m;
        m.total = static_cast<std::uint16_t>(total);
        m.mission_state = static_cast<std::uint8_t>(total == then ? state : 2);
        h.feed(m);
    }
    QCOMPARE(QByteArray::fromStdString(outdated(h).text()), reason);
}

void PlanCopyTest::whatTheVehicleSaysToAnotherStation_data()
{
    QTest::addColumn<Say>("say");
    QTest::addColumn<bool>("shows");
    const auto row = [](const char *name, bool shows, Say say) { QTest::newRow(name) << say << shows; };
    row("it has taken a list", true, [](Harness &h) { h.feed(toAnother(acknowledgement(mavlink::MAV_MISSION_ACCEPTED))); });
    row("it has taken the same list", false, [](Harness &h) {
        auto ack = acknowledgement(mavlink::MAV_MISSION_ACCEPTED);
        ack.opaque_id = 10;
        h.feed(toAnother(ack));
    });
    row("it refuses a list", false, [](Harness &h) { h.feed(toAnother(acknowledgement(mavlink::MAV_MISSION_DENIED))); });
    row("it has taken a fence", false, [](Harness &h) {
        auto ack = acknowledgement(mavlink::MAV_MISSION_ACCEPTED);
        ack.mission_type = mavlink::MAV_MISSION_TYPE_FENCE;
        h.feed(toAnother(ack));
    });
    row("it requests an item", true, [](Harness &h) { h.feed(toAnother(toUs<mavlink::MissionRequestInt>(0))); });
    row("it requests an item of floats", true, [](Harness &h) { h.feed(toAnother(toUs<mavlink::MissionRequest>(0))); });
    row("it has as many items", false, [](Harness &h) { h.feed(toAnother(toUs<mavlink::MissionCount>(3))); });
    row("it has more items", true, [](Harness &h) { h.feed(toAnother(toUs<mavlink::MissionCount>(4))); });
    row("it has as many items of another id", true, [](Harness &h) {
        auto count = toUs<mavlink::MissionCount>(3);
        count.opaque_id = 20;
        h.feed(toAnother(count));
    });
    row("it has the same item", false, [](Harness &h) { h.feed(toAnother(itemsAboard(3)[1])); });
    row("its home moved", false, [](Harness &h) {
        auto home = itemsAboard(3)[0];
        home.x += 5000;
        h.feed(toAnother(home));
    });
    row("it has another item", true, [](Harness &h) {
        auto item = itemsAboard(3)[1];
        item.param2 = 7;
        h.feed(toAnother(item));
    });
}

void PlanCopyTest::whatTheVehicleSaysToAnotherStation()
{
    QFETCH(Say, say);
    QFETCH(bool, shows);
    Harness h = Harness::copter();
    read(h, itemsAboard(3), 10);
    say(h);
    QCOMPARE(!outdated(h).empty(), shows);
    QVERIFY(outdated(h, MissionType::Rally).empty());
    read(h, itemsAboard(3), 10);
    QVERIFY(outdated(h).empty());
    // While it is read here: it may be partly the one and partly the other.
    h.vehicle.perform(h.now, RequestId{1}, ReadMission{});
    auto count = toUs<mavlink::MissionCount>(3);
    count.opaque_id = 10;
    h.feed(count);
    say(h);
    for (const auto &item : itemsAboard(3))
        h.feed(item);
    QVERIFY(h.poll<MissionResult>()->ok);
    QCOMPARE(!outdated(h).empty(), shows);
}

/// Most stations are 255/190. What the vehicle says soon after a transfer of this one may be about that.
void PlanCopyTest::stationWithTheSameIds()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{{MissionItem{}}});
    serveUpload(h, 0);
    h.feed(acknowledgement(mavlink::MAV_MISSION_ACCEPTED)); // once more
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    QVERIFY(outdated(h).empty());
    h.now += PlanCopy::kSettling;
    h.feed(acknowledgement(mavlink::MAV_MISSION_ACCEPTED));
    QVERIFY(outdated(h) == kChanged);
}

void PlanCopyTest::lateMessageIsNoChange()
{
    Harness h = Harness::px4();
    read(h, itemsAboard(3), 20);
    current(h, 3, 20);
    mavlink::MissionCurrent late;
    late.total = 2;
    late.mission_state = mavlink::MISSION_STATE_NOT_STARTED;
    late.mission_id = 10;
    h.vehicle.handleLateFrame(h.now, h.sender.frame(late));
    QVERIFY(outdated(h).empty());
}

void PlanCopyTest::changedListIsNotOverwrittenUnasked_data()
{
    QTest::addColumn<bool>("isRead");
    QTest::newRow("of which there is a copy") << true;
    QTest::newRow("that was never read") << false;
}

void PlanCopyTest::changedListIsNotOverwrittenUnasked()
{
    QFETCH(bool, isRead);
    Harness h = Harness::px4();
    if (isRead)
        read(h, itemsAboard(3), 10);
    current(h, 3, 10);
    current(h, 6, 20);
    h.sent();
    for (const Request &request : {Request(WriteMission{{MissionItem{}}}), Request(ClearMission{})}) {
        h.vehicle.perform(h.now, RequestId{2}, request);
        const auto refused = h.poll<MissionResult>();
        QVERIFY(refused && !refused->ok && !refused->changeUnanswered);
        QCOMPARE(refused->reason.text(),
                 std::string("nothing was sent: what the vehicle has was changed by another station: 6 items instead of 3; "
                             "read it again, or overwrite it"));
        QVERIFY(h.sent().empty());
    }
    h.vehicle.perform(h.now, RequestId{3}, WriteMission{.items = {MissionItem{}}, .overwrite = true});
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
    serveUpload(h, 30);
    QVERIFY(outdated(h).empty());
    h.vehicle.perform(h.now, RequestId{4}, ClearMission{});
    QCOMPARE(h.sentOf<mavlink::MissionClearAll>().size(), std::size_t(1));
}

void PlanCopyTest::editedListIsSentOnlyOverItsBasis_data()
{
    QTest::addColumn<bool>("isSent"); // the copy: by this station; otherwise it was read
    QTest::addColumn<int>("change");
    QTest::addColumn<bool>("isTaken");
    QTest::newRow("read, unchanged") << false << 0 << true;
    QTest::newRow("sent, unchanged") << true << 0 << true;
    QTest::newRow("read, moved item") << false << 1 << false;
    QTest::newRow("sent, moved item") << true << 1 << false;
    QTest::newRow("read, another parameter") << false << 2 << false;
    QTest::newRow("sent, parameter rounded by the vehicle") << true << 2 << true;
    QTest::newRow("read, longer") << false << 3 << false;
    QTest::newRow("read, cleared") << false << 4 << false;
    QTest::newRow("read, home moved") << false << 5 << true;
}

/// Of ArduPilot, which names no ids, a change of an item is not seen in any other way.
void PlanCopyTest::editedListIsSentOnlyOverItsBasis()
{
    QFETCH(bool, isSent);
    QFETCH(int, change);
    QFETCH(bool, isTaken);
    Harness h = Harness::copter();
    auto aboard = itemsAboard(3);
    read(h, aboard);
    if (isSent) {
        h.vehicle.perform(h.now, RequestId{2}, WriteMission{*h.vehicle.mission()});
        for (std::uint16_t i = 0; i < 3; ++i)
            h.feed(toUs<mavlink::MissionRequestInt>(i));
        h.feed(acknowledgement(mavlink::MAV_MISSION_ACCEPTED));
        QVERIFY(h.poll<MissionResult>()->ok);
    }
    current(h, 2, 0);
    QVERIFY(outdated(h).empty());
    if (change == 1)
        aboard[1].x += 1000;
    else if (change == 2)
        aboard[2].param1 = 0;
    else if (change == 3)
        aboard = itemsAboard(4);
    else if (change == 4)
        aboard.clear();
    else if (change == 5)
        aboard[0].x += 1000;
    const MissionItems basis = h.vehicle.mission();
    auto edited = *basis;
    edited.push_back(edited.back());
    h.sent();
    h.vehicle.perform(h.now, RequestId{3}, WriteMission{.items = edited, .basis = basis});
    const auto asked = h.sent();
    QCOMPARE(asked.size(), std::size_t(1));
    QCOMPARE(asked[0].id, mavlink::MissionRequestList::kId);
    answerRead(h, aboard);
    const auto counts = h.sentOf<mavlink::MissionCount>();
    const auto result = h.poll<MissionResult>();
    if (isTaken) {
        QVERIFY(!result);
        QCOMPARE(counts.size(), std::size_t(1));
        QCOMPARE(counts[0].count, std::uint16_t(4));
        return;
    }
    QVERIFY(counts.empty());
    QVERIFY(result && !result->ok && result->transfer == MissionTransfer::Upload && !result->changeUnanswered);
    QCOMPARE(result->reason.text(),
             std::string("nothing was sent: the vehicle has other items than those that were edited: another station changed "
                         "them; they were read again"));
    QCOMPARE(h.vehicle.mission()->size(), aboard.size());
    QVERIFY(outdated(h).empty());
}

void PlanCopyTest::editedListOfAWatchedVehicleIsSentAtOnce()
{
    Harness h = Harness::px4();
    read(h, itemsAboard(3), 10);
    current(h, 3, 10);
    const WriteMission edited{.items = *h.vehicle.mission(), .basis = h.vehicle.mission()};
    h.vehicle.perform(h.now, RequestId{1}, edited);
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
    h.feed(acknowledgement(mavlink::MAV_MISSION_DENIED));
    QVERIFY(!h.poll<MissionResult>()->ok);
    QVERIFY(outdated(h).empty()); // refused before it began

    h.now += PlanCopy::kFresh + std::chrono::seconds(1); // not heard any more
    h.vehicle.perform(h.now, RequestId{2}, edited);
    QCOMPARE(h.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    answerRead(h, itemsAboard(3), 10);
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
}

void PlanCopyTest::ownFailureDoesNotForbidAnotherAttempt()
{
    Harness h = Harness::copter();
    read(h, itemsAboard(3));
    h.vehicle.perform(h.now, RequestId{1}, WriteMission{{MissionItem{}, MissionItem{}}});
    h.feed(toUs<mavlink::MissionRequestInt>(0));
    h.feed(acknowledgement(mavlink::MAV_MISSION_NO_SPACE));
    QVERIFY(!h.poll<MissionResult>()->ok);
    QCOMPARE(outdated(h).text(), std::string("a transfer to the vehicle was not completed"));
    h.sent();
    h.vehicle.perform(h.now, RequestId{2}, WriteMission{{MissionItem{}}});
    QCOMPARE(h.sentOf<mavlink::MissionCount>().size(), std::size_t(1));
    serveUpload(h, 0);
    QVERIFY(outdated(h).empty());
}

SKYSEAL_TEST_APPLESS(PlanCopyTest)
#include "plan_copy_test.moc"
