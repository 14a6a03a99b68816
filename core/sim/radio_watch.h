// Detects the loss of the pilot's radio: no signal, or a throttle below FS_THR_VALUE, which receivers give when they hear
// nothing.
#pragma once

namespace skyseal::sim {

class RadioWatch
{
public:
    enum class Event { None, Lost, Back };

    /// The change within these `dt` seconds.
    Event step(double dt, bool signal, bool throttleLow)
    {
        m_silentFor = signal ? 0 : m_silentFor + dt;
        m_lowFor = throttleLow ? m_lowFor + dt : 0;
        const bool lost = m_silentFor >= kSilence || m_lowFor >= kLow;
        if (lost == m_lost)
            return Event::None;
        m_lost = lost;
        return lost ? Event::Lost : Event::Back;
    }
    bool lost() const { return m_lost; }

private:
    static constexpr double kSilence = 1; // s, RC_FS_TIMEOUT of ArduPilot
    static constexpr double kLow = 0.1;   // s, a few frames
    double m_silentFor = 0;
    double m_lowFor = 0;
    bool m_lost = false;
};

} // namespace skyseal::sim
