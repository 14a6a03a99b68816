#include "tests/engine/engine_rigs.h"

#include "core/channel/endpoint.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/engine/station/snapshot.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/signing.h"
#include "tests/support/addresses.h"
#include "tests/support/eventually.h"

#include <QtCore/QAbstractEventDispatcher>
#include <QtCore/QDeadlineTimer>

namespace skyseal::test {

namespace {

std::string loopback(std::uint16_t port)
{
    return "127.0.0.1:" + std::to_string(port);
}

/// Ends the program if it waits forever: a fault of the rig, not a slow engine.
class Patience
{
public:
    void check() const
    {
        if (m_deadline.hasExpired()) {
            std::fprintf(stderr, "the engine did not deliver all frames\n");
            std::abort();
        }
    }

private:
    QDeadlineTimer m_deadline{kDeadlineMs};
};

} // namespace

void bringUp(BareEnd &end, crypto::SuiteId suite)
{
    const Patience patience;
    const auto turn = [&] {
        QCoreApplication::processEvents();
        end.pump();
        patience.check();
    };
    while (!end.up())
        turn();
    const auto session = [&end] { return *end.endpoint().sessionInfo(end.session()); };
    while (session().lastReceived <= session().since) // A record shows that the session is up at the other end.
        turn();
    if (session().suite == suite)
        return;
    end.endpoint().switchSuite(steadyNow(), end.session(), suite);
    while (session().suite != suite)
        turn();
    // Until both ends have deleted the keys of the previous epoch, as during the time between two switches. Nothing reports it.
    const Duration settling = channel::Timing().oldKeysLinger + std::chrono::milliseconds(500);
    for (const TimePoint switched = steadyNow(); steadyNow() - switched < settling;)
        turn();
}

AgentRig::AgentRig(crypto::SuiteId suite, VehicleSide side)
    : m_ground(m_keys, channel::Role::Station, everySuite()), m_signed(kFrames), m_fromVehicle(m_telemetry.frames())
{
    std::unique_ptr<engine::VehicleSigning> signing;
    if (side == VehicleSide::Signed) {
        Key32 key;
        key.mutableView()[0] = 1;
        m_signer = std::make_unique<mavlink::FrameSigner>(key.clone(), std::uint8_t(0));
        signing = std::make_unique<engine::VehicleSigning>(engine::VehicleKey{std::move(key), nullptr}, false);
    }
    const link::LinkUrl ground = urlOf("udpout:" + loopback(m_ground.port()));
    engine::AgentConfig config{urlOf("udpin:127.0.0.1:0"), {{ground}}, everySuite(), false};
    m_agent = std::make_unique<engine::AgentCore>(
        std::move(config), m_keys.secrets(channel::Role::Agent), [](const engine::AgentEvent &) {}, std::move(signing));
    m_agent->start();
    m_port = portOf(m_agent->snapshot().vehicle.localAddress);
    bringUp(m_ground, suite);
    toGround(kFrames); // makes the vehicle known and warms up
}

AgentRig::~AgentRig() = default;

double AgentRig::toGround(std::size_t burst)
{
    const Patience patience;
    CpuTimer cpu;
    std::size_t arrived = 0;
    for (std::size_t i = 0; m_signer && i < kFrames; ++i)
        m_fromVehicle[i] = m_signer->signCopy(m_telemetry.frames()[i], m_signed[i]);
    for (std::size_t sent = 0; sent < kFrames;) {
        m_vehicle.send(m_port, std::span(m_fromVehicle).subspan(sent, burst));
        sent += burst;
        while (arrived < sent) {
            cpu.time([] { QCoreApplication::processEvents(); });
            arrived += m_ground.pump();
            patience.check();
        }
    }
    return cpu.nanosecondsEach(kFrames);
}

double AgentRig::toVehicle(std::size_t burst)
{
    const Patience patience;
    CpuTimer cpu;
    std::size_t arrived = 0;
    for (std::size_t sent = 0; sent < kFrames;) {
        m_ground.sendEach(std::span(m_commands.frames()).subspan(sent, burst));
        sent += burst;
        while (arrived < sent) {
            cpu.time([] { QCoreApplication::processEvents(); });
            while (const std::size_t count = m_vehicle.receive())
                arrived += count;
            patience.check();
        }
    }
    m_ground.pump();
    return cpu.nanosecondsEach(kFrames);
}

double BareForwarder::forward(std::size_t burst)
{
    CpuTimer cpu;
    for (std::size_t sent = 0; sent < kFrames; sent += burst) {
        m_from.send(m_middle.port(), std::span(m_telemetry.frames()).subspan(sent, burst));
        cpu.time([&] {
            while (m_middle.waitReadable(0))
                m_middle.forward(m_to.port(), m_middle.receive());
        });
        while (m_to.receive() > 0) {}
    }
    return cpu.nanosecondsEach(kFrames);
}

Receiver::Receiver(crypto::SuiteId suite)
    : m_secrets(m_keys.secrets(channel::Role::Station)), m_links(*this, [](link::Link &) {}),
      m_intake(mavlink::Dialect::builtin())
{
    channel::Config config;
    config.role = channel::Role::Station;
    config.identity = m_secrets->identity;
    config.peers = m_secrets->peers;
    config.policy = everySuite();
    channel::Endpoint endpoint(std::move(config), m_secrets->random, *m_secrets->counters, steadyNow());
    m_channel = std::make_unique<engine::ChannelDriver>(std::move(endpoint), m_links);
    const link::Link &link = m_links.open(LinkId{1}, urlOf("udpin:127.0.0.1:0"));
    m_air = std::make_unique<BareEnd>(m_keys, channel::Role::Agent, everySuite(), link.localEndpoint()->port);
    bringUp(*m_air, suite);
}

void Receiver::linkReceived(link::Link &, std::span<const link::ReceivedBlock> blocks)
{
    for (const link::ReceivedBlock &block : blocks) {
        const auto delivery = m_channel->receive(block.time, block.path, block.bytes);
        if (!delivery)
            continue;
        std::size_t frames = 0;
        m_intake.takeDatagram(delivery->frames, [&](const mavlink::ScanItem &item) { frames += item.frame.has_value(); });
        m_channel->costs().countFrames(delivery->session, frames);
        m_received += frames;
    }
    const TimePoint now = steadyNow();
    if (now >= m_channel->endpoint().nextDeadline())
        m_channel->endpoint().handleDeadline(now);
    m_channel->flush(now);
    while (m_channel->pollEvent()) {}
    m_links.flush();
}

double Receiver::receive()
{
    const Patience patience;
    CpuTimer cpu;
    m_air->pump();
    m_received = 0;
    m_air->sendEach(m_telemetry.frames());
    while (m_received < kFrames) {
        cpu.time([] { QCoreApplication::processEvents(); });
        patience.check();
    }
    return cpu.nanosecondsEach(kFrames);
}

StationRig::StationRig(crypto::SuiteId suite, std::vector<std::uint8_t> bound)
{
    engine::StationConfig config;
    config.secure = engine::SecureMode::Required;
    config.policy = everySuite();
    config.record = false;
    config.snapshotsPerSecond = 1;
    std::string address;
    engine::StationSinks sinks;
    sinks.snapshot = [this](std::shared_ptr<const engine::Snapshot> snapshot) { m_snapshot = std::move(snapshot); };
    sinks.event = [](engine::Event) {};
    auto secrets = m_keys.secrets(channel::Role::Station);
    secrets->peers[0].systemIds = std::move(bound);
    m_station = std::make_unique<engine::StationCore>(std::move(config), std::move(secrets), std::move(sinks));
    m_station->addLink(LinkId{1}, urlOf("udpin:127.0.0.1:0"));
    const Patience patience;
    while (m_snapshot->links.empty() || m_snapshot->links[0].phase != engine::LinkPhase::Listening) {
        QCoreApplication::processEvents();
        patience.check();
    }
    m_air = std::make_unique<BareEnd>(m_keys, channel::Role::Agent, everySuite(), portOf(m_snapshot->links[0].localAddress));
    bringUp(*m_air, suite);
}

StationRig::~StationRig() = default;

double StationRig::receive()
{
    CpuTimer cpu;
    m_air->pump();
    m_air->sendEach(m_telemetry.frames());
    // Until nothing is left: a link receives a limited number per turn. frames() shows whether all were accepted.
    bool any = true;
    for (std::size_t turn = 0; any && turn < kFrames; ++turn)
        cpu.time([&] { any = QAbstractEventDispatcher::instance()->processEvents(QEventLoop::AllEvents); });
    return cpu.nanosecondsEach(kFrames);
}

void StationRig::awaitSnapshot()
{
    const std::uint64_t number = m_snapshot->number;
    const Patience patience;
    while (m_snapshot->number < number + 2) {
        QCoreApplication::processEvents();
        patience.check();
    }
}

std::uint64_t StationRig::frames()
{
    awaitSnapshot();
    return m_snapshot->mavlink.frames;
}

std::uint64_t StationRig::refused()
{
    awaitSnapshot();
    return m_snapshot->spoofed;
}

} // namespace skyseal::test
