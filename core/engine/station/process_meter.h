// The cost of the station to its machine: CPU load, memory and power. I/O thread.
#pragma once

#include "core/metrics/power_meter.h"
#include "core/metrics/process_usage.h"

#include <cstdint>
#include <optional>
#include <string>

namespace skyseal::engine {

class ProcessMeter
{
public:
    /// `sysfs`: see metrics::EnergyMeter.
    explicit ProcessMeter(const std::string &sysfs) : m_power(sysfs) {}

    /// Reads CPU time, memory and energy. Call about once a second on the I/O thread, whose own load is measured as well.
    /// `watching`: the part of its CPU time that snapshots, probes and these readings took so far.
    void sample(TimePoint now, Duration watching)
    {
        m_cpu.sample(now, metrics::processCpuTime());
        m_ioCpu.sample(now, metrics::threadCpuTime());
        m_watchingCpu.sample(now, watching);
        m_memory.sample(metrics::residentBytes().value_or(0));
        m_power.sample(now);
    }

    /// Percent of one core: of all threads, of the I/O thread, and of the latter what watching takes.
    double cpuPercent() const { return m_cpu.percent(); }
    double ioCpuPercent() const { return m_ioCpu.percent(); }
    double watchingCpuPercent() const { return m_watchingCpu.percent(); }
    std::uint64_t residentBytes() const { return m_memory.bytes(); }
    /// Of the whole processor; nullopt if unknown.
    std::optional<double> watts() const { return m_power.watts(); }

private:
    metrics::CpuSampler m_cpu, m_ioCpu, m_watchingCpu;
    metrics::MemorySampler m_memory;
    metrics::PowerMeter m_power;
};

} // namespace skyseal::engine
