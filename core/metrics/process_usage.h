// CPU time and resident memory of a process, read from the system, and the CPU load between two readings.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <optional>

namespace skyseal::metrics {

/// CPU time (user and system) of this process so far.
Duration processCpuTime();
/// CPU time of the calling thread.
Duration threadCpuTime();
/// How often a thread or a process gave up its core so far.
struct ContextSwitches
{
    std::uint64_t voluntary = 0;   ///< to wait for something
    std::uint64_t involuntary = 0; ///< for the sake of others
};
/// Of the calling thread.
ContextSwitches threadSwitches();
/// Resident memory in bytes (VmRSS); nullopt where the system does not report it.
std::optional<std::uint64_t> residentBytes();

/// The same for another process of this machine, by its process id; nullopt if it does not exist or is not readable.
std::optional<Duration> processCpuTime(std::int64_t process);
std::optional<std::uint64_t> residentBytes(std::int64_t process);
/// Of its main thread.
std::optional<ContextSwitches> contextSwitches(std::int64_t process);

/// CPU load between periodic readings (about once a second), in percent of one core: 200 means two full cores.
class CpuSampler
{
public:
    /// Returns the load since the previous sample; 0 for the first, and the previous value if no time has passed.
    double sample(TimePoint now, Duration cpuTime);
    double percent() const { return m_percent; }

private:
    bool m_started = false;
    TimePoint m_time{};
    Duration m_cpu{};
    double m_percent = 0;
};

/// Current and peak resident memory, from readings of the caller.
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
