// The links that may lead to an agent that listens: those that send datagrams to one address. While MAVLink arrives from that
// address, it is a router or an autopilot, which should receive hardly more than a greeting. But an attacker can forge such
// MAVLink, so the station still calls there occasionally. I/O thread.
#pragma once

#include "core/base/clock.h"
#include "core/engine/common/link_pool.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace skyseal::engine {

class CallPlaces
{
public:
    /// An address from which no MAVLink has arrived for this long is called again.
    static constexpr Duration kForgetAfter = std::chrono::seconds(10);
    /// Addresses from which MAVLink arrives are called once in this time, until the next update.
    static constexpr Duration kCallSparingly = std::chrono::seconds(30);

    struct Update
    {
        std::vector<Path> calls;    ///< addresses at which agents may be called
        std::vector<Path> requests; ///< addresses at which an agent may be requested to pair
    };

    /// A MAVLink frame arrived in clear, including TUNNEL. Costs a comparison while frames arrive on a single link.
    void noteMavlink(const link::Link &link, const Path &from, TimePoint now)
    {
        if (from.remote != link.remote())
            return;
        if (!m_newest || link.id() != m_newestLink) {
            m_newestLink = link.id();
            m_newest = &m_places[m_newestLink];
        }
        m_changed |= !m_newest->isMavlink(now);
        m_newest->mavlink = now;
    }
    /// A record of an agent arrived from there: from now on MAVLink of strangers has no effect.
    void noteSession(const link::Link &link, const Path &from)
    {
        if (from.remote == link.remote() && link.id() != m_newestSession)
            m_changed |= m_sessions.insert(*(m_newestSession = link.id())).second;
    }
    /// Whether the places have changed since the last update.
    bool takeChanged() { return std::exchange(m_changed, false); }

    /// To be called every second. `isFlown`: a vehicle in clear is accepted at a path; it is never called, since its parser
    /// may lose frames after other bytes. `lastCall`: when agents were last called at a path, or nullopt.
    template<typename IsFlown, typename LastCall>
    Update update(TimePoint now, LinkPool &links, IsFlown &&isFlown, LastCall &&lastCall)
    {
        Update out;
        links.forEach([&](const link::Link &link) {
            const bool calls = link.traits().isDatagramClient() && !links.isListenOnly(link.id()) && link.remote() != Address{};
            const bool greeted = link.counters().txBlocks > 0; // at least a second ago, so that a router could answer
            const Path path{link.id(), link.remote()};
            if (!calls || !greeted || isFlown(path))
                return;
            Place &place = m_places[link.id()];
            place.called = std::max(place.called, lastCall(path).value_or(place.called));
            const bool spared = isRouter(link.id(), place, now);
            if (!spared || now >= place.called + kCallSparingly)
                out.calls.push_back(path); // repeatedly, until its turn has come
            if (!spared || now >= place.requested + kCallSparingly) {
                place.requested = now;
                out.requests.push_back(path);
            }
        });
        return out;
    }

private:
    struct Place
    {
        std::optional<TimePoint> mavlink; ///< time of the newest frame from there
        TimePoint called = TimePoint::min();
        TimePoint requested = TimePoint::min();
        bool isMavlink(TimePoint now) const { return mavlink && now - *mavlink <= kForgetAfter; }
    };

    /// Whether a router, or an autopilot, is there and not an agent.
    bool isRouter(LinkId link, const Place &place, TimePoint now) const;

    std::map<LinkId, Place> m_places;
    LinkId m_newestLink{};       ///< link of the newest frame
    Place *m_newest = nullptr;   ///< its entry
    std::set<LinkId> m_sessions; ///< links at whose address an agent had a session
    std::optional<LinkId> m_newestSession;
    bool m_changed = false;
};

} // namespace skyseal::engine
