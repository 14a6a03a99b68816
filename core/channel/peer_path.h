// The path of a session's records. It follows the peer's authenticated records; a new path is on trial until the peer has
// received something there (PROTOCOL.md, section 6, "Address"). Moves are reported to the owner at most once a second.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/interval_limit.h"

#include <cstdint>
#include <optional>

namespace skyseal::channel {

class PeerPath
{
public:
    struct Move
    {
        Path from; ///< the path of which the owner was last notified
        Path to;
    };

    /// `trial`: time without a record from a path on trial after which the session returns to the former path. `heard`: an
    /// authentic message of the peer came from `path`. A first message proves nothing, since anyone can send a copy of it.
    PeerPath(const Path &path, TimePoint now, Duration trial, bool heard = true);

    const Path &current() const { return m_current; }
    /// Path of the handshake.
    const Path &origin() const { return m_origin; }
    TimePoint deadline() const;

    /// The newest record so far came from the current path.
    void stay(TimePoint now)
    {
        m_heardHere = now;
        m_heard = true;
    }
    // Stamps and echoes are those of the session clock in full: modulo 2^32, an echo that was withheld for 36 minutes would
    // look newer than the move.

    /// The newest record so far came from another path. `stamp` is the session clock at this time.
    void moveTo(const Path &path, TimePoint now, std::uint64_t stamp);
    /// A report with this stamp goes to `to`. An echo of it proves nothing about the current path if that is another one.
    void reportSent(const Path &to, std::uint64_t stamp);
    /// A report from `from` echoes the stamp `echo`. Ends the trial if the peer sent it after receiving a report at this path.
    void confirm(const Path &from, std::uint64_t echo);
    /// Returns false if a trial has failed and no path is left where the peer was heard before.
    bool handleDeadline(TimePoint now);
    /// Returns a move of which the owner is to be notified now, at most one a second.
    std::optional<Move> takeMove(TimePoint now);

private:
    void endTrial();

    Path m_origin;
    Path m_current;
    Path m_notified;
    IntervalLimit m_moves;
    Duration m_trial;
    bool m_heard;                   ///< the current path is one where the peer was heard
    bool m_onTrial = false;         ///< the current path is
    std::optional<Path> m_former;   ///< during a trial: the last path that was not on trial, if the peer was heard there
    std::uint64_t m_trialStamp = 0; ///< later stamps were sent to the current path alone
    TimePoint m_heardHere;          ///< newest record from the current path
};

} // namespace skyseal::channel
