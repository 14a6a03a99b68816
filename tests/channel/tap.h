// Records a copy of every datagram sent over a simulated link.
#pragma once

#include "simulated_link.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace skyseal::test {

struct Tap
{
    /// `ends` owns the link. The tap must outlive its traffic.
    template<typename Ends> explicit Tap(Ends &ends)
    {
        ends.link.attacker = [this](TimePoint, Flight &flight) {
            flights.push_back(flight);
            return true;
        };
    }
    Tap(const Tap &) = delete;
    Tap &operator=(const Tap &) = delete;

    std::vector<Flight> ofKind(std::uint8_t first) const
    {
        std::vector<Flight> out;
        std::copy_if(flights.begin(), flights.end(), std::back_inserter(out),
                     [first](const Flight &flight) { return flight.bytes[0] == first; });
        return out;
    }
    std::vector<Flight> flights;
};

} // namespace skyseal::test
