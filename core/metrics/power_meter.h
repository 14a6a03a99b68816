// Power drawn by the machine: the growth of its energy between two readings. Single-threaded.
#pragma once

#include "core/base/clock.h"
#include "core/metrics/energy_meter.h"

#include <optional>
#include <utility>

namespace skyseal::metrics {

class PowerMeter
{
public:
    /// `sysfs`: see EnergyMeter.
    explicit PowerMeter(const std::string &sysfs = EnergyMeter::kSysfs) : m_energy(sysfs) {}

    /// Reads the counters. Call about once a second.
    void sample(TimePoint now)
    {
        const auto before = std::exchange(m_microjoules, m_energy.microjoules(now));
        const double passed = seconds(now - std::exchange(m_time, now));
        m_watts.reset();
        if (before && m_microjoules && passed > 0)
            m_watts = static_cast<double>(*m_microjoules - *before) / 1e6 / passed;
    }

    /// Mean power between the last two samples; nullopt before the second one and where no counter is readable.
    std::optional<double> watts() const { return m_watts; }

private:
    EnergyMeter m_energy;
    std::optional<std::uint64_t> m_microjoules;
    TimePoint m_time{};
    std::optional<double> m_watts;
};

} // namespace skyseal::metrics
