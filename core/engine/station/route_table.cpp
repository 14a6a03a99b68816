#include "core/engine/station/route_table.h"

#include <algorithm>

namespace skyseal::engine {

Route &RouteTable::ofSession(channel::SessionId session)
{
    for (Route &route : m_routes) {
        if (route.session == session)
            return route;
    }
    Route fresh;
    fresh.session = session;
    return m_routes.emplace_back(fresh);
}

template<typename Predicate> void RouteTable::removeIf(Predicate gone)
{
    m_routes.erase(std::remove_if(m_routes.begin(), m_routes.end(), gone), m_routes.end());
}

void RouteTable::sessionDown(channel::SessionId session)
{
    removeIf([session](const Route &route) { return route.session == session; });
    std::erase_if(m_targets, [session](const auto &target) { return target.second.session == session; });
}

void RouteTable::addFixed(const Path &path)
{
    if (Route *known = find(path)) {
        known->fixed = true;
        return;
    }
    Route fresh;
    fresh.path = path;
    fresh.fixed = true;
    m_routes.push_back(fresh);
}

void RouteTable::removeLink(LinkId link)
{
    removeIf([link](const Route &route) { return !route.session && route.path.link == link; });
    std::erase_if(m_targets, [link](const auto &target) { return !target.second.session && target.second.path.link == link; });
}

void RouteTable::heardSealed(std::uint8_t systemId, channel::SessionId session)
{
    m_targets[systemId] = {session, {}, {}, false};
}

void RouteTable::heardClear(TimePoint now, std::uint8_t systemId, const Path &path, bool isAutopilot, bool highLatency)
{
    Route *route = find(path);
    if (!route) {
        if (m_routes.size() >= kMost)
            return;
        Route fresh;
        fresh.path = path;
        route = &m_routes.emplace_back(fresh);
    }
    route->heard = now;
    route->highLatency = highLatency;
    const auto [target, isNew] = m_targets.try_emplace(systemId);
    const Target &present = target->second;
    const bool overdue = present.path == path || now - present.heard > kSwitchAfter || !find(present.path);
    const bool mayReplace = present.isAutopilot ? isAutopilot && overdue : true;
    if (isNew || (!present.session && mayReplace))
        target->second = {std::nullopt, path, now, isAutopilot};
}

void RouteTable::heardVersion(std::uint8_t systemId, const Path &path, std::optional<channel::SessionId> session, int version)
{
    if (Route *route = session ? &ofSession(*session) : find(path))
        route->version1.set(systemId, version == 1);
}

void RouteTable::forgetSilent(TimePoint now)
{
    for (Route &route : m_routes) {
        if (route.heard && now - *route.heard > (route.highLatency ? kForgetHighLatencyAfter : kForgetAfter))
            route.heard.reset();
    }
    removeIf([](const Route &route) { return !route.session && !route.fixed && !route.heard; });
}

void RouteTable::forgetClear()
{
    removeIf([](const Route &route) { return !route.session; });
    std::erase_if(m_targets, [](const auto &target) { return !target.second.session; });
}

bool RouteTable::hasVehicleInClear(const Path &path) const
{
    return std::any_of(m_routes.begin(), m_routes.end(),
                       [&](const Route &route) { return !route.session && route.heard && route.path.sharesPlace(path); });
}

Route *RouteTable::find(const Path &path)
{
    for (Route &route : m_routes) {
        if (!route.session && route.path == path)
            return &route;
    }
    return nullptr;
}

Route *RouteTable::leadingTo(std::uint8_t systemId)
{
    const auto target = m_targets.find(systemId);
    if (target == m_targets.end())
        return nullptr;
    if (!target->second.session)
        return find(target->second.path);
    for (Route &route : m_routes) {
        if (route.session == target->second.session)
            return &route;
    }
    return nullptr;
}

} // namespace skyseal::engine
