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
        ends.link.attacker = [this](TimePoint, SentDatagram &flight) {
            flights.push_back(flight);
            return true;
        };
    }
    Tap(const Tap &) = delete;
    Tap &operator=(const Tap &) = delete;

    std::vector<SentDatagram> ofKind(std::uint8_t first) const
    {
        std::vector<SentDatagram> out;
        std::copy_if(flights.begin(), flights.end(), std::back_inserter(out),
                     [first](const SentDatagram &flight) { return flight.bytes[0] == first; });
        return out;
    }
    std::vector<SentDatagram> flights;
};

} // namespace skyseal::test
