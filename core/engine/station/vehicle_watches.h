// A station's records about each vehicle beside the vehicle's own state: the path and session over which it was heard last, the
// end of that session, whether it is lost, and the loss of its frames. No I/O and no clock.
#pragma once

#include "core/engine/common/loss_meter.h"
#include "core/engine/station/session_watches.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/metrics/sequence_table.h"

#include <map>
#include <optional>

namespace skyseal::engine {

/// Findings about a vehicle from four readings a second.
enum class Presence : std::uint8_t { Unchanged, Lost, Back };

class VehicleWatches
{
public:
    /// A frame of a known vehicle was accepted; `session` is empty for clear frames.
    void heard(std::uint8_t systemId, const Path &from, std::optional<channel::SessionId> session);
    /// Whether the vehicle was heard last over this session, or in clear from this link and address.
    bool isHeardOver(std::uint8_t systemId, const Path &from, std::optional<channel::SessionId> session) const;
    /// Whether the vehicle was heard last in this session, from anywhere.
    bool isHeardIn(std::uint8_t systemId, channel::SessionId session) const;
    /// Assigns vehicles of this peer whose former session ended to the new one.
    void sessionUp(const channel::SessionUp &up);
    void sessionDown(channel::SessionId session, const SessionEnd &end);

    /// Call four times a second for each vehicle, with the counts of all its frames and whether its heartbeat is overdue.
    Presence sample(std::uint8_t systemId, const metrics::SequenceCounts &counts, bool lost);
    void forget(std::uint8_t systemId) { m_watches.erase(systemId); }
    /// The session over which the vehicle was heard ended, and the peer has no other.
    bool isEnded(std::uint8_t systemId) const;
    /// The vehicle has a session, or had one when it was heard last.
    bool isOrWasSealed(std::uint8_t systemId) const;

    /// Sets the fields that are recorded here; does not change the others.
    void describe(TimePoint now, std::uint8_t systemId, VehicleSnapshot &out) const;

private:
    struct Watch
    {
        Path from;
        std::optional<channel::SessionId> session;
        std::optional<SessionEnd> ended; ///< of `session`
        LossMeter loss;
        Growth<4> frames;
        bool lost = false;
    };

    const Watch *find(std::uint8_t systemId) const;

    std::map<std::uint8_t, Watch> m_watches;
};

} // namespace skyseal::engine
