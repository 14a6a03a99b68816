// Where frames go out: one route for each place that proved to be worth sending to, each with its own sequence of frame
// numbers, and which route leads to which system. I/O thread; no I/O itself.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/events.h"

#include <deque>
#include <map>
#include <optional>

namespace skyseal::engine {

struct Route
{
    std::optional<channel::SessionId> session; ///< empty: clear MAVLink to `path`
    Path path;
    std::uint8_t sequence = 0;      ///< of the next frame
    std::optional<TimePoint> heard; ///< a vehicle in clear was taken there, not long ago
    bool fixed = false;             ///< named by the operator, so it needs no sign of life
};

class RouteTable
{
public:
    /// So long without a heartbeat a clear target is forgotten: it may be somebody else's address by now.
    static constexpr Duration kForgetAfter = std::chrono::seconds(60);
    /// Clear targets at the most; heartbeats can be forged.
    static constexpr std::size_t kMost = 64;

    /// The route of a session, made when it comes up.
    Route &ofSession(channel::SessionId session);
    void sessionDown(channel::SessionId session);
    /// A remote that the operator named in a link's URL.
    void addFixed(const Path &path);
    void removeLink(LinkId link);

    /// A system was heard: what is for it goes there from now on. The sealed way wins over a clear one.
    void heardSealed(std::uint8_t systemId, channel::SessionId session);
    /// After a valid heartbeat only.
    void heardClear(TimePoint now, std::uint8_t systemId, const Path &path);
    void forgetSilent(TimePoint now);
    /// All clear targets, also those that the operator named.
    void forgetClear();

    /// Null when the system was never heard or its way is gone.
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
    };
    std::map<std::uint8_t, Target> m_targets;
};

} // namespace skyseal::engine
