// Vehicles in clear that await the operator's approval, see SenderPolicy::needsApproval(). No I/O and no clock.
#pragma once

#include "core/base/clock.h"
#include "core/engine/station/vehicle_snapshot.h"

#include <bitset>
#include <map>
#include <string>
#include <vector>

namespace skyseal::engine {

class PendingVehicles
{
public:
    /// A vehicle that is silent for this long is no longer offered to the operator.
    static constexpr Duration kForgetAfter = std::chrono::seconds(10);

    /// Notes a heartbeat of such a vehicle. Returns true for the first one of a system in this run, which is worth an event;
    /// forged heartbeats thus cause few events.
    bool note(TimePoint now, std::uint8_t systemId, std::string remoteAddress)
    {
        m_vehicles[systemId] = {std::move(remoteAddress), now};
        const bool isNew = !m_notified.test(systemId);
        m_notified.set(systemId);
        return isNew;
    }
    /// Counts any frame of such a vehicle.
    void count() { ++m_frames; }
    std::uint64_t frames() const { return m_frames; }
    void forgetSilent(TimePoint now)
    {
        std::erase_if(m_vehicles, [now](const auto &entry) { return now - entry.second.heard > kForgetAfter; });
    }
    void release(std::uint8_t systemId) { m_vehicles.erase(systemId); }
    /// `mayBe`: names of the agents that such a vehicle may impersonate.
    std::vector<PendingVehicle> all(const std::string &mayBe) const
    {
        std::vector<PendingVehicle> out;
        for (const auto &[systemId, entry] : m_vehicles)
            out.push_back({systemId, entry.remoteAddress, mayBe});
        return out;
    }

private:
    struct Entry
    {
        std::string remoteAddress;
        TimePoint heard;
    };
    std::map<std::uint8_t, Entry> m_vehicles;
    std::bitset<256> m_notified;
    std::uint64_t m_frames = 0;
};

} // namespace skyseal::engine
