#include "core/engine/station/event.h"

#include <string>

namespace skyseal::engine {

std::optional<StrangerCause> StationCauses::operator()(const PlaintextRefused &refused) const
{
    if (refused.mayBe.empty())
        return StrangerCause{StrangerCause::Kind::Plaintext, 0};
    return StrangerCause{StrangerCause::Kind::Approval, refused.systemId};
}

std::optional<StrangerCause> StationCauses::operator()(const AgentUnanswering &unanswering) const
{
    const std::string subject = unanswering.agent.peerName + (unanswering.over ? "+" : "-");
    return StrangerCause{StrangerCause::Kind::UnansweringAgent, std::hash<std::string>()(subject)};
}

void StationCauses::merge(PlaintextRefused &waiting, const PlaintextRefused &newer)
{
    const std::uint64_t frames = waiting.frames + newer.frames;
    waiting = newer;
    waiting.frames = frames;
}

} // namespace skyseal::engine

template struct skyseal::CompiledOnce<skyseal::engine::EventVariant>;
