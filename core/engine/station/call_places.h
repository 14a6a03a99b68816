// The links that may lead to an agent that listens: those that send datagrams to one address. While MAVLink comes from there it
// is a router or an autopilot, which must receive hardly more than a greeting; but whoever forges that address can send
// MAVLink as well, so that the station calls there once in a while all the same. I/O thread.
#pragma once

#include "core/base/clock.h"
#include "core/base/weakness.h"
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
    /// An address from which no MAVLink came for this long is called again.
    static constexpr Duration kForgetAfter = std::chrono::seconds(10);
    /// Addresses from which MAVLink comes are called once in this time, until the next update.
    static constexpr Duration kCallSparingly = std::chrono::seconds(30);

    struct Update
    {
        std::vector<Path> calls;    ///< where agents may be called
        std::vector<Path> requests; ///< where an agent may be requested to pair
    };

    /// A MAVLink frame came in clear, TUNNEL included. Costs a comparison while frames come on one link.
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
    /// A record of an agent came from there: MAVLink of strangers does not count any more.
    void noteSession(const link::Link &link, const Path &from)
    {
        if (from.remote == link.remote() && link.id() != m_newestSession)
            m_changed |= m_sessions.insert(*(m_newestSession = link.id())).second;
    }
    /// Whether there are other places than at the last update.
    bool takeChanged() { return std::exchange(m_changed, false); }

    /// To be called every second. `isFlown`: a vehicle in clear is accepted at a path; it is never called, since its parser
    /// may lose frames after other bytes. `lastCall`: when agents were last called at a path, or nullopt.
    template<typename IsFlown, typename LastCall>
    Update update(TimePoint now, LinkPool &links, IsFlown &&isFlown, LastCall &&lastCall)
    {
        Update out;
        links.forEach([&](const link::Link &link) {
            const bool calls = link.traits().isDatagramClient() && !links.isListenOnly(link.id()) && link.remote() != Address{};
            const bool greeted = link.counters().txBlocks > 0; // a second ago, so that a router could answer
            const Path path{link.id(), link.remote()};
            if (!calls || !greeted || isFlown(path))
                return;
            Place &place = m_places[link.id()];
            place.called = std::max(place.called, lastCall(path).value_or(place.called));
            const bool spared = place.isMavlink(now) && !m_sessions.contains(link.id()) && !weakened(Weakness::CallRouters);
            if (!spared || now >= place.called + kCallSparingly)
                out.calls.push_back(path); // and again, until its turn has come
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
        std::optional<TimePoint> mavlink; ///< newest frame from there
        TimePoint called = TimePoint::min();
        TimePoint requested = TimePoint::min();
        bool isMavlink(TimePoint now) const { return mavlink && now - *mavlink <= kForgetAfter; }
    };

    std::map<LinkId, Place> m_places;
    LinkId m_newestLink{};       ///< where the newest frame came
    Place *m_newest = nullptr;   ///< its entry
    std::set<LinkId> m_sessions; ///< links at whose address an agent had a session
    std::optional<LinkId> m_newestSession;
    bool m_changed = false;
};

} // namespace skyseal::engine
