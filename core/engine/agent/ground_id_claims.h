// Heartbeats on the vehicle's side under a system id of a ground station: counted, and reported at most once a minute for each
// id. Such an id is never treated as a vehicle's, since the station could then no longer send. No I/O and no clock.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <map>

namespace skyseal::engine {

class GroundIdClaims
{
public:
    static constexpr Duration kReportEvery = std::chrono::minutes(1);

    /// Returns true if the claim has to be reported.
    bool note(TimePoint now, std::uint8_t systemId)
    {
        ++m_count;
        const auto [due, isFirst] = m_reportDue.try_emplace(systemId, now);
        if (now < due->second)
            return false;
        due->second = now + kReportEvery;
        return true;
    }
    std::uint64_t count() const { return m_count; }

private:
    std::uint64_t m_count = 0;
    std::map<std::uint8_t, TimePoint> m_reportDue;
};

} // namespace skyseal::engine
