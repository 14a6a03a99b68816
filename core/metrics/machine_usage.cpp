#include "core/metrics/machine_usage.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include <unistd.h>

namespace skyseal::metrics {

namespace {

std::string contentOf(const std::string &path)
{
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// From the governor; nullopt where there is none, as in most virtual machines.
std::optional<double> governedMegahertz(long cores)
{
    double sum = 0;
    for (long core = 0; core < cores; ++core) {
        std::ifstream in("/sys/devices/system/cpu/cpu" + std::to_string(core) + "/cpufreq/scaling_cur_freq");
        double kilohertz = 0;
        if (!(in >> kilohertz))
            return std::nullopt;
        sum += kilohertz / 1000;
    }
    return cores > 0 ? std::optional(sum / static_cast<double>(cores)) : std::nullopt;
}

} // namespace

void readCpuTimes(std::string_view stat, double ticks, MachineUsage &out)
{
    std::istringstream in{std::string(stat.substr(0, stat.find('\n')))};
    std::string name;
    std::array<double, 8> times{}; // user, nice, system, idle, iowait, irq, softirq, steal
    in >> name;
    for (double &time : times)
        in >> time;
    if (!in || name != "cpu" || !(ticks > 0))
        return;
    const auto duration = [ticks](double time) {
        return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(time / ticks));
    };
    out.busy = duration(times[0] + times[1] + times[2] + times[5] + times[6]);
    out.stolen = duration(times[7]);
}

std::optional<double> meanMegahertz(const std::string &cpuInfo)
{
    std::istringstream in(cpuInfo);
    double sum = 0;
    int cores = 0;
    for (std::string line; std::getline(in, line);) {
        const std::size_t sign = line.find(':');
        if (line.compare(0, 7, "cpu MHz") != 0 || sign == std::string::npos)
            continue;
        const std::size_t digit = line.find_first_not_of(" \t", sign + 1);
        sum += finiteNumber(std::string_view(line).substr(std::min(digit, line.size()))).value_or(0);
        ++cores;
    }
    return cores > 0 ? std::optional(sum / cores) : std::nullopt;
}

void readThrottling(const std::string &sysfs, MachineUsage &out)
{
    const std::string cpus = sysfs + "/devices/system/cpu/cpu";
    std::uint64_t ofPackages = 0;
    for (int core = 0;; ++core) {
        const std::string folder = cpus + std::to_string(core) + "/thermal_throttle/";
        std::ifstream inCore(folder + "core_throttle_count"), inPackage(folder + "package_throttle_count");
        std::uint64_t ofCore = 0, ofPackage = 0;
        if (!(inCore >> ofCore))
            break;
        inPackage >> ofPackage; // each core states those of its package
        ofPackages = std::max(ofPackages, ofPackage);
        out.throttlings = out.throttlings.value_or(0) + ofCore;
    }
    if (out.throttlings)
        *out.throttlings += ofPackages;
    // Bits 0 to 3: now under voltage, capped, throttled, at the soft limit of the temperature.
    const std::string word = contentOf(sysfs + "/devices/platform/soc/soc:firmware/get_throttled");
    out.isThrottled = (std::strtoul(word.c_str(), nullptr, 16) & 0xF) != 0;
    if (!word.empty() && !out.throttlings)
        out.throttlings = 0;
}

MachineUsage machineUsage()
{
    MachineUsage out;
    readCpuTimes(contentOf("/proc/stat"), static_cast<double>(::sysconf(_SC_CLK_TCK)), out);
    const long cores = ::sysconf(_SC_NPROCESSORS_ONLN);
    out.megahertz = governedMegahertz(cores);
    if (!out.megahertz)
        out.megahertz = meanMegahertz(contentOf("/proc/cpuinfo"));
    readThrottling("/sys", out);
    double load = 0;
    if (::getloadavg(&load, 1) == 1 && cores > 0)
        out.load = load / static_cast<double>(cores);
    return out;
}

} // namespace skyseal::metrics
