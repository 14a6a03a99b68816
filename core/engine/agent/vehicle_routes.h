// The path to each vehicle on the agent's side: learned from valid heartbeats, or that of a link with a single remote.
// No I/O and no clock.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/mavlink/frame_scanner.h"

#include <algorithm>
#include <map>
#include <optional>

namespace skyseal::engine {

class VehicleRoutes
{
public:
    /// After this time without a heartbeat the address may belong to another program, and the system id to another node.
    static constexpr Duration kForgetAfter = std::chrono::seconds(60);

    /// The remote of a link that has no others; every frame is sent there.
    void setFixed(const Path &path) { m_fixed = path; }

    /// Returns true for heartbeats of autopilots, but not of ground stations, companion computers and gimbals, which may have
    /// the system id of the vehicle and another address.
    static bool isVehicleHeartbeat(const mavlink::Frame &frame);
    /// Takes a heartbeat of an autopilot: its system id is that of a vehicle at this address.
    void heard(TimePoint now, const Path &from, std::uint8_t systemId);
    /// The system id belongs to a ground station.
    void forget(std::uint8_t systemId);
    /// A stream began or ended: the paths learned from the old one are removed.
    void streamChanged(const Path &path);
    void forgetSilent(TimePoint now);

    /// Whether one of the agent's vehicles has this system id; false after it was silent for kForgetAfter.
    bool isVehicle(std::uint8_t systemId) const { return m_heard.contains(systemId); }
    /// The system id of the only vehicle; 0 if there are none or several.
    std::uint8_t onlySystem() const { return m_heard.size() == 1 ? m_heard.begin()->first : std::uint8_t(0); }
    /// Calls `visit(const Path &)` for each path to a system; for 0 and unknown systems, for the paths of all vehicles.
    /// Returns false if there is none.
    template<typename Visit> bool forEachPathTo(std::uint8_t targetSystem, Visit &&visit) const
    {
        if (m_fixed) {
            visit(*m_fixed);
            return true;
        }
        if (const auto found = m_routes.find(targetSystem); found != m_routes.end()) {
            visit(found->second);
            return true;
        }
        for (auto entry = m_routes.begin(); entry != m_routes.end(); ++entry) {
            // Several systems may be behind one path, which receives the frame once.
            const auto same = [&](const auto &other) { return other.second == entry->second; };
            if (std::none_of(m_routes.begin(), entry, same))
                visit(entry->second);
        }
        return !m_routes.empty();
    }

private:
    std::optional<Path> m_fixed;
    std::map<std::uint8_t, Path> m_routes;
    std::map<std::uint8_t, TimePoint> m_heard; ///< newest heartbeat of each vehicle
};

} // namespace skyseal::engine
