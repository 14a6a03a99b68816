// The simulated vehicle goes on under any input: valid frames with random contents, random bytes, and random flights by random
// requests. Nothing that it sends contains a NaN.
#include "tests/sim/test_flight.h"
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include "core/mavlink/enums.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

using namespace skyseal;
using namespace skyseal::sim;

class SimHostileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomFlightsStayFinite();
    void randomPayloadsOfAllMessages();
    void randomBytes();
};

namespace {

bool sane(const Bytes &bytes)
{
    const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin());
    if (!frame)
        return false;
    if (frame->messageId() == mavlink::Attitude::kId) {
        const auto a = mavlink::Attitude::decode(frame->payload());
        return std::isfinite(a.roll) && std::isfinite(a.pitch) && std::isfinite(a.yaw) && std::isfinite(a.rollspeed);
    }
    if (frame->messageId() == mavlink::LocalPositionNed::kId) {
        const auto p = mavlink::LocalPositionNed::decode(frame->payload());
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.vz);
    }
    if (frame->messageId() == mavlink::VfrHud::kId) {
        const auto h = mavlink::VfrHud::decode(frame->payload());
        return std::isfinite(h.climb) && std::isfinite(h.groundspeed) && h.heading >= 0 && h.heading < 360;
    }
    return true;
}

float strangeFloat(Noise &dice)
{
    switch (dice.next() % 8) {
    case 0: return std::nanf("");
    case 1: return std::numeric_limits<float>::infinity();
    case 2: return -1e30f;
    case 3: return 0;
    case 4: return 1;
    default: return static_cast<float>(dice.normal(300));
    }
}

} // namespace

void SimHostileTest::randomFlightsStayFinite()
{
    QVERIFY(rc::check("random requests never make a state that is no number", [] {
        AutopilotConfig config;
        config.seed = *rc::gen::arbitrary<std::uint64_t>();
        TestFlight flight(config);
        Autopilot &a = flight.autopilot;
        Noise dice(config.seed, 1000);
        flight.airborne(3 + dice.uniform() * 6);
        constexpr FlightMode kModes[] = {FlightMode::Stabilize, FlightMode::AltHold, FlightMode::Auto, FlightMode::Guided,
                                         FlightMode::Loiter,    FlightMode::Rtl,     FlightMode::Land, FlightMode::Brake};
        for (int i = 0; i < 12; ++i) {
            switch (dice.next() % 9) {
            case 0: a.requests().enterMode(kModes[dice.next() % 8]); break;
            case 1: a.requests().goTo({dice.normal(200), dice.normal(200), -std::abs(dice.normal(40))}); break;
            case 2: a.requests().move({static_cast<double>(strangeFloat(dice)), dice.normal(10), dice.normal(5)}); break;
            case 3:
                a.flight().pilot.manual(
                    {}, {dice.uniform() * 2 - 1, dice.uniform() * 2 - 1, dice.uniform() * 2 - 1, dice.uniform()});
                break;
            case 4: a.parameters().set(dice.next() % a.parameters().count(), strangeFloat(dice)); break;
            case 5: a.requests().face(static_cast<double>(strangeFloat(dice)), dice.normal(1)); break;
            case 6:
                a.requests().changeSpeed(FlightRequests::SpeedKind(dice.next() % 3), static_cast<double>(strangeFloat(dice)));
                break;
            case 7: dice.next() % 2 ? a.arming().arm(dice.next() % 2) : a.arming().disarm(dice.next() % 4 == 0); break;
            default: {
                const std::size_t index = dice.next() % a.parameters().count();
                const ParameterInfo &info = a.parameters().info(index); // its ends are allowed, so they must fly
                a.parameters().set(index, dice.next() % 2 ? info.minimum : info.maximum);
            }
            }
            flight.run(1.5);
        }
        RC_ASSERT(flight.finite);
        RC_ASSERT(a.truth().position.length() < 1e5);
    }));
}

void SimHostileTest::randomPayloadsOfAllMessages()
{
    const quint64 seed = 20240817;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    Noise dice(seed, 7);
    TestStation station;
    station.run(6);
    const auto messages = mavlink::Dialect::builtin().messages();
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    for (int i = 0; i < 4000; ++i) {
        const mavlink::MessageInfo &info = messages[dice.next() % messages.size()];
        std::array<std::uint8_t, 255> payload{};
        for (std::uint8_t &byte : payload)
            byte = dice.next() % 3 ? static_cast<std::uint8_t>(dice.next()) : 0;
        if (info.targetSystemOffset >= 0)
            payload[static_cast<std::size_t>(info.targetSystemOffset)] = static_cast<std::uint8_t>(dice.next() % 2);
        if (info.targetComponentOffset >= 0)
            payload[static_cast<std::size_t>(info.targetComponentOffset)] = static_cast<std::uint8_t>(dice.next() % 2);
        station.deliver(mavlink::writeFrame(buffer, dice.next() % 4 ? 2 : 1, static_cast<std::uint8_t>(i), 255, 190, info.id,
                                            info.crcExtra, info.minLength, ByteView(payload).first(info.maxLength)));
        // And commands that are nearly right.
        mavlink::CommandLong command;
        constexpr std::uint16_t kCommands[] = {22,  20,  21,  16,  115, 176, 178, 179, 192, 207,
                                               224, 246, 300, 400, 410, 511, 512, 519, 520};
        command.target_system = 1;
        command.command = kCommands[dice.next() % std::size(kCommands)];
        command.param1 = strangeFloat(dice);
        command.param2 = dice.next() % 2 ? static_cast<float>(dice.next() % 20) : strangeFloat(dice);
        command.param3 = strangeFloat(dice);
        command.param4 = strangeFloat(dice);
        command.param5 = strangeFloat(dice);
        command.param6 = strangeFloat(dice);
        command.param7 = strangeFloat(dice);
        station.send(command);
        station.run(0.02);
        if (i % 64 == 0) {
            for (const Bytes &bytes : station.received)
                QVERIFY(sane(bytes));
            station.forget();
        }
    }
    QVERIFY(station.vehicle.autopilot().truth().position.finite());
}

void SimHostileTest::randomBytes()
{
    Noise dice(42, 8);
    TestStation station;
    for (int i = 0; i < 3000; ++i) {
        Bytes bytes(dice.next() % 300);
        for (std::uint8_t &byte : bytes)
            byte = static_cast<std::uint8_t>(dice.next());
        if (!bytes.empty())
            bytes[0] = dice.next() % 2 ? 0xfd : 0xfe;
        station.deliver(bytes);
    }
    station.run(2);
    QVERIFY(station.count<mavlink::Heartbeat>() >= 1);
}

SKYSEAL_TEST_APPLESS(SimHostileTest)
#include "hostile_test.moc"
