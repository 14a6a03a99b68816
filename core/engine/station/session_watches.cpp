#include "core/engine/station/session_watches.h"

#include <algorithm>

namespace skyseal::engine {

SessionWatches::Watch *SessionWatches::find(channel::SessionId session)
{
    const auto found = m_watches.find(session);
    return found == m_watches.end() ? nullptr : &found->second;
}

void SessionWatches::sessionUp(const channel::SessionUp &up)
{
    Watch &watch = m_watches[up.session];
    watch.peer = up.peer;
    watch.peerName = up.peerName;
}

std::optional<SessionEnd> SessionWatches::sessionDown(TimePoint now, const channel::SessionDown &down)
{
    const Watch *watch = find(down.session);
    if (!watch)
        return std::nullopt;
    SessionEnd out{watch->peer, watch->peerName, down.reason, now, {}};
    m_watches.erase(down.session);
    const auto next = std::ranges::find_if(m_watches, [&](const auto &other) { return other.second.peer == out.peer; });
    if (next != m_watches.end())
        out.successor = next->first;
    return out;
}

void SessionWatches::noteQuarter(channel::SessionId session, const channel::SessionStats &stats)
{
    if (Watch *watch = find(session)) {
        watch->loss.note(stats.rx.good, stats.rx.lost);
        watch->peerLoss.note(stats.peerRx.good, stats.peerRx.lost);
    }
}

void SessionWatches::noteSecond(channel::SessionId session, const channel::SessionStats &stats)
{
    if (Watch *watch = find(session)) {
        watch->forged.note(stats.rx.forged);
        watch->replayed.note(stats.rx.replayed);
        watch->good.note(stats.rx.good);
    }
}

void SessionWatches::describe(channel::SessionId session, SessionSnapshot &out) const
{
    const auto found = m_watches.find(session);
    if (found == m_watches.end())
        return;
    const Watch &watch = found->second;
    out.forgedLastMinute = static_cast<std::uint64_t>(watch.forged.value());
    out.goodLastMinute = static_cast<std::uint64_t>(watch.good.value());
    out.replayedLastMinute = static_cast<std::uint64_t>(watch.replayed.value());
    out.lossPercent = watch.loss.percent();
    out.peerLossPercent = watch.peerLoss.percent();
}

const std::string *SessionWatches::peerName(channel::SessionId session) const
{
    const auto found = m_watches.find(session);
    return found == m_watches.end() ? nullptr : &found->second.peerName;
}

} // namespace skyseal::engine
