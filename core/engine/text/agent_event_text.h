// One sentence for each event of the agent. Channel events read as they do for the station.
#pragma once

#include "core/engine/agent/agent_event.h"
#include "core/engine/text/common_event_text.h"

namespace skyseal::engine {

/// `names` must have noted the event if it is one of the channel.
EventText agentEventText(const AgentEvent &event, const PeerNames &names);

} // namespace skyseal::engine
