// Arming and disarming: the checks before, the refusals, and the disarming by itself after a landing or a long wait.
#pragma once

#include "core/sim/flight_context.h"
#include "core/sim/refusal.h"

namespace skyseal::sim {

class Arming
{
public:
    explicit Arming(FlightContext &flight) : m_flight(flight) {}

    bool armed() const { return m_armed; }
    /// Rises with every arming, so that others can tell one flight from the next.
    unsigned count() const { return m_count; }

    /// The first failed check, without "PreArm: "; nullopt if all pass.
    Refusal preArm() const;
    /// `force` skips all checks.
    Refusal arm(bool force);
    /// `force` stops the motors in flight as well.
    Refusal disarm(bool force);
    void disarmNow();

    /// Once per step: disarms after a landing that the flight mode ends with, or after DISARM_DELAY on the ground.
    void step();

private:
    bool modeAllowsArming() const;
    bool landsHere() const;

    FlightContext &m_flight;
    bool m_armed = false;
    bool m_flown = false; ///< since it was armed
    unsigned m_count = 0;
};

} // namespace skyseal::sim
