// Counts the frames that a station refuses and publishes events about them, at most one a second and kind, so that an attacker
// cannot flood the operator. No I/O and no clock; addresses become text only when an event is due.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/engine/station/event.h"

#include <optional>

namespace skyseal::engine {

class RefusalLog
{
public:
    static constexpr Duration kEvery = std::chrono::seconds(1);

    /// Counts a clear frame with the id of a system that must be sealed.
    void refusePlaintext(std::uint8_t systemId, const Address &from);
    /// Counts a sealed frame of a system that its peer may not use. The session must be up.
    void refuseSystem(std::uint8_t systemId, channel::SessionId session);

    /// The session of the pending SystemRefused event, whose peer has to be named before the event is taken or the session
    /// ends; nullopt if no such event is pending.
    std::optional<channel::SessionId> unnamedSession() const;
    /// The system id of that event.
    std::uint8_t refusedSystem() const { return m_systems.pending.systemId; }
    /// `owner`: the peer to which the system belongs; empty if there is none.
    void namePeer(std::string peer, std::string owner);

    bool isSystemDue(TimePoint now) const { return m_systems.isDue(now); }
    /// The events that are due; nullopt otherwise.
    std::optional<PlaintextRefused> takePlaintext(TimePoint now);
    std::optional<SystemRefused> takeSystem(TimePoint now);

    /// Frames since the start.
    std::uint64_t plaintextFrames() const { return m_plaintext.total; }
    std::uint64_t systemFrames() const { return m_systems.total; }

private:
    template<typename Refused> struct Counter
    {
        std::uint64_t total = 0;
        Refused pending;
        TimePoint notified = TimePoint::min();

        void count(std::uint8_t systemId)
        {
            ++total;
            ++pending.frames;
            pending.systemId = systemId;
        }
        bool isDue(TimePoint now) const
        {
            return pending.frames > 0 && (notified == TimePoint::min() || now - notified >= kEvery);
        }
        std::optional<Refused> take(TimePoint now);
    };

    Counter<PlaintextRefused> m_plaintext;
    Address m_plaintextFrom; ///< of the newest clear frame
    Counter<SystemRefused> m_systems;
    channel::SessionId m_session{}; ///< of the newest sealed frame
};

} // namespace skyseal::engine
