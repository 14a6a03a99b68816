// The load of the whole machine, as far as its kernel tells: CPU time of all programs, stolen time, frequency, load average.
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace skyseal::metrics {

struct MachineUsage
{
    std::optional<Duration> busy;    ///< CPU time of all programs and of the kernel on all cores, since the machine started
    std::optional<Duration> stolen;  ///< time that a hypervisor gave to others while a core had work
    std::optional<double> megahertz; ///< mean of all cores
    std::optional<double> load;      ///< load average of the last minute, divided by the number of cores
    std::optional<std::uint64_t> throttlings; ///< how often the processor slowed down, hot or short of power, since it started
    bool isThrottled = false;                 ///< now, where that is what is known (Raspberry Pi)
};

/// Reads all of it; takes some 100 µs.
MachineUsage machineUsage();

/// CPU times of the first line of /proc/stat, whose columns are `ticks` to a second; see proc(5).
void readCpuTimes(std::string_view stat, double ticks, MachineUsage &out);
/// The kernel's counters of each core and package (x86) or the firmware's word (Raspberry Pi) below `sysfs`.
void readThrottling(const std::string &sysfs, MachineUsage &out);
/// Mean of the lines "cpu MHz" of /proc/cpuinfo; nullopt without one.
std::optional<double> meanMegahertz(const std::string &cpuInfo);

} // namespace skyseal::metrics
