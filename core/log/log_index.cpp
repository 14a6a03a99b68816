#include "core/log/log_index.h"

#include "core/mavlink/enums.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace skyseal::tlog {

namespace {

/// Entries and events of several threads may be written a little out of order.
constexpr std::chrono::seconds kSetBack{1};

/// True if the two heartbeats show the same mode. The base mode counts only if there is no custom mode; its bit for arming is
/// no part of the mode.
bool isSameMode(const ModeChange &a, const ModeChange &b)
{
    const auto usesCustom = [](const ModeChange &mode) {
        return (mode.baseMode & mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED) != 0;
    };
    const auto base = [](const ModeChange &mode) { return mode.baseMode & ~mavlink::MAV_MODE_FLAG_SAFETY_ARMED; };
    if (usesCustom(a) != usesCustom(b) || a.type != b.type || a.autopilot != b.autopilot)
        return false;
    return usesCustom(a) ? a.customMode == b.customMode : base(a) == base(b);
}

} // namespace

LogIndexer::LogIndexer(std::istream &input, LinkEvents events)
    : m_reader(input, mavlink::Dialect::builtin()), m_events(std::move(events.events))
{
    m_index.unreadableEvents = events.unreadable;
}

template<typename T> void LogIndexer::list(std::vector<T> &entries, const T &entry)
{
    if (entries.size() < LogIndex::kListed)
        entries.push_back(entry);
    else
        ++m_index.omitted;
}

bool LogIndexer::read(std::size_t most)
{
    for (; most > 0; --most) {
        const auto item = m_reader.next();
        if (!item)
            return true;
        if (item->bytes.empty()) {
            ++m_index.damaged;
            continue;
        }
        const Duration before = m_time.position(), at = m_time.note(item->time);
        if (at - before > LogIndex::kGap)
            list(m_index.gaps, {before, at});
        if (item->time)
            takeEventsUntil(*item->time, at);
        ++m_index.frames;
        if (item->frame)
            takeFrame(*item->frame, at);
    }
    return false;
}

void LogIndexer::takeFrame(const mavlink::Frame &frame, Duration at)
{
    HeardVehicle &vehicle = m_heard[frame.systemId()];
    const mavlink::Heartbeat before{.type = vehicle.mode.type,
                                    .autopilot = vehicle.mode.autopilot,
                                    .base_mode = vehicle.mode.baseMode,
                                    .custom_mode = vehicle.mode.customMode};
    const auto heartbeat = mavlink::heartbeatOf(frame, before);
    if (!heartbeat)
        return;
    const mavlink::Heartbeat &message = *heartbeat;
    const mavlink::AutopilotClaim claim = mavlink::autopilotClaim(frame.componentId(), message);
    const bool known = vehicle.claim != mavlink::AutopilotClaim::None;
    const bool isAutopilot = known && frame.componentId() == vehicle.component;
    if (frame.systemId() == 0 || (!isAutopilot && claim <= vehicle.claim))
        return;
    const ModeChange mode{at, frame.systemId(), message.type, message.autopilot, message.base_mode, message.custom_mode};
    const bool armed = (message.base_mode & mavlink::MAV_MODE_FLAG_SAFETY_ARMED) != 0;
    if (!known)
        m_index.vehicles.push_back(frame.systemId());
    if (!known || !isSameMode(mode, vehicle.mode))
        list(m_index.modes, mode);
    if (armed && !vehicle.armed)
        vehicle.armedAt = at;
    else if (!armed && vehicle.armed)
        list(m_index.armed, {{vehicle.armedAt, at}, frame.systemId()});
    vehicle.claim = std::max(vehicle.claim, claim);
    vehicle.component = frame.componentId();
    vehicle.mode = mode;
    vehicle.armed = armed;
}

void LogIndexer::takeEventsUntil(WallTime time, Duration at)
{
    if (m_entryTime && *m_entryTime - time > kSetBack)
        ++m_entrySteps;
    m_entryTime = time;
    while (m_nextEvent < m_events.size()) {
        const WallTime noted = m_events[m_nextEvent].time;
        if (m_eventSteps > m_entrySteps || (m_eventSteps == m_entrySteps && noted > time))
            return;
        list(m_index.suites, {at, std::move(m_events[m_nextEvent])});
        if (++m_nextEvent < m_events.size() && noted - m_events[m_nextEvent].time > kSetBack)
            ++m_eventSteps;
    }
}

LogIndex LogIndexer::take()
{
    m_entrySteps = std::numeric_limits<int>::max(); // whatever is left
    takeEventsUntil(WallTime::max(), m_time.position());
    m_index.first = m_time.first();
    m_index.length = m_time.position();
    for (const std::uint8_t systemId : m_index.vehicles) {
        HeardVehicle &vehicle = m_heard[systemId];
        if (std::exchange(vehicle.armed, false))
            list(m_index.armed, {{vehicle.armedAt, m_index.length}, systemId});
    }
    return std::move(m_index);
}

std::vector<LinkEvent> protectionAt(const LogIndex &index, Duration at, std::uint8_t systemId)
{
    const std::string vehicle = std::to_string(systemId);
    std::vector<LinkEvent> out;
    for (const SuiteMark &mark : index.suites) {
        const bool isPlain = mark.event.kind == LinkEvent::Kind::Plain;
        if (mark.at > at || (isPlain && mark.event.peer != vehicle))
            continue;
        if (isPlain)
            out.clear(); // no peer before that was its own
        else
            std::erase_if(
                out, [&](const LinkEvent &one) { return one.kind == LinkEvent::Kind::Plain || one.peer == mark.event.peer; });
        out.push_back(mark.event);
    }
    return out;
}

LogIndex indexOf(std::istream &input, LinkEvents events)
{
    LogIndexer indexer(input, std::move(events));
    indexer.read(std::numeric_limits<std::size_t>::max());
    return indexer.take();
}

} // namespace skyseal::tlog
