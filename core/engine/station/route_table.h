// The destinations of the station's frames: one route for each session and each clear remote, each with its own sequence
// numbers, and the route to each system. I/O thread; no I/O itself.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/events.h"

#include <bitset>
#include <deque>
#include <map>
#include <optional>

namespace skyseal::engine {

struct Route
{
    std::optional<channel::SessionId> session; ///< nullopt: clear MAVLink to `path`
    Path path;
    std::uint8_t sequence = 0;      ///< of the next frame
    std::optional<TimePoint> heard; ///< time at which a vehicle in clear was last accepted there
    bool highLatency = false;       ///< a satellite modem, to which nothing is sent that nobody has asked for
    bool fixed = false;             ///< named by the operator, so it does not expire
    std::bitset<256> version1{};    ///< systems there whose autopilot speaks MAVLink 1
};

class RouteTable
{
public:
    /// A clear target without a heartbeat for this long is removed: the address may belong to another program.
    static constexpr Duration kForgetAfter = std::chrono::seconds(60);
    static constexpr Duration kForgetHighLatencyAfter = std::chrono::minutes(10);
    /// Greatest number of clear targets; heartbeats can be forged.
    static constexpr std::size_t kMost = 64;
    /// A path on which a heartbeat of the autopilot is overdue gives way to another one.
    static constexpr Duration kSwitchAfter = std::chrono::milliseconds(1500);

    /// Returns the route of a session; creates it if necessary.
    Route &ofSession(channel::SessionId session);
    void sessionDown(channel::SessionId session);
    /// Adds a remote that the operator named in a link's URL.
    void addFixed(const Path &path);
    void removeLink(LinkId link);

    /// The system was heard over this session: frames for it are sent there. A session takes precedence over a clear route.
    void heardSealed(std::uint8_t systemId, channel::SessionId session);
    /// Call for valid heartbeats only. Frames for the system are sent where its autopilot was heard; a system without one is
    /// followed by any of its heartbeats. Of several paths to one autopilot, the present one is kept while its heartbeats
    /// arrive: the vehicle answers on the path of the request, and a transfer must not change its path in between.
    void heardClear(TimePoint now, std::uint8_t systemId, const Path &path, bool isAutopilot, bool highLatency = false);
    /// The MAVLink version that the autopilot of a system speaks on its route, after heardSealed() or heardClear().
    void heardVersion(std::uint8_t systemId, const Path &path, std::optional<channel::SessionId> session, int version);
    void forgetSilent(TimePoint now);
    /// Removes all clear targets, including those that the operator named.
    void forgetClear();

    /// Returns true if a vehicle was recently accepted in clear at this link and address.
    bool hasVehicleInClear(const Path &path) const;
    /// Null if the system was never heard or its route was removed.
    Route *leadingTo(std::uint8_t systemId);
    std::deque<Route> &all() { return m_routes; }

private:
    Route *find(const Path &path);
    template<typename Predicate> void removeIf(Predicate gone);

    std::deque<Route> m_routes;
    struct Target
    {
        std::optional<channel::SessionId> session;
        Path path;
        TimePoint heard{};        ///< time of the newest heartbeat there
        bool isAutopilot = false; ///< whose heartbeat it was
    };
    std::map<std::uint8_t, Target> m_targets;
};

} // namespace skyseal::engine
