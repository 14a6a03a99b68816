// The JSON line of each event of the channel, the same in the station's monitor and the agent. Names and shapes are part of the
// programs' interface.
#pragma once

#include "core/channel/events.h"
#include "core/engine/common/peer_names.h"

#include <string>

namespace skyseal::engine {

/// `names` must have noted the event. Empty for SwitchPending, which is not reported to scripts.
std::string channelEvent(const channel::Event &event, const PeerNames &names);

} // namespace skyseal::engine
