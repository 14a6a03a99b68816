#include "core/engine/station/frame_gate.h"

#include "core/link/address_text.h"

namespace skyseal::engine {

void FrameGate::sessionUp(const channel::SessionUp &up)
{
    m_policy.sessionUp(up.session, up.peer, up.path);
    m_peerNames[up.session] = up.peerName;
    m_orders[up.session] = {};
}

void FrameGate::sessionDown(channel::SessionId session)
{
    namePeerOfRefusal(); // while the session's peer is known
    m_policy.sessionDown(session);
    m_peerNames.erase(session);
    m_orders.erase(session);
}

void FrameGate::allowPlaintext(std::uint8_t systemId)
{
    m_policy.allowPlaintext(systemId);
    m_pending.release(systemId);
}

FrameGate::Verdict FrameGate::judgeClear(const Path &from, std::uint8_t systemId, FrameOrigin origin, bool wasSealed) const
{
    if (m_policy.acceptClear(from, systemId))
        return Verdict::Accept;
    if (origin == FrameOrigin::Recording) {
        const bool isSealed = wasSealed || m_policy.sessionConcerned(from, systemId);
        return isSealed ? Verdict::Refuse : Verdict::Accept;
    }
    if (!m_policy.needsApproval(from, systemId))
        return Verdict::Refuse;
    return origin == FrameOrigin::Live ? Verdict::AwaitApproval : Verdict::Accept;
}

bool FrameGate::refuseSealed(TimePoint now, channel::SessionId session, std::uint8_t systemId, bool announcesVehicle)
{
    const auto name = m_peerNames.find(session);
    const bool others = name == m_peerNames.end() || m_policy.belongsToAnother(systemId, session);
    if (others)
        m_refusals.refuseSystem(systemId, session);
    else
        m_otherSystems.note(now, name->second, systemId, announcesVehicle);
    return others;
}

bool FrameGate::isPresent(const mavlink::Frame &frame, const channel::Delivery &delivery)
{
    const auto order = m_orders.find(delivery.session);
    return order == m_orders.end() || order->second.note(frame, delivery);
}

std::optional<channel::SessionId> FrameGate::refuseClear(const Path &from, std::uint8_t systemId)
{
    m_refusals.refusePlaintext(systemId, from.remote);
    return m_policy.sessionConcerned(from, systemId);
}

std::optional<PlaintextRefused> FrameGate::awaitApproval(TimePoint now, const Path &from, std::uint8_t systemId,
                                                         bool isHeartbeat)
{
    m_pending.count(); // not counted as a refusal: a vehicle that awaits approval is no sign of an attack
    if (!isHeartbeat)
        return std::nullopt;
    const std::string address = link::toText(from.remote);
    if (!m_pending.note(now, systemId, address))
        return std::nullopt;
    return PlaintextRefused{systemId, address, 1, m_policy.neverHeard()};
}

void FrameGate::namePeerOfRefusal()
{
    const auto session = m_refusals.unnamedSession();
    const auto name = session ? m_peerNames.find(*session) : m_peerNames.end();
    if (name != m_peerNames.end())
        m_refusals.namePeer(name->second, m_policy.ownerOf(m_refusals.refusedSystem(), *session));
}

void FrameGate::publishRefusals(TimePoint now, const Notify &notify)
{
    if (auto refused = m_refusals.takePlaintext(now))
        notify(std::move(*refused));
    if (auto heard = m_otherSystems.take(now))
        notify(std::move(*heard));
    if (!m_refusals.isSystemDue(now))
        return;
    namePeerOfRefusal();
    if (auto refused = m_refusals.takeSystem(now))
        notify(std::move(*refused));
}

} // namespace skyseal::engine
