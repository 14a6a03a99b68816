#include "tests/engine/receiver_rig.h"

#include "core/channel/endpoint.h"
#include "core/engine/common/channel_driver.h"
#include "core/link/steady_now.h"
#include "core/mavlink/frame_intake.h"
#include "tests/support/addresses.h"

#include <QtCore/QCoreApplication>

namespace skyseal::test {

Receiver::Receiver(crypto::SuiteId suite)
    : m_secrets(m_keys.secrets(channel::Role::Station)), m_links(*this, [](link::Link &) {})
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

Receiver::~Receiver() = default;

void Receiver::linkReceived(link::Link &, std::span<const link::ReceivedBlock> blocks)
{
    for (const link::ReceivedBlock &block : blocks) {
        const auto delivery = m_channel->receive(block.time, block.path, block.bytes);
        if (!delivery)
            continue;
        std::size_t frames = 0;
        mavlink::scanFrames(delivery->frames, mavlink::Dialect::builtin(),
                            [&](const mavlink::ScanItem &item) { frames += item.frame.has_value(); });
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

} // namespace skyseal::test
