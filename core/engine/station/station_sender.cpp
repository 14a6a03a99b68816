#include "core/engine/station/station_sender.h"

#include "core/channel/endpoint.h"
#include "core/link/steady_now.h"
#include "core/mavlink/frame_writer.h"

#include <algorithm>

namespace skyseal::engine {

void StationSender::setChannel(StationChannel *channel, bool sealing)
{
    m_channel = channel;
    m_sealing = sealing;
}

void StationSender::followLink(const link::Link &link, bool mayBeClear)
{
    const link::LinkState state = link.state();
    if (state == link::LinkState::Connected && link.traits().hasOneRemote && mayBeClear && !m_links.isListenOnly(link.id()))
        m_routes.addFixed({link.id(), link.remote()});
    else if (state == link::LinkState::Waiting || state == link::LinkState::Closed)
        m_routes.removeLink(link.id());
}

bool StationSender::sendOutgoing(TimePoint now, std::uint8_t systemId, vehicle::Vehicle &vehicle)
{
    Route *route = m_routes.leadingTo(systemId);
    while (const vehicle::OutMessage *message = vehicle.pollOutgoing()) {
        if (route)
            send(now, *route, *message, message->version != 0 ? message->version : vehicle.current().mavlinkVersion);
    }
    return route && route->session;
}

void StationSender::forward(TimePoint now, std::uint8_t systemId, ByteView frame, const SenderPolicy &policy)
{
    if (systemId != 0) {
        if (const Route *route = m_routes.leadingTo(systemId))
            transmit(now, *route, frame);
        return;
    }
    for (const Route &route : m_routes.all()) {
        if (mayHeartbeat(route, policy))
            transmit(now, route, frame);
    }
}

void StationSender::sendHeartbeats(TimePoint now, const SenderPolicy &policy)
{
    const auto message = m_heartbeat.poll(now);
    if (!message || !m_readerAlive)
        return;
    for (Route &route : m_routes.all()) {
        if (mayHeartbeat(route, policy))
            send(now, route, *message, route.version1.any() ? 1 : 2);
    }
}

/// An autopilot that receives its station's heartbeat in clear, through a router beside the agent, would not act when the
/// sealed link fails. Therefore a station that knows agents sends clear heartbeats only to addresses where it accepted a
/// vehicle in clear and where no agent is or was.
bool StationSender::mayHeartbeat(const Route &route, const SenderPolicy &policy) const
{
    if (route.highLatency)
        return false;
    if (route.session || !m_sealing || !policy.knowsAnybody())
        return true;
    const std::vector<channel::Unanswered> silent = m_channel->endpoint().unanswered();
    return route.heard && !policy.sealedSpokeAt(route.path)
        && std::none_of(silent.begin(), silent.end(),
                        [&](const channel::Unanswered &agent) { return agent.path.sharesPlace(route.path); });
}

void StationSender::send(TimePoint now, Route &route, const vehicle::OutMessage &message, int version)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView frame = mavlink::writeFrame(buffer, version, route.sequence, m_self.system, m_self.component, message.id,
                                               message.crcExtra, message.minLength, message.view());
    if (frame.empty())
        return;
    ++route.sequence;
    transmit(now, route, frame);
}

void StationSender::transmit(TimePoint now, const Route &route, ByteView frame)
{
    if (m_recorder)
        m_recorder->record(wallNow(), frame);
    if (route.session)
        m_channel->driver.queue(now, *route.session, frame);
    else if (!m_sealing || !m_ingress.isCobs(route.path, now)) // a clear frame would damage the next COBS frame
        m_links.send(route.path, frame);
}

/// A router that waits for connections learns the station's address from the first datagram; before, nothing from agents behind
/// it arrives. A heartbeat is not suitable: in clear, it would keep an autopilot from acting when the sealed link fails.
void StationSender::greetRouters()
{
    std::vector<LinkId> served;
    for (const channel::SessionId session : m_channel->endpoint().sessions())
        served.push_back(m_channel->endpoint().recordPath(session).link);
    m_links.forEach([&](const link::Link &link) {
        const bool calls = link.traits().isDatagramClient() && !m_links.isListenOnly(link.id());
        if (calls && std::find(served.begin(), served.end(), link.id()) == served.end())
            m_links.send({link.id(), {}}, m_links.carriers().hello());
    });
}

} // namespace skyseal::engine
