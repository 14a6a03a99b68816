#include "core/vehicle/flight_timer.h"

namespace skyseal::vehicle {

namespace {
constexpr double kLeastHeight = 0.5; ///< metres above home
}

void FlightTimer::update(TimePoint now, bool armed, double altitudeRelative)
{
    if (armed && !m_armed)
        m_newFlight = true;
    m_armed = armed;
    const bool flying = armed && offGround(altitudeRelative);
    m_wasOnGround = m_wasOnGround || !armed || onGround(altitudeRelative);
    if (flying && !m_flying) {
        if (m_newFlight) {
            m_before = {};
            m_sawTakeOff = m_wasOnGround;
        }
        m_newFlight = false;
        m_since = now;
    } else if (!flying && m_flying) {
        m_before += now - m_since;
    }
    m_flying = flying;
}

double FlightTimer::flightTime(TimePoint now) const
{
    return seconds(m_before + (m_flying ? now - m_since : Duration{}));
}

bool FlightTimer::offGround(double altitudeRelative) const
{
    if (m_landed != LandedState::Undefined)
        return m_landed != LandedState::OnGround;
    return altitudeRelative > kLeastHeight; // false for NaN
}

/// False while neither a landed state nor an altitude is known.
bool FlightTimer::onGround(double altitudeRelative) const
{
    if (m_landed != LandedState::Undefined)
        return m_landed == LandedState::OnGround;
    return altitudeRelative <= kLeastHeight;
}

} // namespace skyseal::vehicle
