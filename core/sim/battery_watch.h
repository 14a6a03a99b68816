// Detects a low battery, by voltage over time or by consumed charge, once per level.
#pragma once

#include "core/sim/battery.h"
#include "core/sim/parameters.h"

namespace skyseal::sim {

enum class BatteryLevel { Good, Low, Critical };

class BatteryWatch
{
public:
    /// The level that was newly reached in these `dt` seconds, or Good.
    BatteryLevel step(double dt, const Battery &battery, const Parameters &parameters);
    BatteryLevel level() const { return m_level; }
    void reset() { *this = {}; }

private:
    BatteryLevel m_level = BatteryLevel::Good;
    double m_lowFor = 0;      ///< s
    double m_criticalFor = 0; ///< s
};

} // namespace skyseal::sim
