// What this process costs: CPU time and resident memory, read from the system; percentages from two readings.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <optional>

namespace skyseal::metrics {

/// CPU time (user and system) that the process has used so far.
Duration processCpuTime();
/// CPU time of the calling thread alone.
Duration threadCpuTime();
/// Bytes of memory that are resident now (VmRSS); nullopt where the system does not tell.
std::optional<std::uint64_t> residentBytes();

/// The same of another process of this machine, by its number; nullopt when there is none or the system does not tell.
std::optional<Duration> processCpuTime(std::int64_t process);
std::optional<std::uint64_t> residentBytes(std::int64_t process);

/// CPU load between readings that are taken now and then (once a second), in percent of one core: 200 is two cores.
class CpuSampler
{
public:
    /// The load since the previous sample; 0 for the first, and the last value again when no time has passed.
    double sample(TimePoint now, Duration cpuTime);
    double percent() const { return m_percent; }

private:
    bool m_started = false;
    TimePoint m_time{};
    Duration m_cpu{};
    double m_percent = 0;
};

/// Resident memory now and at its highest, from readings handed in.
class MemorySampler
{
public:
    void sample(std::uint64_t bytes);
    std::uint64_t bytes() const { return m_bytes; }
    std::uint64_t peak() const { return m_peak; }

private:
    std::uint64_t m_bytes = 0;
    std::uint64_t m_peak = 0;
};

} // namespace skyseal::metrics
