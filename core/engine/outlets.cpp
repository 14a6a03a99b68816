#include "core/engine/outlets.h"

#include <algorithm>

namespace skyseal::engine {

Outlet &Outlets::ofSession(channel::SessionId session)
{
    for (Outlet &outlet : m_outlets) {
        if (outlet.session == session)
            return outlet;
    }
    Outlet fresh;
    fresh.session = session;
    return m_outlets.emplace_back(fresh);
}

template<typename Predicate> void Outlets::removeIf(Predicate gone)
{
    m_outlets.erase(std::remove_if(m_outlets.begin(), m_outlets.end(), gone), m_outlets.end());
}

void Outlets::sessionDown(channel::SessionId session)
{
    removeIf([session](const Outlet &outlet) { return outlet.session == session; });
    std::erase_if(m_ways, [session](const auto &way) { return way.second.session == session; });
}

void Outlets::addFixed(const Path &path)
{
    if (Outlet *known = find(path)) {
        known->fixed = true;
        return;
    }
    Outlet fresh;
    fresh.path = path;
    fresh.fixed = true;
    m_outlets.push_back(fresh);
}

void Outlets::removeLink(LinkId link)
{
    removeIf([link](const Outlet &outlet) { return !outlet.session && outlet.path.link == link; });
    std::erase_if(m_ways, [link](const auto &way) { return !way.second.session && way.second.path.link == link; });
}

void Outlets::heardSealed(std::uint8_t systemId, channel::SessionId session)
{
    m_ways[systemId] = {session, {}};
}

void Outlets::heardClear(TimePoint now, std::uint8_t systemId, const Path &path)
{
    Outlet *outlet = find(path);
    if (!outlet) {
        if (m_outlets.size() >= kMost)
            return;
        Outlet fresh;
        fresh.path = path;
        outlet = &m_outlets.emplace_back(fresh);
    }
    outlet->heard = now;
    const auto way = m_ways.find(systemId);
    if (way == m_ways.end() || !way->second.session)
        m_ways[systemId] = {std::nullopt, path};
}

void Outlets::forgetSilent(TimePoint now)
{
    for (Outlet &outlet : m_outlets) {
        if (outlet.heard && now - *outlet.heard > kForgetAfter)
            outlet.heard.reset();
    }
    removeIf([](const Outlet &outlet) { return !outlet.session && !outlet.fixed && !outlet.heard; });
}

void Outlets::forgetClear()
{
    removeIf([](const Outlet &outlet) { return !outlet.session; });
    std::erase_if(m_ways, [](const auto &way) { return !way.second.session; });
}

Outlet *Outlets::find(const Path &path)
{
    for (Outlet &outlet : m_outlets) {
        if (!outlet.session && outlet.path == path)
            return &outlet;
    }
    return nullptr;
}

Outlet *Outlets::leadingTo(std::uint8_t systemId)
{
    const auto way = m_ways.find(systemId);
    if (way == m_ways.end())
        return nullptr;
    if (!way->second.session)
        return find(way->second.path);
    for (Outlet &outlet : m_outlets) {
        if (outlet.session == way->second.session)
            return &outlet;
    }
    return nullptr;
}

} // namespace skyseal::engine
