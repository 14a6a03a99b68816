// Engines over real sockets of 127.0.0.1 with hand-driven far ends. Only the CPU time of the engine's own thread is measured:
// the sockets are filled and drained between two readings of the clock.
#pragma once

#include "core/engine/agent/agent_core.h"
#include "core/engine/station/station_core.h"
#include "core/mavlink/frame_intake.h"
#include "tests/engine/bare_end.h"
#include "tests/engine/traffic.h"

#include <QtCore/QCoreApplication>

namespace skyseal::mavlink {
class FrameSigner;
}

namespace skyseal::test {

inline constexpr std::size_t kFrames = 512; ///< of one round; the most that one wake-up receives

inline channel::Policy everySuite()
{
    return {channel::defaultSuites(), true, false};
}

/// The sum of the CPU time of several stretches of work.
class CpuTimer
{
public:
    template<typename Work> void time(Work &&work)
    {
        const Duration start = metrics::threadCpuTime();
        work();
        m_sum += metrics::threadCpuTime() - start;
    }
    double nanosecondsEach(std::size_t count) const { return seconds(m_sum) * 1e9 / static_cast<double>(count); }

private:
    Duration m_sum{};
};

/// Runs the event loop and the far end until the session is up under the suite, and settled.
void bringUp(BareEnd &end, crypto::SuiteId suite);

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
    Traffic m_telemetry{kFrames};
    Traffic m_commands{kFrames, 255};
    std::unique_ptr<mavlink::FrameSigner> m_signer; ///< of the vehicle; null for a plain one
    std::vector<std::array<std::uint8_t, mavlink::kMaxFrameLength>> m_signed;
    std::vector<ByteView> m_fromVehicle;
    std::unique_ptr<engine::AgentCore> m_agent;
    std::uint16_t m_port = 0;
};

/// The minimum of any forwarder: wait, recvmmsg, sendmmsg.
class BareForwarder
{
public:
    double forward(std::size_t burst);

private:
    BareSocket m_from, m_middle, m_to;
    Traffic m_telemetry{kFrames};
};

/// The station's receive path up to the frames: link, channel, parser.
class Receiver final : private link::LinkListener
{
public:
    explicit Receiver(crypto::SuiteId suite);
    /// CPU nanoseconds for each of kFrames records of one frame that wait in the socket.
    double receive();

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;

    Introduced m_keys;
    std::unique_ptr<engine::SecretFiles> m_secrets;
    engine::LinkPool m_links;
    std::unique_ptr<engine::ChannelDriver> m_channel;
    mavlink::FrameIntake m_intake;
    std::unique_ptr<BareEnd> m_air;
    Traffic m_telemetry{kFrames};
    std::size_t m_received = 0;
};

/// A whole station: the same and vehicles, counters, snapshots; nothing is recorded.
class StationRig
{
public:
    /// `bound`: the systems that the agent's key is bound to; empty = any.
    explicit StationRig(crypto::SuiteId suite, std::vector<std::uint8_t> bound = {});
    ~StationRig();
    double receive();
    /// Frames accepted so far.
    std::uint64_t frames();
    /// Frames refused because their sender may not use system 1.
    std::uint64_t refused();

private:
    void awaitSnapshot();

    Introduced m_keys;
    std::unique_ptr<engine::StationCore> m_station;
    std::shared_ptr<const engine::Snapshot> m_snapshot = std::make_shared<engine::Snapshot>();
    std::unique_ptr<BareEnd> m_air;
    Traffic m_telemetry{kFrames};
};

} // namespace skyseal::test
