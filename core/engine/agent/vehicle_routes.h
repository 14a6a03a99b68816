// Which way leads to which vehicle on the agent's side: learned from valid heartbeats, or given by a link that has only one
// remote. No I/O.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/mavlink/frame_scanner.h"

#include <algorithm>
#include <bitset>
#include <map>
#include <optional>

namespace skyseal::engine {

class VehicleRoutes
{
public:
    /// Silent so long, an address may be somebody else's.
    static constexpr Duration kForgetAfter = std::chrono::seconds(60);

    /// The one remote of a link that has no others.
    void setFixed(const Path &path) { m_fixed = path; }

    void heard(TimePoint now, const Path &from, const mavlink::Frame &frame);
    void streamChanged(LinkId link, const Path &path);
    void forgetSilent(TimePoint now);

    /// Whether a vehicle of ours speaks as this system.
    bool isVehicle(std::uint8_t systemId) const { return m_systems.test(systemId); }
    /// Calls `visit(const Path &)` for each way that a frame for a system goes; 0 or a system that is not known: to every
    /// vehicle. False when there is none.
    template<typename Visit> bool forEachWayTo(std::uint8_t targetSystem, Visit &&visit) const
    {
        if (m_fixed) {
            visit(*m_fixed);
            return true;
        }
        if (const auto found = m_routes.find(targetSystem); found != m_routes.end()) {
            visit(found->second.path);
            return true;
        }
        for (auto way = m_routes.begin(); way != m_routes.end(); ++way) {
            // Several systems may be behind one path, which wants the frame once.
            if (std::none_of(m_routes.begin(), way, [&](const auto &other) { return other.second.path == way->second.path; }))
                visit(way->second.path);
        }
        return !m_routes.empty();
    }

private:
    struct Way
    {
        Path path;
        TimePoint heard{};
    };

    std::optional<Path> m_fixed;
    std::map<std::uint8_t, Way> m_routes;
    std::bitset<256> m_systems;
};

} // namespace skyseal::engine
