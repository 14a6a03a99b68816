#include "tests/engine/station_rig.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/station/station_core.h"
#include "tests/support/addresses.h"

#include <QtCore/QAbstractEventDispatcher>
#include <QtCore/QCoreApplication>

namespace skyseal::test {

StationRig::StationRig(crypto::SuiteId suite, std::vector<std::uint8_t> bound)
    : m_snapshot(std::make_shared<engine::Snapshot>())
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
    std::uint64_t out = m_snapshot->spoofed;
    for (const engine::OtherSystemsHeard &heard : m_snapshot->otherSystems)
        out += heard.frames;
    return out;
}

} // namespace skyseal::test
