// The path to each vehicle on the agent's side: learned from valid heartbeats, or given by a link that has only one remote.
// No I/O and no clock.
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
    /// After this time without a heartbeat the address may belong to another program.
    static constexpr Duration kForgetAfter = std::chrono::seconds(60);

    /// The remote of a link that has no others; every frame goes there.
    void setFixed(const Path &path) { m_fixed = path; }

    void heard(TimePoint now, const Path &from, const mavlink::Frame &frame);
    /// A stream began or ended: what was learned from the old one is dropped.
    void streamChanged(const Path &path);
    void forgetSilent(TimePoint now);

    /// Whether one of the agent's vehicles has this system id; remembered for the life of this object.
    bool isVehicle(std::uint8_t systemId) const { return m_systems.test(systemId); }
    /// The system id of the only vehicle that was ever heard; 0 if there were none or several.
    std::uint8_t onlySystem() const
    {
        std::uint8_t only = 0;
        for (std::size_t id = 1; id < m_systems.size() && m_systems.count() == 1; ++id)
            only = m_systems.test(id) ? static_cast<std::uint8_t>(id) : only;
        return only;
    }
    /// Calls `visit(const Path &)` for each path to a system; for 0 and unknown systems, for the paths of all vehicles.
    /// Returns false if there is none.
    template<typename Visit> bool forEachPathTo(std::uint8_t targetSystem, Visit &&visit) const
    {
        if (m_fixed) {
            visit(*m_fixed);
            return true;
        }
        if (const auto found = m_routes.find(targetSystem); found != m_routes.end()) {
            visit(found->second.path);
            return true;
        }
        for (auto entry = m_routes.begin(); entry != m_routes.end(); ++entry) {
            // Several systems may be behind one path, which receives the frame once.
            const auto same = [&](const auto &other) { return other.second.path == entry->second.path; };
            if (std::none_of(m_routes.begin(), entry, same))
                visit(entry->second.path);
        }
        return !m_routes.empty();
    }

private:
    struct Entry
    {
        Path path;
        TimePoint heard{};
    };

    std::optional<Path> m_fixed;
    std::map<std::uint8_t, Entry> m_routes;
    std::bitset<256> m_systems;
};

} // namespace skyseal::engine
