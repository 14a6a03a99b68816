#include "core/engine/station/fleet.h"

#include "core/vehicle/message_io.h"
#include "core/vehicle/reasons.h"

#include <numeric>

namespace skyseal::engine {

namespace {

vehicle::VehicleConfig vehicleConfig(const StationConfig &config)
{
    vehicle::VehicleConfig out;
    out.ownSystemId = config.systemId;
    out.ownComponentId = config.componentId;
    out.streams = config.lowBandwidth ? vehicle::StreamProfile::LowBandwidth : vehicle::StreamProfile::Standard;
    out.streamRate = config.streamRate;
    out.timeSyncEvery = config.timeSyncEvery;
    return out;
}

} // namespace

Fleet::Fleet(const StationConfig &config) : m_vehicles(vehicleConfig(config)) {}

std::optional<VehicleFound> Fleet::take(TimePoint now, WallTime wall, const Path &from, const mavlink::Frame &frame,
                                        std::optional<channel::SessionId> session)
{
    const std::uint8_t systemId = frame.systemId();
    m_messages.note(frame.messageId());
    // A session may move to another address within one sequence; clear frames of each address have their own.
    if (session)
        m_sealed.note({from.link, systemId, frame.componentId()}, frame, now);
    else
        m_clear.note({from.link, systemId, frame.componentId(), from.remote}, frame, now);
    m_inspector.note(now, frame);
    m_fields.note(now, frame);
    if (frame.messageId() == mavlink::RadioStatus::kId)
        takeRadioStatus(from, frame, session);
    if (frame.messageId() == mavlink::Statustext::kId && !session && m_copies.isCopy(now, from, frame))
        return std::nullopt;
    const bool found = m_vehicles.handleFrame(now, wall, frame);
    const vehicle::Vehicle *vehicle = m_vehicles.find(systemId);
    if (!vehicle)
        return std::nullopt;
    m_watches.heard(systemId, from, session);
    if (!found)
        return std::nullopt;
    return VehicleFound{systemId, vehicle->current().type, vehicle->current().autopilot, session.has_value()};
}

void Fleet::takeRadioStatus(const Path &from, const mavlink::Frame &frame, std::optional<channel::SessionId> session)
{
    const auto status = vehicle::unpack<mavlink::RadioStatus>(frame);
    for (auto &[systemId, vehicle] : m_vehicles.all()) {
        if (m_watches.isHeardOver(systemId, from, session))
            vehicle.handleRadioStatus(status);
    }
}

void Fleet::takeLate(TimePoint now, const Path &from, const mavlink::Frame &frame)
{
    m_messages.note(frame.messageId());
    m_sealed.note({from.link, frame.systemId(), frame.componentId()}, frame, now);
    if (vehicle::Vehicle *vehicle = m_vehicles.find(frame.systemId()))
        vehicle->handleLateFrame(now, frame);
}

bool Fleet::forget(TimePoint now, std::uint8_t systemId)
{
    const vehicle::Vehicle *vehicle = m_vehicles.find(systemId);
    if (!vehicle || !vehicle->isLost(now))
        return false;
    m_vehicles.forget(systemId);
    m_watches.forget(systemId);
    return true;
}

void Fleet::publishEvents(vehicle::Vehicle &vehicle, bool sealed, const Notify &notify)
{
    const auto publish = [&](auto &event) {
        if constexpr (requires { event.changeUnanswered; }) {
            if (sealed && event.changeUnanswered)
                event.reason = vehicle::reasons::kMaybeDropped(std::move(event.reason));
        }
        notify(std::move(event));
    };
    while (auto event = vehicle.pollEvent())
        std::visit(publish, *event);
}

bool Fleet::sample(TimePoint now, const Notify &notify)
{
    bool anyHeard = false;
    for (const auto &[systemId, vehicle] : m_vehicles.all()) {
        const bool lost = vehicle.isLost(now);
        anyHeard = anyHeard || (!lost && !m_watches.isEnded(systemId));
        switch (m_watches.sample(systemId, countsOf(systemId), lost)) {
        case Presence::Unchanged: break;
        case Presence::Lost: notify(VehicleLost{systemId}); break;
        case Presence::Back: notify(VehicleBack{systemId}); break;
        }
    }
    return anyHeard;
}

double Fleet::latency(TimePoint now) const
{
    double latency = vehicle::kUnknown;
    TimePoint heard = TimePoint::min();
    for (const auto &[systemId, vehicle] : m_vehicles.all()) {
        const vehicle::VehicleState &state = vehicle.current();
        if (state.lastMessage >= heard && !vehicle.isLost(now)) {
            heard = state.lastMessage;
            latency = state.latency;
        }
    }
    return latency;
}

void Fleet::Received::note(const metrics::SequenceTable::Sender &sender, const mavlink::Frame &frame, TimePoint now)
{
    sequences.note(sender, frame.sequence(), now);
    bytes[sender.system] += frame.bytes().size();
}

MavlinkTotals Fleet::Received::totals() const
{
    const metrics::SequenceCounts counts = sequences.total();
    const std::uint64_t all = std::accumulate(bytes.begin(), bytes.end(), std::uint64_t(0));
    return {counts.received, counts.lost, counts.late, counts.duplicate, 0, sequences.evicted(), all};
}

MavlinkTotals Fleet::Received::totalsOf(std::uint8_t systemId) const
{
    const metrics::SequenceCounts counts = sequences.countsOfSystem(systemId);
    return {counts.received, counts.lost, counts.late, counts.duplicate, 0, 0, bytes[systemId]};
}

metrics::SequenceCounts Fleet::countsOf(std::uint8_t systemId) const
{
    metrics::SequenceCounts out = m_sealed.sequences.countsOfSystem(systemId);
    out += m_clear.sequences.countsOfSystem(systemId);
    return out;
}

MavlinkTotals Fleet::totals() const
{
    MavlinkTotals out = m_sealed.totals();
    out += m_clear.totals();
    return out;
}

MavlinkTotals Fleet::sealedTotals(channel::SessionId session) const
{
    MavlinkTotals out;
    for (const auto &[systemId, vehicle] : m_vehicles.all()) {
        if (m_watches.isHeardIn(systemId, session))
            out += m_sealed.totalsOf(systemId);
    }
    return out;
}

VehicleSnapshot Fleet::describe(TimePoint now, const vehicle::Vehicle &vehicle) const
{
    VehicleSnapshot out;
    out.state = vehicle.state(now);
    const metrics::SequenceCounts counts = countsOf(vehicle.systemId());
    out.state.sequence = {counts.received, counts.lost, counts.late, counts.duplicate};
    m_watches.describe(now, vehicle.systemId(), out);
    out.parameters = vehicle.parameters();
    out.parametersExpected = vehicle.parametersExpected();
    out.mission = vehicle.mission();
    out.fence = vehicle.fence();
    out.rally = vehicle.rally();
    out.missionOutdated = vehicle.outdated(vehicle::MissionType::Mission);
    out.fenceOutdated = vehicle.outdated(vehicle::MissionType::Fence);
    out.rallyOutdated = vehicle.outdated(vehicle::MissionType::Rally);
    return out;
}

} // namespace skyseal::engine
