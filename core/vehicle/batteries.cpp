#include "core/vehicle/batteries.h"

#include "core/vehicle/known_value.h"

#include <algorithm>
#include <cmath>

namespace skyseal::vehicle {

namespace {

constexpr double kMilli = 1e-3, kCenti = 1e-2;

bool isForFlight(const Battery &battery)
{
    return battery.function != mavlink::MAV_BATTERY_FUNCTION_AVIONICS
        && battery.function != mavlink::MAV_BATTERY_FUNCTION_PAYLOAD;
}

/// Volts of the cells that are there, which autopilots without cell monitors send as one cell or, beyond 65 V, as several.
double sumOfCells(const mavlink::BatteryStatus &report)
{
    double sum = 0;
    for (const std::uint16_t cell : report.voltages)
        sum += mavlink::isKnown<&mavlink::BatteryStatus::voltages>(cell) ? cell * kMilli : 0;
    for (const std::uint16_t cell : report.voltages_ext)
        sum += mavlink::isKnown<&mavlink::BatteryStatus::voltages_ext>(cell) ? cell * kMilli : 0;
    return sum > 0 ? sum : kUnknown;
}

/// A charge below zero is none.
double charge(double percent)
{
    return percent >= 0 ? percent : kUnknown;
}

double firstKnown(double value, double other)
{
    return std::isnan(value) ? other : value;
}

} // namespace

void Batteries::handle(TimePoint now, const mavlink::SysStatus &report)
{
    using Message = mavlink::SysStatus;
    forget(now);
    m_main.heard = now;
    m_main.battery.voltage = known<&Message::voltage_battery>(report, kMilli);
    m_main.battery.current = known<&Message::current_battery>(report, kCenti);
    m_main.battery.percent = charge(known<&Message::battery_remaining>(report));
}

void Batteries::handle(TimePoint now, const mavlink::BatteryStatus &report)
{
    using Message = mavlink::BatteryStatus;
    forget(now);
    const auto at = std::ranges::lower_bound(m_reports, report.id, {}, [](const Report &one) { return one.battery.id; });
    const bool isNew = at == m_reports.end() || at->battery.id != report.id;
    if (isNew && m_reports.size() == kMost)
        return;
    Report &place = isNew ? *m_reports.insert(at, Report{}) : *at;
    place = {{.id = report.id,
              .function = report.battery_function,
              .voltage = sumOfCells(report),
              .current = known<&Message::current_battery>(report, kCenti),
              .percent = charge(known<&Message::battery_remaining>(report))},
             now};
}

void Batteries::show(VehicleState &state) const
{
    const Battery &main = m_main.battery;
    const Battery *flight = flightBattery();
    const Battery other = flight ? *flight : Battery{};
    state.batteryVoltage = firstKnown(main.voltage, other.voltage);
    state.batteryCurrent = firstKnown(main.current, other.current);
    state.batteryPercent = firstKnown(main.percent, other.percent);
    state.batteries.clear();
    for (const Report &report : m_reports)
        state.batteries.push_back(report.battery);
}

void Batteries::forget(TimePoint now)
{
    if (now - m_main.heard >= kKept)
        m_main.battery = {};
    std::erase_if(m_reports, [now](const Report &one) { return now - one.heard >= kKept; });
}

const Battery *Batteries::flightBattery() const
{
    constexpr double kRounding = 1; // PX4 rounds the charge up in one message and to the nearest in the other
    for (const Report &report : m_reports) {
        const double difference = std::abs(report.battery.percent - m_main.battery.percent);
        if (isForFlight(report.battery) && !(difference > kRounding))
            return &report.battery;
    }
    return nullptr;
}

} // namespace skyseal::vehicle
