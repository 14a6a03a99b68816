#include "tests/engine/agent_rig.h"

#include "core/engine/agent/agent_core.h"
#include "core/engine/agent/vehicle_key.h"
#include "core/engine/agent/vehicle_signing.h"
#include "core/mavlink/signing.h"
#include "tests/support/addresses.h"

#include <QtCore/QCoreApplication>

namespace skyseal::test {

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
    const link::LinkUrl ground = urlOf("udpout:" + loopbackAddress(m_ground.port()));
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

} // namespace skyseal::test
