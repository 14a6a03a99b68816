// MAVLink signing on the vehicle's side, in simulated time: the agent's part and the task that sets signing up, against a
// simulated vehicle that signs as ArduPilot does; devices without the key, and with old frames, beside it.
#include "core/crypto/system_random.h"
#include "core/engine/agent/signing_task.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/messages.h"
#include "core/sim/simulated_vehicle.h"
#include "tests/support/clear_frames.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;
using namespace std::chrono_literals;
using Finding = SigningOutcome::Finding;
using Kind = VehicleSignatures::Kind;

namespace {

Key32 keyOf(std::uint8_t first)
{
    Key32 key;
    key.mutableView()[0] = first;
    return key;
}

VehicleKey vehicleKey(std::uint8_t first)
{
    return {keyOf(first), nullptr};
}

mavlink::Heartbeat stationHeartbeat()
{
    return {.type = mavlink::MAV_TYPE_GCS, .autopilot = mavlink::MAV_AUTOPILOT_INVALID};
}

QByteArray armRequest(bool on = true)
{
    return frameOf(mavlink::CommandLong{.target_system = 1,
                                        .target_component = 1,
                                        .command = mavlink::MAV_CMD_COMPONENT_ARM_DISARM,
                                        .param1 = on ? 1.f : 0.f,
                                        .param2 = 21196},
                   255);
}

QByteArray bytesOf(ByteView frame)
{
    return QByteArray(reinterpret_cast<const char *>(frame.data()), static_cast<qsizetype>(frame.size()));
}

/// A vehicle, and the frames that it sent.
class Bus
{
public:
    Bus() : vehicle(sim::SimulatedVehicleConfig(), TimePoint()) { pass(2s); }

    void pass(Duration span)
    {
        const TimePoint end = now + span;
        while (now < end) {
            now += 20ms;
            vehicle.advance(now);
            collect();
        }
    }
    void deliver(ByteView frame)
    {
        if (const auto read = mavlink::readFrame(frame, mavlink::Dialect::builtin()))
            vehicle.handleFrame(now, *read);
        collect();
    }
    void deliver(const QByteArray &frame) { deliver(viewOf(frame)); }
    bool armed() const { return vehicle.autopilot().armed(); }
    void disarm() { vehicle.autopilot().arming().disarmNow(); }

    SigningOutcome run(SigningAction action, VehicleKey key)
    {
        const auto task = std::make_unique<SigningTask>(action, std::move(key), now);
        std::size_t taken = sent.size();
        while (!task->outcome()) {
            pass(20ms);
            for (; taken < sent.size(); ++taken)
                task->handleFrame(now, Path(), *mavlink::readFrame(viewOf(sent[taken]), mavlink::Dialect::builtin()));
            task->handleDeadline(now);
            while (const auto out = task->pollTransmit()) {
                if (losesEveryThird && ++m_lost % 3 == 1)
                    continue;
                deliver(out->bytes);
            }
        }
        return *task->outcome();
    }

    TimePoint now;
    sim::SimulatedVehicle vehicle;
    std::vector<QByteArray> sent;
    bool losesEveryThird = false; ///< of the frames to the vehicle

private:
    void collect()
    {
        for (ByteView frame = vehicle.pollFrame(); !frame.empty(); frame = vehicle.pollFrame())
            sent.push_back(bytesOf(frame));
    }

    int m_lost = 0;
};

/// The same with signing set up with key 1, and the part of an agent that has it.
class SignedBus : public Bus
{
public:
    explicit SignedBus(bool acceptUnsigned = false)
    {
        if (!run(SigningAction::SetUp, vehicleKey(1)).reached)
            qFatal("the vehicle does not sign");
        restartAgent(vehicleKey(1), acceptUnsigned);
    }
    void restartAgent(VehicleKey key, bool acceptUnsigned = false)
    {
        agent = std::make_unique<VehicleSigning>(std::move(key), acceptUnsigned);
        sent.clear();
    }
    /// Gives the agent what the vehicle sent, and the vehicle what the agent answers. Returns the number of accepted frames.
    std::size_t listen()
    {
        std::size_t accepted = 0;
        for (const QByteArray &frame : std::exchange(sent, {})) {
            if (agent->accept(viewOf(frame)))
                ++accepted;
            else if (const ByteView request = agent->catchUp(now, viewOf(frame)); !request.empty())
                deliver(request);
        }
        return accepted;
    }
    /// A frame of a station, which CommandGate admitted.
    void command(const QByteArray &frame) { deliver(agent->sign(viewOf(frame), true)); }

    std::unique_ptr<VehicleSigning> agent;
};

std::vector<Kind> kindsOf(const std::vector<VehicleSignatures> &reports)
{
    std::vector<Kind> out;
    for (const VehicleSignatures &report : reports)
        out.push_back(report.kind);
    return out;
}

} // namespace

class VehicleSigningTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void setUpCheckedAndRemoved();
    void setUpThroughLosses();
    void nothingIsChangedInFlight();
    void otherKeyIsNotReplaced();
    void wrongKeyIsSaid();
    void silentAndSeveralVehiclesGetNoKey();
    void signedStationCommands();
    void strangerOnTheVehiclesLinkCommandsNothing();
    void stationsOwnSignatureIsReplaced();
    void onlyTheVehiclesFramesPass();
    void radiosNeedNoSignature();
    void unsignedFramesPassOnRequestOnly();
    void repeatedFramesAreRefused();
    void agentStartsAgain();
    void vehicleStartsAgain();
    void vehicleThatLostItsTimeCatchesUp();
    void timeIsStoredAhead();
    void removedSigningIsSaid();
    void stationsDoNotChangeTheKey();
    void version1IsNotForwarded();
    void askersTakeNoPlaceOfPilots();
    void reportsAreFew();
    void keyFilesAreGuarded();
};

void VehicleSigningTest::setUpCheckedAndRemoved()
{
    Bus bus;
    QCOMPARE(bus.run(SigningAction::Check, vehicleKey(1)).finding, Finding::NotSigned);
    const SigningOutcome setUp = bus.run(SigningAction::SetUp, vehicleKey(1));
    QVERIFY(setUp.reached && setUp.finding == Finding::Works && !setUp.acceptsUnsigned);
    QCOMPARE(int(setUp.systemId), 1);
    QVERIFY(bus.run(SigningAction::SetUp, vehicleKey(1)).reached); // and once more
    QVERIFY(bus.run(SigningAction::Check, vehicleKey(1)).reached);
    bus.deliver(armRequest());
    QVERIFY(!bus.armed());
    const SigningOutcome removed = bus.run(SigningAction::Remove, vehicleKey(1));
    QVERIFY(removed.reached && removed.finding == Finding::NotSigned);
    bus.deliver(armRequest());
    QVERIFY(bus.armed());
}

void VehicleSigningTest::setUpThroughLosses()
{
    Bus bus;
    bus.losesEveryThird = true;
    QVERIFY(bus.run(SigningAction::SetUp, vehicleKey(1)).reached);
    QVERIFY(bus.run(SigningAction::Remove, vehicleKey(1)).reached);
}

void VehicleSigningTest::nothingIsChangedInFlight()
{
    Bus bus;
    bus.deliver(armRequest());
    QVERIFY(bus.armed());
    bus.pass(1s);
    QCOMPARE(bus.run(SigningAction::SetUp, vehicleKey(1)).finding, Finding::Armed);
    bus.disarm();
    bus.pass(1s);
    QVERIFY(bus.run(SigningAction::SetUp, vehicleKey(1)).reached);
}

void VehicleSigningTest::otherKeyIsNotReplaced()
{
    Bus bus;
    QVERIFY(bus.run(SigningAction::SetUp, vehicleKey(1)).reached);
    for (const SigningAction action : {SigningAction::SetUp, SigningAction::Check, SigningAction::Remove})
        QCOMPARE(bus.run(action, vehicleKey(2)).finding, Finding::OtherKey);
    QVERIFY(bus.run(SigningAction::Check, vehicleKey(1)).reached);
}

void VehicleSigningTest::wrongKeyIsSaid()
{
    SignedBus bus;
    bus.restartAgent(vehicleKey(2));
    bus.pass(1s);
    QCOMPARE(bus.listen(), std::size_t(0));
    QVERIFY(bus.agent->counters().wrong > 0);
    QCOMPARE(kindsOf(bus.agent->takeReports(bus.now)), std::vector{Kind::Wrong});
    bus.command(armRequest());
    QVERIFY(!bus.armed());
}

void VehicleSigningTest::silentAndSeveralVehiclesGetNoKey()
{
    SigningTask alone(SigningAction::SetUp, vehicleKey(1), TimePoint());
    alone.handleDeadline(TimePoint() + SigningTask::kListen);
    QVERIFY(alone.outcome() && alone.outcome()->finding == Finding::NoVehicle && !alone.pollTransmit());

    SigningTask several(SigningAction::SetUp, vehicleKey(1), TimePoint());
    for (const std::uint8_t system : {1, 2}) {
        const QByteArray heartbeat = frameOf(
            mavlink::Heartbeat{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA}, system,
            1);
        several.handleFrame(TimePoint(), Path(), *mavlink::readFrame(viewOf(heartbeat), mavlink::Dialect::builtin()));
    }
    several.handleDeadline(TimePoint() + SigningTask::kSettle);
    QVERIFY(several.outcome() && several.outcome()->finding == Finding::SeveralVehicles && !several.pollTransmit());
}

void VehicleSigningTest::signedStationCommands()
{
    SignedBus bus;
    bus.pass(1s);
    QVERIFY(bus.listen() > 0);
    bus.command(frameOf(stationHeartbeat(), 255));
    bus.command(armRequest());
    QVERIFY(bus.armed());
    QCOMPARE(bus.agent->counters().signedFrames, std::uint64_t(2));
    bus.pass(1s);
    const std::size_t sent = bus.sent.size();
    QCOMPARE(bus.listen(), sent);
}

/// With the very bytes that a station would send, and signed with another key.
void VehicleSigningTest::strangerOnTheVehiclesLinkCommandsNothing()
{
    SignedBus bus;
    bus.pass(1s);
    bus.listen();
    bus.deliver(armRequest());
    VehicleSigning stranger(vehicleKey(2), true);
    bus.deliver(stranger.sign(viewOf(armRequest()), true));
    // And what the agent signed, once more, after the pilot disarmed.
    const QByteArray recorded = bytesOf(bus.agent->sign(viewOf(armRequest()), true));
    QVERIFY(!bus.armed());
    bus.deliver(recorded);
    QVERIFY(bus.armed());
    bus.command(armRequest(false));
    QVERIFY(!bus.armed());
    bus.deliver(recorded);
    QVERIFY(!bus.armed());
}

void VehicleSigningTest::stationsOwnSignatureIsReplaced()
{
    SignedBus bus;
    bus.pass(1s);
    bus.listen();
    VehicleSigning station(vehicleKey(2), true);
    const QByteArray own = bytesOf(station.sign(viewOf(armRequest()), true));
    const QByteArray out = bytesOf(bus.agent->sign(viewOf(own), true));
    QCOMPARE(out.size(), own.size());
    QCOMPARE(out.chopped(qsizetype(mavlink::kSignatureLength)), own.chopped(qsizetype(mavlink::kSignatureLength)));
    QVERIFY(mavlink::signatureMatches(viewOf(out), keyOf(1)));
    bus.deliver(out);
    QVERIFY(bus.armed());
}

void VehicleSigningTest::onlyTheVehiclesFramesPass()
{
    SignedBus bus;
    bus.pass(1s);
    QVERIFY(bus.listen() > 0);
    const mavlink::Heartbeat vehicle{.type = mavlink::MAV_TYPE_QUADROTOR, .autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA};
    const QByteArray plain = frameOf(vehicle, 1, 1);
    VehicleSigning other(vehicleKey(2), true);
    QVERIFY(!bus.agent->accept(viewOf(plain)));
    QVERIFY(!bus.agent->accept(other.sign(viewOf(plain), true)));
    QCOMPARE(bus.agent->counters().unsignedRefused, std::uint64_t(1));
    QCOMPARE(bus.agent->counters().wrong, std::uint64_t(1));
    QVERIFY(bus.agent->catchUp(bus.now, viewOf(plain)).empty()); // no key, no answer
    bus.pass(1s);
    QByteArray changed = bus.sent.back();
    changed[12] = static_cast<char>(changed[12] ^ 1);
    QVERIFY(!bus.agent->accept(viewOf(changed)));
    QVERIFY(bus.agent->accept(viewOf(bus.sent.back())));
}

void VehicleSigningTest::radiosNeedNoSignature()
{
    SignedBus bus;
    QVERIFY(bus.agent->accept(viewOf(frameOf(mavlink::RadioStatus{.rssi = 100}, 51, 68))));
    VehicleSigning other(vehicleKey(2), true);
    const QByteArray wrong = bytesOf(other.sign(viewOf(frameOf(mavlink::RadioStatus{.rssi = 100}, 51, 68)), true));
    QVERIFY(!bus.agent->accept(viewOf(wrong)));
    QCOMPARE(bus.agent->counters().unsignedAccepted, std::uint64_t(1));
}

void VehicleSigningTest::unsignedFramesPassOnRequestOnly()
{
    SignedBus bus(true);
    const QByteArray camera = frameOf(mavlink::Heartbeat{.type = mavlink::MAV_TYPE_CAMERA}, 1, 100);
    QVERIFY(bus.agent->accept(viewOf(camera)));
    VehicleSigning other(vehicleKey(2), true);
    QVERIFY(!bus.agent->accept(other.sign(viewOf(camera), true)));
}

void VehicleSigningTest::repeatedFramesAreRefused()
{
    SignedBus bus;
    bus.pass(1s);
    const std::vector<QByteArray> recorded = bus.sent;
    QCOMPARE(bus.listen(), recorded.size());
    for (const QByteArray &frame : recorded)
        QVERIFY(!bus.agent->accept(viewOf(frame)));
    QCOMPARE(bus.agent->counters().old, std::uint64_t(recorded.size()));
    QCOMPARE(bus.agent->counters().verified, std::uint64_t(recorded.size()));
}

/// With its stored time and without; before the vehicle was heard again, and after.
void VehicleSigningTest::agentStartsAgain()
{
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("key.time")).toStdString();
    const auto stored = [&file] { return VehicleKey{keyOf(1), std::move(*keys::SigningTimeFile::open(file))}; };
    SignedBus bus;
    bus.restartAgent(stored());
    bus.pass(1s);
    bus.listen();
    bus.command(armRequest());
    QVERIFY(bus.armed());
    bus.agent.reset();
    bus.restartAgent(stored());
    bus.command(armRequest(false)); // at once
    QVERIFY(!bus.armed());
    bus.pass(1s);
    QVERIFY(bus.listen() > 0);
    QCOMPARE(bus.agent->counters().old, std::uint64_t(0));

    bus.restartAgent(vehicleKey(1)); // its time is lost
    bus.command(armRequest());
    QVERIFY(!bus.armed());
    bus.pass(1s);
    QVERIFY(bus.listen() > 0);
    bus.command(armRequest());
    QVERIFY(bus.armed());
}

void VehicleSigningTest::vehicleStartsAgain()
{
    SignedBus bus;
    for (int restarts = 0; restarts < 3; ++restarts) {
        bus.pass(40s); // it saves its time every 30 s
        QVERIFY(bus.listen() > 0);
        bus.command(frameOf(stationHeartbeat(), 255));
        bus.command(frameOf(
            mavlink::CommandLong{
                .target_system = 1, .target_component = 1, .command = mavlink::MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, .param1 = 1},
            255));
        bus.pass(2s);
        QVERIFY(bus.listen() > 0);
        QCOMPARE(bus.agent->counters().old, std::uint64_t(0));
        bus.command(armRequest());
        QVERIFY(bus.armed());
        bus.disarm();
    }
}

/// A vehicle without a memory for its time, which the agent has heard minutes ahead.
void VehicleSigningTest::vehicleThatLostItsTimeCatchesUp()
{
    SignedBus bus;
    bus.pass(1s);
    bus.listen();
    // Another signer with the key, which has a clock, moves the time of all on by an hour.
    mavlink::FrameSigner clocked(keyOf(1), 5, 60 * mavlink::kSigningMinute);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    bus.deliver(clocked.signCopy(viewOf(frameOf(stationHeartbeat(), 254)), buffer));
    bus.pass(1s);
    QVERIFY(bus.listen() > 0);

    Bus fresh; // the same vehicle, as it was when it was set up
    QVERIFY(fresh.run(SigningAction::SetUp, vehicleKey(1)).reached);
    static_cast<Bus &>(bus) = std::move(fresh);
    bus.sent.clear();
    bus.pass(1200ms);
    QCOMPARE(bus.listen(), std::size_t(0));
    QVERIFY(bus.agent->counters().old > 0);
    bus.pass(1s);
    QVERIFY(bus.listen() > 0); // it took the time of the agent's request
    bus.command(armRequest());
    QVERIFY(bus.armed());
}

void VehicleSigningTest::timeIsStoredAhead()
{
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("key.time")).toStdString();
    mavlink::SigningTime last = 0;
    for (int run = 0; run < 3; ++run) {
        VehicleSigning agent({keyOf(1), std::move(*keys::SigningTimeFile::open(file))}, false);
        const auto time = mavlink::signatureTime(agent.sign(viewOf(armRequest()), true));
        QVERIFY(time > last);
        last = time;
        for (int i = 0; i < 1000; ++i) {
            const auto next = mavlink::signatureTime(agent.sign(viewOf(armRequest()), true));
            QCOMPARE(next, last + 1);
            last = next;
        }
    }
    const std::uint64_t stored = (*keys::SigningTimeFile::open(file))->storedAtStart();
    QVERIFY(stored >= last && stored <= last + VehicleSigning::kAhead);
}

void VehicleSigningTest::removedSigningIsSaid()
{
    SignedBus bus;
    QVERIFY(bus.run(SigningAction::Remove, vehicleKey(1)).reached);
    bus.sent.clear();
    bus.pass(1s);
    QCOMPARE(bus.listen(), std::size_t(0));
    QCOMPARE(kindsOf(bus.agent->takeReports(bus.now)), std::vector{Kind::Unsigned});
    bus.run(SigningAction::SetUp, vehicleKey(1));
    bus.sent.clear();
    bus.pass(1s);
    QVERIFY(bus.listen() > 0);
    QCOMPARE(kindsOf(bus.agent->takeReports(bus.now)), std::vector{Kind::Verified});
}

void VehicleSigningTest::stationsDoNotChangeTheKey()
{
    SignedBus bus;
    bus.pass(1s);
    bus.listen();
    mavlink::SetupSigning off{.target_system = 1, .target_component = 1};
    QVERIFY(bus.agent->sign(viewOf(frameOf(off, 255)), true).empty());
    QCOMPARE(bus.agent->counters().keyChanges, std::uint64_t(1));
    QCOMPARE(kindsOf(bus.agent->takeReports(bus.now)), (std::vector{Kind::KeyChange, Kind::Verified}));
}

void VehicleSigningTest::version1IsNotForwarded()
{
    VehicleSigning agent(vehicleKey(1), false);
    mavlink::FrameWriter writer(255, 190, 1);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    QVERIFY(agent.sign(writer.write(stationHeartbeat(), buffer), true).empty());
    QCOMPARE(agent.counters().unsignable, std::uint64_t(1));
}

/// A vehicle remembers 16 senders and then refuses any other until it restarts.
void VehicleSigningTest::askersTakeNoPlaceOfPilots()
{
    SignedBus bus;
    bus.pass(1s);
    bus.listen();
    const auto heartbeatOf = [](int component) {
        return frameOf(stationHeartbeat(), 200, static_cast<std::uint8_t>(component));
    };
    std::size_t accepted = 0;
    for (int component = 1; component <= 100; ++component) {
        if (const ByteView out = bus.agent->sign(viewOf(heartbeatOf(component)), false); !out.empty()) {
            ++accepted;
            bus.deliver(out);
        }
    }
    QCOMPARE(accepted, VehicleSigning::kMostAskers);
    QCOMPARE(bus.agent->counters().tooManySenders, std::uint64_t(100) - accepted);
    for (std::size_t component = accepted; component < VehicleSigning::kMostSenders; ++component)
        bus.command(heartbeatOf(static_cast<int>(100 + component)));
    QVERIFY(bus.agent->sign(viewOf(heartbeatOf(50)), true).empty());
    QVERIFY(!bus.agent->sign(viewOf(heartbeatOf(1)), false).empty());
    // Two places of the vehicle were left: for the agent's own requests, and for a station on another port.
    mavlink::FrameSigner elsewhere(keyOf(1), 0, mavlink::signatureTime(bus.agent->sign(viewOf(heartbeatOf(1)), false)));
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    bus.deliver(elsewhere.signCopy(viewOf(armRequest()), buffer));
    QVERIFY(bus.armed());
}

void VehicleSigningTest::reportsAreFew()
{
    VehicleSigning agent(vehicleKey(1), false);
    const QByteArray plain = frameOf(stationHeartbeat(), 1, 1);
    TimePoint now;
    std::size_t reports = 0;
    for (int second = 0; second < 600; ++second) {
        for (int i = 0; i < 100; ++i)
            agent.accept(viewOf(plain));
        reports += agent.takeReports(now).size();
        now += 1s;
    }
    QCOMPARE(reports, std::size_t(10));
    QCOMPARE(agent.counters().unsignedRefused, std::uint64_t(60'000));
}

void VehicleSigningTest::keyFilesAreGuarded()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("vehicle.signing"));
    crypto::SystemRandom random;
    QVERIFY(writeNewVehicleKey(path.toStdString(), random));
    QVERIFY(!writeNewVehicleKey(path.toStdString(), random)); // never over another key
    QCOMPARE(QFile::permissions(path) & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteOther), QFile::Permissions());
    QVERIFY(readVehicleKey(path.toStdString()));
    QFile::setPermissions(path, QFile::permissions(path) | QFile::ReadOther);
    const auto open = readVehicleKey(path.toStdString());
    QVERIFY(!open);
    QFile file(path);
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    const QByteArray damaged(63, 'a');
    file.write(damaged);
    file.close();
    const auto wrong = readVehicleKey(path.toStdString());
    QVERIFY(!wrong && !QByteArray::fromStdString(wrong.error().text()).contains(damaged.left(20)));
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(QByteArray(64, '0'));
    file.close();
    QVERIFY(!readVehicleKey(path.toStdString())); // "no key" on the wire
}

SKYSEAL_TEST_APPLESS(VehicleSigningTest)
#include "vehicle_signing_test.moc"
