// Loads a link with as much telemetry as it carries. Telemetry is sent in bursts, each ending with a TIMESYNC request, which
// every station answers. The limit of unanswered bursts grows while all answers arrive and is halved when one is missing, as
// in TCP. If answers are delayed because bursts queue at a slow line, only as many are outstanding as keep the line busy, as
// in TCP Vegas, so that the saturator itself causes no loss there. Sans-I/O.
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

    /// A frame from a station. A burst counts as lost after answers to three later ones, since links reorder.
    void handleFrame(TimePoint now, const mavlink::Frame &frame);
    /// Makes the vehicle send the bursts that are due. Returns true if more follow once its outbox is empty.
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
