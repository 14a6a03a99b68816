#include "core/channel/agent_calls.h"

#include <algorithm>

namespace skyseal::channel {

AgentCalls::Turn AgentCalls::take(TimePoint now, const std::vector<PublicKey> &agents, const std::vector<Path> &places)
{
    m_next = now + kTurn;
    m_begin = m_end + 1;
    m_end = m_begin + 1;
    update(agents, places);
    Turn out;
    if (agents.empty() || places.empty())
        return out;
    std::vector<Path> waiting = places;
    std::ranges::stable_sort(waiting, {}, [this](const Path &path) { return m_places[path].waitsSince; });
    out.agents = nextAgents(m_places[waiting.front()]);
    std::stable_partition(waiting.begin(), waiting.end(),
                          [&](const Path &path) { return nextAgents(m_places[path]) == out.agents; });
    waiting.resize(std::min(waiting.size(), kAtOnce));
    for (const Path &path : waiting) {
        Place &place = m_places[path];
        if (nextAgents(place) == out.agents)
            place.waitsSince = m_end;
        place.called = now;
        for (const PublicKey &agent : out.agents)
            place.agents[agent] = m_end;
    }
    out.places = std::move(waiting);
    return out;
}

std::optional<TimePoint> AgentCalls::lastCall(const Path &place) const
{
    const auto found = m_places.find(place);
    return found == m_places.end() ? std::nullopt : found->second.called;
}

/// New entries wait behind all others.
void AgentCalls::update(std::vector<PublicKey> agents, const std::vector<Path> &places)
{
    std::ranges::sort(agents);
    for (auto &[path, place] : m_places)
        place.listed = false;
    for (const Path &path : places) {
        Place &place = m_places[path];
        place.listed = true;
        if (place.waitsSince == 0)
            place.waitsSince = m_begin;
        std::erase_if(place.agents, [&](const auto &entry) { return !std::ranges::binary_search(agents, entry.first); });
        for (const PublicKey &agent : agents)
            place.agents.emplace(agent, m_begin);
    }
    forgetRemoved();
}

void AgentCalls::forgetRemoved()
{
    std::size_t removed = 0;
    for (const auto &[path, place] : m_places)
        removed += !place.listed;
    for (; removed > kKept; --removed) {
        const auto age = [](const auto &entry) { return entry.second.listed ? UINT64_MAX : entry.second.waitsSince; };
        m_places.erase(std::ranges::min_element(m_places, {}, age));
    }
}

/// The agents that waited longest at this address, in the order of their keys.
std::vector<PublicKey> AgentCalls::nextAgents(const Place &place)
{
    std::vector<std::pair<std::uint64_t, PublicKey>> waiting;
    for (const auto &[agent, since] : place.agents)
        waiting.emplace_back(since, agent);
    const std::size_t count = std::min(kAtOnce, waiting.size());
    std::ranges::partial_sort(waiting, waiting.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<PublicKey> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(waiting[i].second);
    std::ranges::sort(out);
    return out;
}

} // namespace skyseal::channel
