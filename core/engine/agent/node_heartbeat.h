// The identity of an agent as a MAVLink node on a ground link that leads through routers or radios: a component of its
// vehicle, with a clear heartbeat once a second (core/channel/PROTOCOL.md, carrier TUNNEL). Routers do not forward TUNNEL to
// a node that never sent a heartbeat; autopilots ignore this one. I/O thread.
#pragma once

#include "core/engine/common/link_pool.h"
#include "core/mavlink/enums.h"

#include <algorithm>
#include <vector>

namespace skyseal::engine {

class NodeHeartbeat
{
public:
    static constexpr Duration kPeriod = std::chrono::seconds(1);

    /// Takes the system id of the vehicle; only the first call has an effect. No TUNNEL message can be sent before it.
    void setSystem(TimePoint now, std::uint8_t systemId, CarrierWriter &carriers)
    {
        if (carriers.node().system != 0)
            return;
        carriers.setNode({systemId, mavlink::MAV_COMP_ID_ONBOARD_COMPUTER});
        m_due = now + kPeriod;
    }

    /// Sends a heartbeat to each of the paths in Carrier::Tunnel if one is due.
    void handleDeadline(TimePoint now, LinkPool &links, const std::vector<Path> &grounds)
    {
        if (now < m_due)
            return;
        for (const Path &to : grounds) {
            if (to.carrier == Carrier::Tunnel)
                links.send({to.link, {}}, links.carriers().heartbeat());
        }
        m_due = std::max(m_due + kPeriod, now);
    }
    TimePoint nextDeadline() const { return m_due; }

private:
    TimePoint m_due = kNever; ///< kNever until the system id is known
};

} // namespace skyseal::engine
