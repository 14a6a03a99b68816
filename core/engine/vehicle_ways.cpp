#include "core/engine/vehicle_ways.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

#include <algorithm>

namespace skyseal::engine {

void VehicleWays::heard(TimePoint now, const Path &from, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::Heartbeat::kId)
        return;
    // Ground stations, companions and gimbals beat as well; an autopilot says which one it is.
    const mavlink::Heartbeat beat = mavlink::Heartbeat::decode(frame.payload());
    if (beat.autopilot == mavlink::MAV_AUTOPILOT_INVALID)
        return;
    m_systems.set(frame.systemId());
    m_ways[frame.systemId()] = {from, now};
}

void VehicleWays::streamChanged(LinkId, const Path &path)
{
    std::erase_if(m_ways, [&path](const auto &way) { return way.second.path == path; });
}

void VehicleWays::forgetSilent(TimePoint now)
{
    std::erase_if(m_ways, [now](const auto &way) { return now - way.second.heard > kForgetAfter; });
}

std::vector<Path> VehicleWays::to(std::uint8_t targetSystem) const
{
    if (!m_fixed.empty())
        return m_fixed;
    if (const auto found = m_ways.find(targetSystem); found != m_ways.end())
        return {found->second.path};
    std::vector<Path> out;
    for (const auto &[systemId, way] : m_ways) {
        if (std::find(out.begin(), out.end(), way.path) == out.end())
            out.push_back(way.path);
    }
    return out;
}

} // namespace skyseal::engine
