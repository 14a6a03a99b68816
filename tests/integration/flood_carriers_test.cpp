// Floods of every kind of message that a stranger can send, over every carrier, to a station and to an agent, while a window
// for pairing is closed and open, and their effect on a legitimate pilot: the time of a command and its answer. Quiet and
// flooded seconds alternate, and the two are compared within one run. Nothing else should run beside it.
#include "carrier_flight.h"

#include "core/crypto/init_crypto.h"
#include "core/engine/station/station.h"
#include "core/keys/public_key_text.h"
#include "core/link/steady_now.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_intake.h"
#include "tests/support/addresses.h"
#include "tests/support/bare_socket.h"
#include "tests/support/heartbeat.h"
#include "tests/support/stranger_messages.h"
#include "tests/support/stranger_wire.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTimer>

#include <atomic>
#include <thread>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;
using Target = StrangerWire::Target;

namespace {

/// A vehicle that accepts every command at once. A thread of its own.
class ObedientVehicle
{
public:
    explicit ObedientVehicle(std::uint16_t agentPort) : m_thread([this, agentPort] { run(agentPort); }) {}
    ~ObedientVehicle()
    {
        m_stop = true;
        m_thread.join();
    }

private:
    void run(std::uint16_t port)
    {
        const QByteArray heartbeat = clearHeartbeat(1, 1, false);
        const auto *bytes = reinterpret_cast<const std::uint8_t *>(heartbeat.constData());
        const std::array<ByteView, 1> beat{ByteView(bytes, static_cast<std::size_t>(heartbeat.size()))};
        mavlink::FrameWriter writer(1, 1);
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        for (TimePoint due; !m_stop; m_socket.waitReadable(20)) {
            if (steadyNow() >= due) {
                m_socket.send(port, beat);
                due = steadyNow();
                due += 500ms;
            }
            const std::size_t count = m_socket.receive();
            for (std::size_t i = 0; i < count; ++i) {
                mavlink::scanFrames(m_socket.received(i), mavlink::Dialect::builtin(), [&](const mavlink::ScanItem &item) {
                    if (!item.frame || item.frame->messageId() != mavlink::CommandLong::kId)
                        return;
                    const auto command = mavlink::CommandLong::decode(item.frame->payload());
                    const std::array<ByteView, 1> answer{writer.write(
                        mavlink::CommandAck{.command = command.command, .target_system = item.frame->systemId()}, buffer)};
                    m_socket.send(port, answer);
                });
            }
        }
    }

    BareSocket m_socket;
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

/// A second of them: 50,000, or 20,000 first messages, and not more than 200 Mbit.
std::shared_ptr<const std::vector<Bytes>> aSecondOf(const StrangerMessage &message, const StrangersKnowledge &knows,
                                                    Carrier carrier)
{
    std::mt19937_64 random(3);
    const std::string_view name = message.name;
    auto out = std::make_shared<std::vector<Bytes>>();
    std::size_t size = 0;
    for (int i = 0; i < (name.starts_with("first") ? 20'000 : 50'000) && size < 200'000'000 / 8; ++i) {
        const Bytes bytes = message.make(knows, random);
        out->push_back(message.isBare() ? bytes : onTheWire(carrier, bytes));
        size += out->back().size();
    }
    return out;
}

double percentile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[static_cast<std::size_t>(static_cast<double>(values.size() - 1) * share)];
}

/// A station in this process, an agent, and the wire between them.
struct FloodedFlight
{
    FloodedFlight(Carrier carrier, Target target, bool pairing) : m_carrier(carrier), m_target(target), m_pairing(pairing)
    {
        m_tick.setTimerType(Qt::PreciseTimer);
        m_tick.start(1); // processEvents() returns at least so often
    }

    void begin()
    {
        QVERIFY(flight.ready() && crypto::initCrypto());
        engine::StationConfig config;
        config.keys = {flight.path(QStringLiteral("ground.key")).toStdString(),
                       flight.path(QStringLiteral("ground.peers")).toStdString()};
        config.secure = engine::SecureMode::Required;
        config.policy.suites = channel::defaultSuites();
        config.record = false;
        auto made = engine::Station::create(std::move(config));
        QVERIFY(made.has_value());
        station = std::move(*made);
        QObject::connect(station.get(), &engine::Station::eventOccurred, &m_context, [this](const engine::Event &event) {
            if (const auto *changed = std::get_if<engine::LinkChanged>(&event); changed && !changed->link.localAddress.empty())
                m_listening = changed->link.localAddress;
            m_hasVehicle = m_hasVehicle || std::holds_alternative<engine::VehicleFound>(event);
            m_sessions += std::holds_alternative<channel::SessionUp>(event);
            if (const auto *result = std::get_if<vehicle::CommandResult>(&event))
                m_result = *result;
        });
        const bool isStream = m_carrier == Carrier::Serial;
        station->addLink(urlOf(isStream ? "tcpin:127.0.0.1:0" : "udpin:127.0.0.1:0"));
        EVENTUALLY(!m_listening.empty());
        wire = std::make_unique<StrangerWire>(m_carrier, m_target, portOf(m_listening));
        QStringList air = with(flight.airArguments(), "--ground", loopback(isStream ? "tcp" : "udpout", wire->port()));
        if (m_carrier == Carrier::Tunnel)
            air += words({"--carrier", "tunnel"});
        agent = std::make_unique<Program>(QStringLiteral("skyseal-air"), air);
        vehicle = std::make_unique<ObedientVehicle>(flight.vehiclePort);
        EVENTUALLY(m_hasVehicle && !wire->record().empty());
        openPairing();
    }

    /// The window is open for 120 s at most; a flood with many first messages may end the attempt of a pairing as well.
    void openPairing()
    {
        if (!m_pairing)
            return;
        if (m_target == Target::Station) {
            station->cancelPairing();
            station->openPairing("ground");
        } else if (!m_desk || !m_desk->running()) {
            m_desk = std::make_unique<Program>(QStringLiteral("skyseal-air"),
                                               words({"--pair", "--json", "--identity"})
                                                   << flight.path(QStringLiteral("air.key")));
            QVERIFY(!m_desk->waitFor(QStringLiteral("pairing")).isEmpty());
            EVENTUALLY(wire->token().has_value());
        }
    }

    StrangersKnowledge knows() const
    {
        const auto keyOf = [this](const char *name) {
            Program show(QStringLiteral("skyseal-cli"), words({"keys", "show", "--json"}) << flight.path(QLatin1String(name)));
            const QString text = show.waitFor(QStringLiteral("key"))[QLatin1String("public")].toString();
            return *keys::publicKeyFromText(text.toStdString());
        };
        const bool atAgent = m_target == Target::Agent;
        return {keyOf(atAgent ? "air.key" : "ground.key"), keyOf(atAgent ? "ground.key" : "air.key"), wire->record(), {}};
    }

    /// Microseconds from a command of the pilot to its answer; nullopt if it was not accepted.
    std::optional<double> command()
    {
        m_result.reset();
        const TimePoint sent = steadyNow();
        const auto id = station->perform(
            1, vehicle::VehicleCommand(vehicle::RawCommand{.command = mavlink::MAV_CMD_SET_MESSAGE_INTERVAL}));
        while (!m_result || m_result->id != id) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            if (steadyNow() - sent > 2s)
                return std::nullopt;
        }
        const double took = seconds(steadyNow() - sent) * 1e6;
        return m_result->outcome == vehicle::CommandOutcome::Accepted ? std::optional(took) : std::nullopt;
    }

    int sessions() const { return m_sessions; }

    Flight flight;
    std::unique_ptr<engine::Station> station;
    std::unique_ptr<StrangerWire> wire;
    std::unique_ptr<Program> agent;
    std::unique_ptr<ObedientVehicle> vehicle;

private:
    const Carrier m_carrier;
    const Target m_target;
    const bool m_pairing;
    std::unique_ptr<Program> m_desk; ///< the person who opens the agent's window
    QTimer m_tick;
    QObject m_context;
    std::string m_listening;
    bool m_hasVehicle = false;
    int m_sessions = 0;
    std::optional<vehicle::CommandResult> m_result;
};

} // namespace

class FloodCarriersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pilotCommandsDuringEachFlood_data();
    void pilotCommandsDuringEachFlood();
};

void FloodCarriersTest::pilotCommandsDuringEachFlood_data()
{
    QTest::addColumn<int>("carrier");
    QTest::addColumn<int>("target");
    QTest::addColumn<bool>("pairing");
    const std::pair<const char *, Carrier> carriers[] = {
        {"datagrams", Carrier::Datagram}, {"COBS", Carrier::Serial}, {"TUNNEL", Carrier::Tunnel}};
    for (const auto &[name, carrier] : carriers) {
        for (const Target target : {Target::Agent, Target::Station}) {
            for (const bool pairing : {false, true})
                QTest::addRow("%s, %s%s", target == Target::Agent ? "agent" : "station", name, pairing ? ", pairing open" : "")
                    << int(carrier) << int(target) << pairing;
        }
    }
}

void FloodCarriersTest::pilotCommandsDuringEachFlood()
{
    QFETCH(int, carrier);
    QFETCH(int, target);
    QFETCH(bool, pairing);
    FloodedFlight flown(static_cast<Carrier>(carrier), static_cast<Target>(target), pairing);
    flown.begin();
    if (QTest::currentTestFailed())
        return;
    StrangersKnowledge knows = flown.knows();
    std::vector<double> quiet, flooded;
    std::uint64_t expected = 0;
    const auto fly = [&](std::vector<double> &times) {
        const TimePoint begun = steadyNow();
        while (steadyNow() - begun < 1s) {
            const TimePoint sent = steadyNow();
            const auto took = flown.command();
            if (!took)
                return false;
            if (sent - begun > 100ms)
                times.push_back(*took);
            while (steadyNow() < sent + 4ms) // so that the commands themselves do not load the machine
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        return true;
    };
    for (const StrangerMessage &message : kStrangerMessages) {
        flown.openPairing();
        knows.token = flown.wire->token().value_or(channel::PairingToken{});
        const auto messages = aSecondOf(message, knows, static_cast<Carrier>(carrier));
        QVERIFY2(fly(quiet), "a command without a flood is answered");
        flown.wire->flood(messages);
        const std::uint64_t before = flown.wire->sent();
        std::vector<double> times;
        QVERIFY2(fly(times), message.name);
        expected += messages->size();
        qInfo("%s: %s: p99 %.0f us, %llu sent", QTest::currentDataTag(), message.name, percentile(times, 0.99),
              static_cast<unsigned long long>(flown.wire->sent() - before));
        flooded.insert(flooded.end(), times.begin(), times.end());
        flown.wire->flood({});
    }
    const double p99Quiet = percentile(quiet, 0.99), p99Flooded = percentile(flooded, 0.99);
    qInfo("%s: %llu of %llu sent; command and answer: p50 %.0f us quiet, %.0f us flooded; p99 %.0f us quiet, %.0f us flooded "
          "(x %.2f)",
          QTest::currentDataTag(), static_cast<unsigned long long>(flown.wire->sent()),
          static_cast<unsigned long long>(expected), percentile(quiet, 0.5), percentile(flooded, 0.5), p99Quiet, p99Flooded,
          p99Flooded / p99Quiet);
    QCOMPARE(flown.sessions(), 1);
    QVERIFY(flown.wire->sent() >= expected * 9 / 10);
    QVERIFY(p99Flooded <= 2 * p99Quiet);
}

SKYSEAL_TEST(FloodCarriersTest)
#include "flood_carriers_test.moc"
