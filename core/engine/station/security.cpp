#include "core/engine/station/snapshot.h"

#include <algorithm>

namespace skyseal::engine {

bool isRecorded(const Snapshot &snapshot, const VehicleSnapshot &vehicle)
{
    const auto link = std::ranges::find(snapshot.links, vehicle.link, &LinkSnapshot::id);
    return !vehicle.session && link != snapshot.links.end() && link->recording;
}

Security securityOf(const Snapshot &snapshot)
{
    const auto any = [&](auto &&is) { return std::any_of(snapshot.sessions.begin(), snapshot.sessions.end(), is); };
    if (!snapshot.sessions.empty()) {
        if (any(isAttacked))
            return Security::UnderAttack;
        if (any([](const SessionSnapshot &s) { return s.info.pending.has_value(); }))
            return Security::Switching;
        return Security::Sealed;
    }
    const auto isClear = [&](const VehicleSnapshot &vehicle) { return !vehicle.session && !isRecorded(snapshot, vehicle); };
    const bool plain = !snapshot.pendingApproval.empty()
        || std::any_of(snapshot.vehicles.begin(), snapshot.vehicles.end(), isClear);
    return plain ? Security::Plain : Security::Nothing;
}

} // namespace skyseal::engine
