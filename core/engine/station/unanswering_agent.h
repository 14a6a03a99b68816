// An agent that does not take part in handshakes, for snapshots and events.
#pragma once

#include <string>

namespace skyseal::engine {

/// A known agent that announces itself and answers none of the station's handshakes.
struct UnansweringAgent
{
    std::string peerName;
    std::string remoteAddress;
    std::string ownFingerprint; ///< of this station's key, which the agent must have among its peers
    double seconds = 0;         ///< since the first unanswered message
};

} // namespace skyseal::engine
