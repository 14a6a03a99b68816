// Aircraft in the neighbourhood, as a vehicle's ADS-B receiver reports them (ADSB_VEHICLE).
// https://mavlink.io/en/messages/common.html#ADSB_VEHICLE
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/messages.h"
#include "core/vehicle/vehicle_state.h"

#include <vector>

namespace skyseal::vehicle {

/// The aircraft that were heard last, one for each ICAO address.
class Traffic
{
public:
    static constexpr std::size_t kMost = 64;
    /// Without a report an aircraft is forgotten after so long.
    static constexpr Duration kForgottenAfter = std::chrono::seconds(30);

    /// Takes a report. If the list is full, the new aircraft takes the place of the farthest one from `own`, if that is farther
    /// than itself; the nearest ones are those that matter. Without a place of both, it takes none.
    void handle(TimePoint now, const mavlink::AdsbVehicle &report, const Position &own);
    /// With their ages as of `now`; none that is forgotten.
    std::vector<Aircraft> aircraft(TimePoint now) const;

private:
    struct Entry
    {
        Aircraft aircraft;
        TimePoint heard{}; ///< by the receiver
    };
    Entry *placeFor(TimePoint now, std::uint32_t address, const Position &where, const Position &own);

    std::vector<Entry> m_entries;
};

} // namespace skyseal::vehicle
