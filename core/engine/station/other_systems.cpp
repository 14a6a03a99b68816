#include "core/engine/station/other_systems.h"

namespace skyseal::engine {

namespace {

std::vector<std::uint8_t> listOf(const std::bitset<256> &systems)
{
    std::vector<std::uint8_t> out;
    for (std::size_t id = 0; id < systems.size(); ++id) {
        if (systems.test(id))
            out.push_back(static_cast<std::uint8_t>(id));
    }
    return out;
}

} // namespace

void OtherSystems::note(TimePoint now, const std::string &peer, std::uint8_t systemId, bool isVehicle)
{
    Heard &heard = m_heard[peer];
    ++m_frames;
    ++heard.frames;
    const bool changed = !heard.systems.test(systemId) || (isVehicle && !heard.vehicles.test(systemId));
    heard.systems.set(systemId);
    if (isVehicle)
        heard.vehicles.set(systemId);
    if (changed && !heard.changed)
        heard.changed = now;
}

std::optional<OtherSystemsHeard> OtherSystems::take(TimePoint now)
{
    for (auto &[peer, heard] : m_heard) {
        if (!heard.changed || now - *heard.changed < kGather)
            continue;
        heard.changed.reset();
        return describe(peer, heard);
    }
    return std::nullopt;
}

std::vector<OtherSystemsHeard> OtherSystems::all() const
{
    std::vector<OtherSystemsHeard> out;
    for (const auto &[peer, heard] : m_heard)
        out.push_back(describe(peer, heard));
    return out;
}

OtherSystemsHeard OtherSystems::describe(const std::string &peer, const Heard &heard)
{
    return {peer, listOf(heard.systems), listOf(heard.vehicles), heard.frames};
}

} // namespace skyseal::engine
