// Decides by the sender policy which MAVLink frames the station accepts, and counts the others: refused frames, those of other
// systems behind agents, and vehicles in clear that await the operator's approval. No I/O and no clock.
#pragma once

#include "core/engine/common/sender_policy.h"
#include "core/engine/station/frame_order.h"
#include "core/engine/station/other_systems.h"
#include "core/engine/station/pending_vehicles.h"
#include "core/engine/station/refusal_log.h"

#include <map>

namespace skyseal::engine {

/// Origin of frames, fixed when their link opens.
enum class FrameOrigin : std::uint8_t {
    Live,
    Recording, ///< the replay of a log
    ListenOnly ///< a stream of MAVSec's published code; nothing is sent to it
};

class FrameGate
{
public:
    enum class Verdict : std::uint8_t { Accept, Refuse, AwaitApproval };

    explicit FrameGate(SecureMode mode) : m_policy(mode) {}

    SenderPolicy &policy() { return m_policy; }
    const SenderPolicy &policy() const { return m_policy; }
    const RefusalLog &refusals() const { return m_refusals; }
    const OtherSystems &otherSystems() const { return m_otherSystems; }
    const PendingVehicles &pending() const { return m_pending; }

    void sessionUp(const channel::SessionUp &up);
    void sessionDown(channel::SessionId session);
    /// The operator accepts clear frames of this system.
    void allowPlaintext(std::uint8_t systemId);

    /// Judges a clear frame. `wasSealed`: in this run the vehicle has or had a session (used for
    /// recordings alone). Counts nothing.
    ///
    /// Recordings and listen-only streams are accepted, since the operator opened them as such. The recorded frames of a sealed
    /// vehicle can be replayed, but not if that vehicle is or was connected in this run.
    Verdict judgeClear(const Path &from, std::uint8_t systemId, FrameOrigin origin, bool wasSealed) const;
    /// Judges a sealed frame. Counts nothing.
    bool acceptSealed(channel::SessionId session, std::uint8_t systemId) { return m_policy.acceptSealed(session, systemId); }
    /// Notes an accepted frame of a delivery. Returns false if it must not change present values.
    bool isPresent(const mavlink::Frame &frame, const channel::Delivery &delivery);

    /// Counts a refused sealed frame. `announcesVehicle`: it is the heartbeat of an autopilot. Returns true if its system
    /// belongs to another peer, false if it is only another system behind the agent.
    bool refuseSealed(TimePoint now, channel::SessionId session, std::uint8_t systemId, bool announcesVehicle);
    /// Counts a refused clear frame. Returns the session to which it is charged, if any.
    std::optional<channel::SessionId> refuseClear(const Path &from, std::uint8_t systemId);
    /// Counts a frame that awaits approval. `isHeartbeat`: it announces a vehicle. Returns an event for the first heartbeat
    /// of each system.
    std::optional<PlaintextRefused> awaitApproval(TimePoint now, const Path &from, std::uint8_t systemId, bool isHeartbeat);
    /// A frame of this system was accepted from a live link.
    void heardLive(std::uint8_t systemId) { m_pending.release(systemId); }

    /// Publishes refusals and other systems that are due; call after each refusal and once a second.
    void publishRefusals(TimePoint now, const Notify &notify);
    void forgetSilent(TimePoint now)
    {
        m_pending.forgetSilent(now);
        m_policy.endClaims(now);
    }

private:
    void namePeerOfRefusal();

    SenderPolicy m_policy;
    RefusalLog m_refusals;
    OtherSystems m_otherSystems;
    PendingVehicles m_pending;
    std::map<channel::SessionId, std::string> m_peerNames;
    std::map<channel::SessionId, FrameOrder> m_orders;
};

} // namespace skyseal::engine
