// Judges the health of the position estimate while the vehicle is armed, as ArduCopter's EKF check: variances beyond
// FS_EKF_THRESH for a second.
#pragma once

#include "core/sim/estimator.h"

namespace skyseal::sim {

class EstimatorWatch
{
public:
    enum class Event { None, Failed, Good };

    /// The change within these `dt` seconds.
    Event step(double dt, bool armed, const FilterVariances &variances, double threshold)
    {
        int over = variances.compass >= threshold ? 1 : 0;
        over += variances.velocity >= 2 * threshold ? 2 : variances.velocity >= threshold ? 1 : 0;
        const bool bad = armed && (over >= 2 || (variances.horizontal >= threshold && over >= 1));
        m_badFor = bad ? m_badFor + dt : 0;
        const bool failed = m_badFor >= kPatience || (bad && m_failed);
        if (failed == m_failed)
            return Event::None;
        m_failed = failed;
        return failed ? Event::Failed : Event::Good;
    }
    bool failed() const { return m_failed; }

private:
    static constexpr double kPatience = 1; // s
    double m_badFor = 0;
    bool m_failed = false;
};

} // namespace skyseal::sim
