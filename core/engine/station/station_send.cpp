// The part of StationCore that sends: what the vehicles' dialogues want said, heartbeats, and a word to routers.
#include "core/engine/station/station_core.h"

#include "core/mavlink/frame_writer.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

/// The role stands in the agent's list alone, and to an observer's commands it is silent.
const std::string kMaybeObserver = "; the agent may know this station as an observer, whose commands it drops";

} // namespace

void StationCore::serveVehicles(TimePoint now)
{
    for (auto &[systemId, vehicle] : m_vehicles.all())
        serveVehicle(now, systemId, vehicle);
}

void StationCore::serveVehicle(TimePoint now, std::uint8_t systemId, vehicle::Vehicle &vehicle)
{
    Route *route = m_routes.leadingTo(systemId);
    while (const auto message = vehicle.pollOutgoing()) {
        if (route)
            send(now, *route, *message);
    }
    const bool sealed = route && route->session && !vehicle.isLost(now);
    while (auto result = vehicle.pollResult()) {
        if (sealed && result->unanswered)
            result->reason += kMaybeObserver;
        notify(std::move(*result));
    }
    while (auto text = vehicle.pollText())
        notify(TextReceived{systemId, std::move(*text)});
    while (auto done = vehicle.pollMissionResult()) {
        if (sealed && done->unanswered && done->transfer != vehicle::MissionTransfer::Download)
            done->reason += kMaybeObserver;
        notify(MissionTransferDone{systemId, done->transfer == vehicle::MissionTransfer::Upload, done->ok,
                                   std::move(done->reason)});
    }
    while (auto written = vehicle.pollParameterResult()) {
        if (sealed && written->unanswered)
            written->reason += kMaybeObserver;
        notify(ParameterWritten{systemId, std::move(written->parameter), written->ok, std::move(written->reason)});
    }
}

void StationCore::sendHeartbeats(TimePoint now)
{
    const auto message = m_heartbeat.poll(now);
    // Vehicles act on its absence; nobody may send it for an operator whose screen stands still.
    if (!message || !m_readerAlive)
        return;
    for (Route &route : m_routes.all()) {
        if (mayBeatAt(route))
            send(now, route, *message);
    }
}

/// An autopilot that hears its station's heartbeat in clear, through a router beside the agent, would not act when the sealed
/// link is dead. So a station that knows agents beats in clear only where it took a vehicle in clear, and where none of them
/// is or was.
bool StationCore::mayBeatAt(const Route &route) const
{
    if (route.session || !isSealing() || !m_policy.knowsAnybody())
        return true;
    const std::vector<channel::Unanswered> silent = m_channel->endpoint().unanswered();
    return route.heard && !m_policy.sealedSpokeAt(route.path)
        && std::none_of(silent.begin(), silent.end(),
                        [&](const channel::Unanswered &agent) { return agent.path.sharesPlace(route.path); });
}

void StationCore::send(TimePoint now, Route &route, const vehicle::OutMessage &message)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView frame = mavlink::writeFrame(buffer, 2, route.sequence, m_config.systemId, m_config.componentId, message.id,
                                               message.crcExtra, message.minLength, message.view());
    if (frame.empty())
        return;
    ++route.sequence;
    if (m_recorder)
        m_recorder->record(wallNow(), frame);
    if (route.session)
        m_channel->queue(now, *route.session, frame);
    else if (!isSealing() || !m_carriers.isCobs(route.path, now)) // where a clear frame would spoil what follows it
        m_links.send(route.path, frame);
}

/// A router that listens for us learns where we are from what we say; an agent behind it is not heard before. Not by a
/// heartbeat: a station's, in clear, would keep up the hopes of an autopilot whose sealed link is dead.
void StationCore::greetRouters()
{
    std::vector<LinkId> served;
    for (const channel::SessionId session : m_channel->endpoint().sessions())
        served.push_back(m_channel->endpoint().recordPath(session).link);
    m_links.forEach([&](const link::Link &link) {
        const bool calls = link.url().scheme() == link::LinkScheme::UdpOut && maySeal(link);
        if (calls && std::find(served.begin(), served.end(), link.id()) == served.end())
            m_links.send({link.id(), {}}, m_links.carriers().hello());
    });
}

} // namespace skyseal::engine
