#include "core/sim/autopilot.h"

namespace skyseal::sim {

void Autopilot::step()
{
    constexpr double dt = kStep * 1e-6;
    FlightContext &f = m_flight;
    f.time += kStep;
    if (m_settingsRevision != f.parameters.revision()) {
        f.settings = flightSettings(f.parameters, f.world);
        f.pilot.setFault(f.settings.faults.radio);
        m_settingsRevision = f.parameters.revision();
    }
    m_rotors.update(dt, armed(), armed() ? f.modes.update(dt, f.situation()) : FlightDemand{}, estimate(), f.settings);
    f.physics.step(dt, f.time, f.settings, m_rotors.commands(), armed());
    f.landDetector.step(dt, truth().onGround, m_rotors.idle(), armed());
    f.pilot.setFlying(!landed());
    if (!m_aligned && estimate().attitudeOk) {
        m_aligned = true;
        f.texts.say(Severity::Info, "EKF3 IMU0 tilt alignment complete");
    }
    m_failsafes.step();
    m_arming.step();
}

} // namespace skyseal::sim
