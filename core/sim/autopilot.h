// The vehicle without its radio: a simulated vehicle in a simulated world, and the autopilot that flies it, in steps of
// 2.5 ms. Independent of MAVLink. Composes Arming, Failsafes and FlightRequests over one FlightContext.
#pragma once

#include "core/sim/failsafes.h"
#include "core/sim/flight_requests.h"

namespace skyseal::sim {

class Autopilot
{
public:
    explicit Autopilot(const AutopilotConfig &config) : m_flight(config) {}

    static constexpr std::uint64_t kStep = 2500; ///< µs
    void step();
    std::uint64_t time() const { return m_flight.time; } ///< µs of flight time since power-on

    Arming &arming() { return m_arming; }
    const Arming &arming() const { return m_arming; }
    Failsafes &failsafes() { return m_failsafes; }
    const Failsafes &failsafes() const { return m_failsafes; }
    FlightRequests &requests() { return m_requests; }
    /// The state that these share.
    FlightContext &flight() { return m_flight; }
    const FlightContext &flight() const { return m_flight; }
    const Craft &craft() const { return m_flight.physics.craft(); }

    // Shortcuts for the most used states.
    bool armed() const { return m_arming.armed(); }
    bool landed() const { return m_flight.landed(); }
    const Estimate &estimate() const { return m_flight.estimate(); }
    const BodyState &truth() const { return m_flight.physics.truth(); }
    double heightAboveHome() const { return m_flight.home.orOrigin().z - estimate().position.z; }
    Parameters &parameters() { return m_flight.parameters; }
    const Parameters &parameters() const { return m_flight.parameters; }
    FlightModes &modes() { return m_flight.modes; }
    const FlightModes &modes() const { return m_flight.modes; }
    StatusTexts &texts() { return m_flight.texts; }

private:
    FlightContext m_flight;
    Arming m_arming{m_flight};
    Failsafes m_failsafes{m_flight, m_arming};
    FlightRequests m_requests{m_flight, m_arming};
    unsigned m_settingsRevision = ~0u;
    bool m_aligned = false;
};

} // namespace skyseal::sim
