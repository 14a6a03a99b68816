// An agent whose vehicle and ground station are driven by hand.
#pragma once

#include "tests/engine/engine_rig.h"

#include <array>
#include <memory>
#include <vector>

namespace skyseal::engine {
class AgentCore;
}

namespace skyseal::mavlink {
class FrameSigner;
}

namespace skyseal::test {

/// An agent between a vehicle's socket and a ground station's endpoint.
class AgentRig
{
public:
    enum class VehicleSide { Plain, Signed };

    explicit AgentRig(crypto::SuiteId suite, VehicleSide side = VehicleSide::Plain);
    ~AgentRig();
    /// CPU nanoseconds for each of kFrames frames of the vehicle that arrive `burst` at a time.
    double toGround(std::size_t burst);
    /// The same for frames of the ground, each sealed alone.
    double toVehicle(std::size_t burst);

private:
    Introduced m_keys;
    BareEnd m_ground;
    BareSocket m_vehicle;
    SampleTraffic m_telemetry{kFrames};
    SampleTraffic m_commands{kFrames, 255};
    std::unique_ptr<mavlink::FrameSigner> m_signer; ///< of the vehicle; null for a plain one
    std::vector<std::array<std::uint8_t, mavlink::kMaxFrameLength>> m_signed;
    std::vector<ByteView> m_fromVehicle;
    std::unique_ptr<engine::AgentCore> m_agent;
    std::uint16_t m_port = 0;
};

} // namespace skyseal::test
