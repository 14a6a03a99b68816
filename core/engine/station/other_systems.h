// Systems that belong to no peer and are heard behind agents, see OtherSystemsHeard. No I/O and no clock.
#pragma once

#include "core/base/clock.h"
#include "core/engine/station/other_systems_heard.h"

#include <bitset>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

class OtherSystems
{
public:
    /// An event waits for this time after the first frame, since systems that send once a second are heard one after the other.
    static constexpr Duration kGather = std::chrono::seconds(3);

    /// Counts a frame. `isVehicle`: it announces a vehicle.
    void note(TimePoint now, const std::string &peer, std::uint8_t systemId, bool isVehicle);
    /// An event that is due; nullopt without one.
    std::optional<OtherSystemsHeard> take(TimePoint now);
    /// Frames since the start.
    std::uint64_t frames() const { return m_frames; }
    /// By name of the agent.
    std::vector<OtherSystemsHeard> all() const;

private:
    struct Heard
    {
        std::bitset<256> systems, vehicles;
        std::optional<TimePoint> changed; ///< since the last event
        std::uint64_t frames = 0;
    };

    static OtherSystemsHeard describe(const std::string &peer, const Heard &heard);

    std::map<std::string, Heard> m_heard;
    std::uint64_t m_frames = 0;
};

} // namespace skyseal::engine
