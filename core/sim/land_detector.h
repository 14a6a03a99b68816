// Detects landing from the own sensors: ground contact without demand for lift, for one second.
#pragma once

namespace skyseal::sim {

class LandDetector
{
public:
    bool landed() const { return m_landed; }
    /// Seconds on the ground with idle or stopped rotors.
    double idleFor() const { return m_idleFor; }

    /// `touching`: the legs carry weight; `idle`: no lift is demanded; `armed`: rotors may turn.
    void step(double dt, bool touching, bool idle, bool armed)
    {
        m_touchingFor = touching ? m_touchingFor + dt : 0;
        if (!touching)
            m_landed = false;
        else if (!armed || m_touchingFor >= kSettle)
            m_landed = true;
        m_idleFor = m_landed && idle ? m_idleFor + dt : 0;
    }

    /// An arming or a take-off starts the idle time anew.
    void resetIdle() { m_idleFor = 0; }

private:
    static constexpr double kSettle = 1; // s

    bool m_landed = true;
    double m_touchingFor = kSettle;
    double m_idleFor = 0;
};

} // namespace skyseal::sim
