// Systems that are heard behind an agent and belong to no peer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace skyseal::engine {

/// Authentic frames of systems that belong to no peer arrived behind an agent: autopilots forward the heartbeats of other
/// ground stations, radios and gimbals may have system ids of their own. Only RADIO_STATUS is used, see
/// Fleet::takeRadioStatus(). Published once for each agent and set of systems.
struct OtherSystemsHeard
{
    std::string peer;
    std::vector<std::uint8_t> systems;  ///< all that were heard so far
    std::vector<std::uint8_t> vehicles; ///< those of them that are vehicles by their heartbeats
    std::uint64_t frames = 0;           ///< of all, so far
};

} // namespace skyseal::engine
