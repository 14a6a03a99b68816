#include "core/engine/common/event_publisher.h"

#include "core/link/address_text.h"

#include <functional>
#include <string>

namespace skyseal::engine {

std::optional<StrangerCause> ChannelCauses::operator()(const channel::HandshakeRefused &refused) const
{
    if (!channel::isCausedByStrangers(refused.reason) && refused.reason != channel::RefusalReason::Flood)
        return std::nullopt;
    // Each agent that is not listed is reported; see UnknownAgents for their number.
    if (refused.reason == channel::RefusalReason::UnknownPeer)
        return StrangerCause{StrangerCause::Kind::UnknownAgent, std::hash<std::string>()(link::toText(refused.path.remote))};
    return StrangerCause{StrangerCause::Kind::Handshake, static_cast<std::uint64_t>(refused.reason)};
}

std::optional<StrangerCause> ChannelCauses::operator()(const channel::ForgeryAlarm &alarm) const
{
    return StrangerCause{StrangerCause::Kind::Forgery, static_cast<std::uint64_t>(alarm.session)};
}

std::optional<StrangerCause> ChannelCauses::operator()(const channel::PeerMoved &moved) const
{
    return StrangerCause{StrangerCause::Kind::Diversion, static_cast<std::uint64_t>(moved.session)};
}

void ChannelCauses::merge(channel::ForgeryAlarm &waiting, const channel::ForgeryAlarm &newer)
{
    waiting.forged += newer.forged;
    waiting.replayed += newer.replayed;
}

} // namespace skyseal::engine
