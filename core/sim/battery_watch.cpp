#include "core/sim/battery_watch.h"

namespace skyseal::sim {

namespace {

/// Seconds for which a limit has been broken; a limit of zero is switched off.
void count(double &seconds, double dt, double voltage, float limit)
{
    seconds = limit > 0 && voltage < static_cast<double>(limit) ? seconds + dt : 0;
}

bool drained(const Battery &battery, float capacity, float reserve)
{
    return reserve > 0 && static_cast<double>(capacity - reserve) < battery.consumed();
}

} // namespace

BatteryLevel BatteryWatch::step(double dt, const Battery &battery, const Parameters &parameters)
{
    const double timer = static_cast<double>(parameters.value("BATT_LOW_TIMER"));
    const float capacity = parameters.value("BATT_CAPACITY");
    count(m_lowFor, dt, battery.voltage(), parameters.value("BATT_LOW_VOLT"));
    count(m_criticalFor, dt, battery.voltage(), parameters.value("BATT_CRT_VOLT"));

    BatteryLevel now = BatteryLevel::Good;
    if (m_lowFor > timer || drained(battery, capacity, parameters.value("BATT_LOW_MAH")))
        now = BatteryLevel::Low;
    if (m_criticalFor > timer || drained(battery, capacity, parameters.value("BATT_CRT_MAH")))
        now = BatteryLevel::Critical;
    if (now <= m_level)
        return BatteryLevel::Good;
    m_level = now;
    return now;
}

} // namespace skyseal::sim
