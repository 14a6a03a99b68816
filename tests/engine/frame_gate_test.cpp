// Which frames the station accepts by their origin, and how refusals become events.
#include "core/engine/station/frame_gate.h"

#include "core/mavlink/messages.h"
#include "tests/support/clear_frames.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;
using Verdict = FrameGate::Verdict;

namespace {

constexpr channel::SessionId kGateSession{1};
const Path kAgent{LinkId{1}, {{1}, 1000}}, kElsewhere{LinkId{2}, {{9}, 9}};
constexpr TimePoint kStart{std::chrono::seconds(100)};

channel::Peer peer(std::uint8_t number, std::vector<std::uint8_t> systemIds = {})
{
    channel::Peer out;
    out.key[0] = number;
    out.name = "peer-" + std::to_string(number);
    out.systemIds = std::move(systemIds);
    return out;
}

channel::SessionUp upOf(const channel::Peer &who)
{
    return {kGateSession, who.key, who.name, crypto::SuiteId::ChaCha20Poly1305, kAgent};
}

/// Keeps what is published.
struct PublishedFrames
{
    Notify notify = [this](Event event) { events.push_back(std::move(event)); };
    std::vector<Event> events;
};

} // namespace

class FrameGateTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clearFrameByItsOrigin();
    void vehicleAwaitsApprovalAndIsAnnouncedOnce();
    void oneEventASecond();
    void refusalIsNamedThoughItsSessionEnded();
    void olderFramesAreNotPresent();
    void otherSystemsAreNoForgery();
    void otherSystemsAreSaidOnce();
};

/// A ground station, a radio and a gimbal behind the agent of vehicle 7: authentic, and of nobody.
void FrameGateTest::otherSystemsAreNoForgery()
{
    FrameGate gate(SecureMode::Preferred);
    PublishedFrames published;
    gate.policy().setPeers({peer(1, {7}), peer(2, {8}), peer(3)});
    gate.sessionUp(upOf(peer(1, {7})));
    for (const std::uint8_t other : {255, 51, 71}) {
        QVERIFY(!gate.acceptSealed(kGateSession, other));
        QVERIFY(!gate.refuseSealed(kStart, kGateSession, other, false));
    }
    gate.publishRefusals(kStart + std::chrono::minutes(1), published.notify);
    QCOMPARE(published.events.size(), std::size_t(1));
    const auto &heard = std::get<OtherSystemsHeard>(published.events[0]);
    QCOMPARE(heard.peer, std::string("peer-1"));
    QCOMPARE(heard.systems, (std::vector<std::uint8_t>{51, 71, 255}));
    QVERIFY(heard.vehicles.empty());
    QCOMPARE(gate.refusals().systemFrames(), std::uint64_t(0));
    QCOMPARE(gate.otherSystems().frames(), std::uint64_t(3));
    // The vehicle of another agent among them is an impersonation.
    QVERIFY(gate.refuseSealed(kStart, kGateSession, 8, true));
    QCOMPARE(gate.refusals().systemFrames(), std::uint64_t(1));
    QCOMPARE(gate.otherSystems().frames(), std::uint64_t(3));
}

void FrameGateTest::otherSystemsAreSaidOnce()
{
    FrameGate gate(SecureMode::Preferred);
    PublishedFrames published;
    gate.policy().setPeers({peer(1, {7})});
    gate.sessionUp(upOf(peer(1, {7})));
    const auto second = [&](int number, std::initializer_list<std::uint8_t> systems, bool isVehicle = false) {
        const TimePoint now = kStart + std::chrono::seconds(number);
        for (const std::uint8_t other : systems)
            gate.refuseSealed(now, kGateSession, other, isVehicle);
        gate.publishRefusals(now, published.notify);
    };
    second(0, {255});
    for (int number = 1; number < 100; ++number)
        second(number, {255, 51});
    QCOMPARE(published.events.size(), std::size_t(1));
    QCOMPARE(std::get<OtherSystemsHeard>(published.events[0]).systems, (std::vector<std::uint8_t>{51, 255}));
    gate.sessionDown(kGateSession);
    gate.sessionUp(upOf(peer(1, {7})));
    for (int number = 100; number < 110; ++number)
        second(number, {255, 51}); // of the same agent
    QCOMPARE(published.events.size(), std::size_t(1));
    for (int number = 110; number < 120; ++number)
        second(number, {9}, true);
    QCOMPARE(published.events.size(), std::size_t(2));
    QCOMPARE(std::get<OtherSystemsHeard>(published.events[1]).vehicles, std::vector<std::uint8_t>{9});
}

void FrameGateTest::olderFramesAreNotPresent()
{
    FrameGate gate(SecureMode::Preferred);
    gate.policy().setPeers({peer(1)});
    gate.sessionUp(upOf(peer(1)));
    const auto isPresent = [&gate](const auto &message, std::uint64_t position, channel::Freshness freshness = {}) {
        const QByteArray bytes = frameOf(message, 1);
        channel::Delivery delivery;
        delivery.session = kGateSession;
        delivery.position = channel::RecordPosition{position};
        delivery.freshness = freshness;
        return gate.isPresent(*mavlink::readFrame(viewOf(bytes), mavlink::Dialect::builtin()), delivery);
    };
    const mavlink::Heartbeat heartbeat;
    const mavlink::CommandAck answer;
    QVERIFY(isPresent(heartbeat, 7));
    QVERIFY(isPresent(heartbeat, 7)); // two in one record
    QVERIFY(!isPresent(heartbeat, 5));
    QVERIFY(isPresent(answer, 6)); // overtaken, but the newest of its kind
    QVERIFY(!isPresent(answer, 9, channel::Freshness::Overtaken));
    QVERIFY(isPresent(heartbeat, 8));
    gate.sessionDown(kGateSession); // the records of another session count from 0
    gate.sessionUp(upOf(peer(1)));
    QVERIFY(isPresent(heartbeat, 0));
}

void FrameGateTest::clearFrameByItsOrigin()
{
    FrameGate gate(SecureMode::Preferred);
    gate.policy().setPeers({peer(1)}); // never heard, so any plain vehicle may impersonate it
    QCOMPARE(int(gate.judgeClear(kElsewhere, 5, FrameOrigin::Live, false)), int(Verdict::AwaitApproval));
    QCOMPARE(int(gate.judgeClear(kElsewhere, 5, FrameOrigin::ListenOnly, false)), int(Verdict::Accept));
    QCOMPARE(int(gate.judgeClear(kElsewhere, 5, FrameOrigin::Recording, false)), int(Verdict::Accept));
    gate.sessionUp(upOf(peer(1)));
    QVERIFY(gate.acceptSealed(kGateSession, 5));
    for (const FrameOrigin origin : {FrameOrigin::Live, FrameOrigin::ListenOnly, FrameOrigin::Recording})
        QCOMPARE(int(gate.judgeClear(kElsewhere, 5, origin, true)), int(Verdict::Refuse));
    gate.sessionDown(kGateSession);
    QCOMPARE(int(gate.judgeClear(kElsewhere, 5, FrameOrigin::Recording, true)), int(Verdict::Refuse));
    QCOMPARE(int(gate.judgeClear(kElsewhere, 5, FrameOrigin::Recording, false)), int(Verdict::Accept));
    QCOMPARE(int(gate.judgeClear(kElsewhere, 6, FrameOrigin::Live, false)), int(Verdict::Accept)); // all agents have been heard
}

void FrameGateTest::vehicleAwaitsApprovalAndIsAnnouncedOnce()
{
    FrameGate gate(SecureMode::Preferred);
    gate.policy().setPeers({peer(1)});
    QVERIFY(!gate.awaitApproval(kStart, kElsewhere, 5, false));
    const auto event = gate.awaitApproval(kStart, kElsewhere, 5, true);
    QVERIFY(event);
    QCOMPARE(event->mayBe, std::string("peer-1"));
    QVERIFY(!gate.awaitApproval(kStart, kElsewhere, 5, true));
    QCOMPARE(gate.pending().frames(), std::uint64_t(3));
    QCOMPARE(gate.refusals().plaintextFrames(), std::uint64_t(0));
    gate.allowPlaintext(5);
    QVERIFY(gate.pending().all("").empty());
    QCOMPARE(int(gate.judgeClear(kElsewhere, 5, FrameOrigin::Live, false)), int(Verdict::Accept));
}

void FrameGateTest::oneEventASecond()
{
    FrameGate gate(SecureMode::Required);
    PublishedFrames published;
    for (int i = 0; i < 10; ++i) {
        gate.refuseClear(kElsewhere, static_cast<std::uint8_t>(i));
        gate.publishRefusals(kStart + i * std::chrono::milliseconds(90), published.notify);
    }
    QCOMPARE(published.events.size(), std::size_t(1));
    gate.publishRefusals(kStart + std::chrono::seconds(1), published.notify);
    QCOMPARE(published.events.size(), std::size_t(2));
    const auto &rest = std::get<PlaintextRefused>(published.events[1]);
    QCOMPARE(rest.frames, std::uint64_t(9));
    QCOMPARE(int(rest.systemId), 9);
    gate.publishRefusals(kStart + std::chrono::seconds(5), published.notify);
    QCOMPARE(published.events.size(), std::size_t(2)); // nothing was refused since
    QCOMPARE(gate.refusals().plaintextFrames(), std::uint64_t(10));
}

void FrameGateTest::refusalIsNamedThoughItsSessionEnded()
{
    FrameGate gate(SecureMode::Required);
    PublishedFrames published;
    gate.policy().setPeers({peer(1, {7}), peer(2, {8, 9})});
    gate.sessionUp(upOf(peer(1, {7})));
    QVERIFY(!gate.acceptSealed(kGateSession, 9));
    QVERIFY(gate.refuseSealed(kStart, kGateSession, 9, false));
    gate.publishRefusals(kStart, published.notify);
    QVERIFY(!gate.acceptSealed(kGateSession, 8));
    QVERIFY(gate.refuseSealed(kStart, kGateSession, 8, false)); // within the second, so it waits
    gate.publishRefusals(kStart, published.notify);
    gate.sessionDown(kGateSession);
    gate.publishRefusals(kStart + std::chrono::seconds(1), published.notify);
    QCOMPARE(published.events.size(), std::size_t(2));
    const auto &first = std::get<SystemRefused>(published.events[0]), &second = std::get<SystemRefused>(published.events[1]);
    QCOMPARE(first.peer, std::string("peer-1"));
    QCOMPARE(first.owner, std::string("peer-2"));
    QCOMPARE(second.peer, std::string("peer-1"));
    QCOMPARE(second.owner, std::string("peer-2"));
    QCOMPARE(gate.refusals().systemFrames(), std::uint64_t(2));
}

SKYSEAL_TEST(FrameGateTest)
#include "frame_gate_test.moc"
