// A vehicle is spoken to in the MAVLink version of its frames.
#include "core/vehicle/firmware_info.h"
#include "core/vehicle/protocol_version.h"
#include "tests/support/test_runner.h"
#include "vehicle_harness.h"

using namespace skyseal;
using namespace skyseal::vehicle;

class ProtocolVersionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void versionIsThatOfTheFrames();
    void otherComponentsDoNotCount();
    void plansThatVersion1CannotNameAreRefused();
    void autopilotThatKnowsVersion2IsAskedInIt_data();
    void autopilotThatKnowsVersion2IsAskedInIt();
    void lostQuestionIsRepeated();
};

namespace {

/// A vehicle whose autopilot sends frames of one version.
class Speaker : public Harness
{
public:
    explicit Speaker(int version) { speak(version, vehicle::heartbeat()); }

    template<typename Message> void speak(int version, const Message &message, std::uint8_t component = 1)
    {
        Sender sender(1, component, version);
        vehicle.handleFrame(now, {}, sender.frame(message));
    }
    int version() const { return vehicle.current().mavlinkVersion; }
    /// Questions that go out in version 2 whatever the vehicle speaks.
    std::size_t questions()
    {
        std::size_t out = 0;
        for (const OutMessage &message : sent()) {
            const auto command = as<mavlink::CommandLong>(message);
            out += message.version == 2 && command && command->command == mavlink::MAV_CMD_REQUEST_PROTOCOL_VERSION;
        }
        return out;
    }
};

} // namespace

void ProtocolVersionTest::versionIsThatOfTheFrames()
{
    Speaker vehicle(1);
    QCOMPARE(vehicle.version(), 1);
    vehicle.speak(2, mavlink::Attitude{});
    QCOMPARE(vehicle.version(), 2); // at once
    vehicle.now += std::chrono::seconds(4);
    vehicle.speak(1, vehicle::heartbeat()); // was under way, or PX4 has answered in version 2 alone
    QCOMPARE(vehicle.version(), 2);
    vehicle.now += std::chrono::seconds(2);
    vehicle.speak(1, vehicle::heartbeat()); // it has restarted
    QCOMPARE(vehicle.version(), 1);
    QCOMPARE(Speaker(2).version(), 2);
}

/// An autopilot forwards the frames of its gimbal as they are.
void ProtocolVersionTest::otherComponentsDoNotCount()
{
    Speaker vehicle(1);
    vehicle.speak(2, vehicle::heartbeat(0, false, mavlink::MAV_TYPE_GIMBAL, mavlink::MAV_AUTOPILOT_INVALID), 154);
    QCOMPARE(vehicle.version(), 1);
}

void ProtocolVersionTest::plansThatVersion1CannotNameAreRefused()
{
    Speaker vehicle(1);
    vehicle.runUntil(vehicle.now);
    vehicle.sent();
    const auto refusal = [&](const Request &request) {
        vehicle.vehicle.perform(vehicle.now, RequestId{1}, request);
        const auto result = vehicle.poll<MissionResult>();
        return result && !result->ok && vehicle.sent().empty() ? result->reason.text() : std::string();
    };
    for (const MissionType type : {MissionType::Fence, MissionType::Rally}) {
        for (const Request &request :
             {Request(ReadMission{.type = type}), Request(WriteMission{.type = type}), Request(ClearMission{.type = type})})
            QCOMPARE(refusal(request),
                     std::string("nothing was sent: the vehicle speaks MAVLink 1, which knows missions only; "
                                 "fences and rally points need MAVLink 2"));
    }
    vehicle.vehicle.perform(vehicle.now, RequestId{2}, ReadMission{});
    QCOMPARE(vehicle.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
    Speaker other(2);
    other.speak(2, mavlink::AutopilotVersion{.capabilities = mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_FENCE});
    other.vehicle.perform(other.now, RequestId{3}, ReadMission{.type = MissionType::Fence});
    QCOMPARE(other.sentOf<mavlink::MissionRequestList>().size(), std::size_t(1));
}

void ProtocolVersionTest::autopilotThatKnowsVersion2IsAskedInIt_data()
{
    QTest::addColumn<int>("version");
    QTest::addColumn<bool>("isCapable");
    QTest::addColumn<int>("questions");
    QTest::newRow("version 1 alone") << 1 << false << 0;
    QTest::newRow("waits for version 2") << 1 << true << FirmwareInfo::kVersionAttempts;
    QTest::newRow("speaks version 2") << 2 << true << 0;
}

void ProtocolVersionTest::autopilotThatKnowsVersion2IsAskedInIt()
{
    QFETCH(int, version);
    QFETCH(bool, isCapable);
    QFETCH(int, questions);
    Speaker vehicle(version);
    const std::uint64_t capabilities = isCapable ? mavlink::MAV_PROTOCOL_CAPABILITY_MAVLINK2 : 0;
    vehicle.speak(version, mavlink::AutopilotVersion{.capabilities = capabilities});
    std::size_t asked = 0;
    for (int second = 0; second < 30; ++second) {
        vehicle.runUntil(vehicle.now + std::chrono::seconds(1));
        asked += vehicle.questions();
        vehicle.speak(version, vehicle::heartbeat());
    }
    QCOMPARE(asked, static_cast<std::size_t>(questions));
    QCOMPARE(vehicle.version(), version);
}

void ProtocolVersionTest::lostQuestionIsRepeated()
{
    Speaker vehicle(1);
    vehicle.speak(1, mavlink::AutopilotVersion{.capabilities = mavlink::MAV_PROTOCOL_CAPABILITY_MAVLINK2});
    vehicle.runUntil(vehicle.now + FirmwareInfo::kInterval);
    QCOMPARE(vehicle.questions(), std::size_t(2));
    vehicle.speak(2, vehicle::heartbeat()); // it has understood
    QCOMPARE(vehicle.version(), 2);
    vehicle.runUntil(vehicle.now + std::chrono::seconds(30));
    QCOMPARE(vehicle.questions(), std::size_t(0));
}

SKYSEAL_TEST_APPLESS(ProtocolVersionTest)
#include "protocol_version_test.moc"
