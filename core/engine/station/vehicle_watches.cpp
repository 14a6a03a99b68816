#include "core/engine/station/vehicle_watches.h"

namespace skyseal::engine {

const VehicleWatches::Watch *VehicleWatches::find(std::uint8_t systemId) const
{
    const auto found = m_watches.find(systemId);
    return found == m_watches.end() ? nullptr : &found->second;
}

void VehicleWatches::heard(std::uint8_t systemId, const Path &from, std::optional<channel::SessionId> session)
{
    Watch &watch = m_watches[systemId];
    watch.from = from;
    watch.session = session;
    watch.ended.reset();
}

bool VehicleWatches::isHeardOver(std::uint8_t systemId, const Path &from, std::optional<channel::SessionId> session) const
{
    const Watch *watch = find(systemId);
    return watch && watch->session == session && (session || watch->from.sharesPlace(from));
}

bool VehicleWatches::isHeardIn(std::uint8_t systemId, channel::SessionId session) const
{
    const Watch *watch = find(systemId);
    return watch && watch->session == session;
}

void VehicleWatches::sessionUp(const channel::SessionUp &up)
{
    for (auto &[systemId, watch] : m_watches) {
        if (!watch.ended || watch.ended->peer != up.peer)
            continue;
        watch.session = up.session;
        watch.ended.reset();
    }
}

void VehicleWatches::sessionDown(channel::SessionId session, const SessionEnd &end)
{
    for (auto &[systemId, watch] : m_watches) {
        if (watch.session != session)
            continue;
        if (end.successor)
            watch.session = end.successor;
        else
            watch.ended = end;
    }
}

Presence VehicleWatches::sample(std::uint8_t systemId, const metrics::SequenceCounts &counts, bool lost)
{
    const auto found = m_watches.find(systemId);
    if (found == m_watches.end())
        return Presence::Unchanged;
    Watch &watch = found->second;
    watch.loss.note(counts.received - counts.duplicate, counts.lost);
    watch.frames.note(counts.received);
    if (lost == watch.lost)
        return Presence::Unchanged;
    watch.lost = lost;
    return lost ? Presence::Lost : Presence::Back;
}

bool VehicleWatches::isEnded(std::uint8_t systemId) const
{
    const Watch *watch = find(systemId);
    return watch && watch->ended;
}

bool VehicleWatches::isOrWasSealed(std::uint8_t systemId) const
{
    const Watch *watch = find(systemId);
    return watch && (watch->session || watch->ended);
}

void VehicleWatches::describe(TimePoint now, std::uint8_t systemId, VehicleSnapshot &out) const
{
    const Watch *watch = find(systemId);
    if (!watch)
        return;
    out.link = watch->from.link;
    out.session = watch->session;
    if (watch->ended)
        out.ended = EndedSession{watch->ended->peerName, watch->ended->reason, seconds(now - watch->ended->at)};
    out.lossPercent = watch->loss.percent();
    out.framesPerSecond = static_cast<double>(watch->frames.value());
}

} // namespace skyseal::engine
