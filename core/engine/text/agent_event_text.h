// One sentence for each event of the agent. Channel events read as they do for the station.
#pragma once

#include "core/engine/agent/agent_event.h"
#include "core/engine/text/common_event_text.h"

namespace skyseal::engine {

/// `names` must have noted the event if it is one of the channel. Without a sentence for the events of a pairing: its owner
/// reports them with the texts of pairing_text.h.
EventText agentEventText(const AgentEvent &event, const PeerNames &names);

} // namespace skyseal::engine
