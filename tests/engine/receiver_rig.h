// A station's receive path without a station.
#pragma once

#include "core/engine/common/link_pool.h"
#include "tests/engine/engine_rig.h"

#include <memory>

namespace skyseal::engine {
class ChannelDriver;
}

namespace skyseal::test {

/// The station's receive path up to the frames: link, channel, parser.
class Receiver final : private link::LinkListener
{
public:
    explicit Receiver(crypto::SuiteId suite);
    ~Receiver();
    /// CPU nanoseconds for each of kFrames records of one frame that wait in the socket.
    double receive();

private:
    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;

    Introduced m_keys;
    std::unique_ptr<engine::SecretFiles> m_secrets;
    engine::LinkPool m_links;
    std::unique_ptr<engine::ChannelDriver> m_channel;
    std::unique_ptr<BareEnd> m_air;
    SampleTraffic m_telemetry{kFrames};
    std::size_t m_received = 0;
};

} // namespace skyseal::test
