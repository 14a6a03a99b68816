// One sentence for each event of the agent; for events of the channel the same as for the station.
#pragma once

#include "core/engine/agent/agent_event.h"
#include "core/engine/text/common_event_text.h"

namespace skyseal::engine {

/// `names` must have noted the event if it is one of the channel. Empty for the events of a pairing: its owner
/// reports them with the texts of pairing_text.h.
EventText agentEventText(const AgentEvent &event, const PeerNames &names);

} // namespace skyseal::engine
