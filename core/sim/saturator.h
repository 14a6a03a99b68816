// Loads a link with as much telemetry as it carries: bursts go out while not too many are unanswered, and each ends with a
// TIMESYNC request, which every station answers. How many may be unanswered grows while all answers come and is halved when
// one is missing, as TCP does; and where answers come late because bursts wait for a slow line it holds only as many there
// as keep the line busy, as TCP Vegas does, so that what is lost on such a line was not lost to this. Sans-I/O.
#pragma once

#include "core/sim/simulated_vehicle.h"

#include <deque>

namespace skyseal::sim {

class Saturator
{
public:
    static constexpr std::size_t kBurst = 48; ///< messages
    static constexpr double kWidest = 32;     ///< bursts unanswered; what a socket's buffer holds
    static constexpr std::size_t kAtOnce = 4; ///< bursts that fit the vehicle's outbox

    /// A frame from a station. A burst is taken as lost once three later ones were answered: links reorder.
    void handleFrame(TimePoint now, const mavlink::Frame &frame);
    /// Lets the vehicle send what is due; true when there is more to come once its outbox is empty.
    bool advance(TimePoint now, SimulatedVehicle &vehicle);

    std::size_t unanswered() const { return m_open.size(); }

private:
    struct Ticket
    {
        std::int64_t number = 0;
        TimePoint sent{};
        unsigned overtaken = 0; ///< by answers to later ones
    };

    Duration patience() const;
    void noteTrip(Duration trip);
    bool fillsTheQueue(Duration trip) const;
    void missed();
    void giveUp();
    void takeLate(TimePoint now, std::int64_t number);

    std::deque<Ticket> m_open;
    std::deque<Ticket> m_given;                  ///< up, the newest: an answer that still comes says how long it takes
    std::int64_t m_next = std::int64_t(1) << 56; ///< far from the times that others put there
    double m_window = 2;                         ///< bursts
    Duration m_trip{};                           ///< smoothed; nothing until the first answer
    Duration m_leastTrip = Duration::max();
    bool m_heard = false; ///< any station yet
};

} // namespace skyseal::sim
