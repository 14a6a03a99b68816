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
    f.physics.step(dt, f.time, f.settings, armed() ? f.modes.update(dt, f.situation()) : FlightDemand{}, armed());
    f.landDetector.step(dt, truth().onGround, f.physics.craft().idle(), armed());
    f.pilot.setFlying(!landed());
    if (!m_aligned && estimate().attitudeOk) {
        m_aligned = true;
        if (!f.type.isPx4())
            f.texts.say(Severity::Info, "EKF3 IMU0 tilt alignment complete");
    }
    m_failsafes.step();
    m_arming.step();
}

} // namespace skyseal::sim
