#include "core/engine/agent/command_gate.h"

#include "core/engine/common/misreading.h"
#include "core/engine/agent/observer_rules.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

namespace {

/// The system id of most ground stations; reserved even before one connects.
constexpr std::uint8_t kCustomaryGroundSystem = 255;

std::uint64_t AgentCounters::*counterOf(FramesRefused::Reason reason)
{
    switch (reason) {
    case FramesRefused::Reason::Observer: return &AgentCounters::observerRefused;
    case FramesRefused::Reason::System: return &AgentCounters::spoofRefused;
    case FramesRefused::Reason::TooOften: return &AgentCounters::observerTooOften;
    case FramesRefused::Reason::Late: break;
    }
    return &AgentCounters::lateRefused;
}

} // namespace

void CommandGate::setPeers(const std::vector<channel::Peer> &peers)
{
    m_policy.setPeers(peers);
    m_questions.setPeers(peers);
}

void CommandGate::sessionUp(const channel::SessionUp &up)
{
    m_policy.sessionUp(up.session, up.peer, up.path);
    m_senders[up.session] = {up.peer, up.peerName};
}

void CommandGate::sessionDown(channel::SessionId session)
{
    m_policy.sessionDown(session);
    m_senders.erase(session);
}

bool CommandGate::isGroundSystem(std::uint8_t systemId) const
{
    return systemId == kCustomaryGroundSystem || m_policy.isPilotsSystem(systemId);
}

bool CommandGate::mayCommand(TimePoint now, const channel::Delivery &delivery, const mavlink::ScanItem &item)
{
    using Reason = FramesRefused::Reason;
    const bool isPilot = m_policy.mayCommand(delivery.session);
    if (isPilot && delivery.freshness == channel::Freshness::Fresh)
        return true;
    if (!item.frame || !observerMaySend(*item.frame, m_policy.pilotThere())) {
        refuse(delivery.session, item, isPilot ? Reason::Late : Reason::Observer);
        return false;
    }
    if (mayBeMisread(*item.frame)) {
        ++m_counters.observerUnclear; // occurs by chance, so it is treated like a loss on the link and raises no alarm
        return false;
    }
    const auto sender = m_senders.find(delivery.session);
    const bool inLimit = sender != m_senders.end() && m_questions.take(now, sender->second.key, *item.frame);
    if (!inLimit) {
        refuse(delivery.session, item, Reason::TooOften);
        return false;
    }
    return true;
}

bool CommandGate::maySpeakAs(channel::SessionId session, const mavlink::ScanItem &item, bool isVehicle)
{
    if (!isVehicle && m_policy.acceptSealed(session, mavlink::systemIdOf(item.bytes)))
        return true;
    refuse(session, item, FramesRefused::Reason::System);
    return false;
}

void CommandGate::refuse(channel::SessionId session, const mavlink::ScanItem &item, FramesRefused::Reason reason)
{
    ++(m_counters.*counterOf(reason));
    // Every station, including an observer's, sends a heartbeat once a second: not worth an event.
    if (reason != FramesRefused::Reason::System && item.frame && item.frame->messageId() == mavlink::Heartbeat::kId)
        return;
    FramesRefused &refused = m_pending[{session, reason}];
    if (refused.frames++ == 0) {
        refused.reason = reason;
        if (const auto sender = m_senders.find(session); sender != m_senders.end())
            refused.peer = sender->second.name;
    }
    refused.messageId = mavlink::messageIdOf(item.bytes);
    refused.messageName = item.frame ? std::string(item.frame->info().name) : std::string();
    refused.command = 0;
    if (item.frame && refused.messageId == mavlink::CommandLong::kId)
        refused.command = mavlink::CommandLong::decode(item.frame->payload()).command;
    else if (item.frame && refused.messageId == mavlink::CommandInt::kId)
        refused.command = mavlink::CommandInt::decode(item.frame->payload()).command;
}

std::vector<FramesRefused> CommandGate::takeRefused()
{
    std::vector<FramesRefused> out;
    for (auto &[key, refused] : std::exchange(m_pending, {}))
        out.push_back(std::move(refused));
    return out;
}

void CommandGate::addTo(AgentCounters &counters) const
{
    counters.observerRefused += m_counters.observerRefused;
    counters.observerUnclear += m_counters.observerUnclear;
    counters.observerTooOften += m_counters.observerTooOften;
    counters.spoofRefused += m_counters.spoofRefused;
    counters.lateRefused += m_counters.lateRefused;
}

} // namespace skyseal::engine
