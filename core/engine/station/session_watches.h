// Measurements of a station for each session, beside the session's own counters: loss over the last second and suspicious
// records over the last minute. Fed with the counters at a steady pace; no I/O and no clock.
#pragma once

#include "core/channel/events.h"
#include "core/engine/common/loss_meter.h"
#include "core/engine/station/session_snapshot.h"

#include <map>
#include <optional>
#include <string>

namespace skyseal::engine {

/// A session that ended, for the parts that refer to it.
struct SessionEnd
{
    channel::PublicKey peer{};
    std::string peerName;
    channel::DownReason reason{};
    TimePoint at;
    std::optional<channel::SessionId> successor; ///< another session with the same peer that is up
};

class SessionWatches
{
public:
    void sessionUp(const channel::SessionUp &up);
    /// Returns nullopt for an unknown session.
    std::optional<SessionEnd> sessionDown(TimePoint now, const channel::SessionDown &down);

    /// Call for each session four times a second.
    void noteQuarter(channel::SessionId session, const channel::SessionStats &stats);
    /// Call for each session once a second.
    void noteSecond(channel::SessionId session, const channel::SessionStats &stats);

    /// Sets the fields that are measured here; does not change the others.
    void describe(channel::SessionId session, SessionSnapshot &out) const;
    /// The peer's name when the session came up; null for a session that is not known.
    const std::string *peerName(channel::SessionId session) const;

private:
    struct Watch
    {
        channel::PublicKey peer{};
        std::string peerName;
        LossMeter loss, peerLoss;
        Growth<60> forged, replayed, good; ///< one reading a second
    };

    Watch *find(channel::SessionId session);

    std::map<channel::SessionId, Watch> m_watches;
};

} // namespace skyseal::engine
