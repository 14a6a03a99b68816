#include "core/metrics/process_usage.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

namespace skyseal::metrics {

static Duration cpuTime(clockid_t clock)
{
    timespec time{};
    ::clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

Duration processCpuTime()
{
    return cpuTime(CLOCK_PROCESS_CPUTIME_ID);
}

Duration threadCpuTime()
{
    return cpuTime(CLOCK_THREAD_CPUTIME_ID);
}

ContextSwitches threadSwitches()
{
#ifdef RUSAGE_THREAD
    rusage usage{};
    if (::getrusage(RUSAGE_THREAD, &usage) == 0)
        return {static_cast<std::uint64_t>(usage.ru_nvcsw), static_cast<std::uint64_t>(usage.ru_nivcsw)};
#endif
    return {};
}

std::optional<ContextSwitches> contextSwitches(std::int64_t process)
{
    std::ifstream in("/proc/" + std::to_string(process) + "/status");
    ContextSwitches out;
    int found = 0;
    for (std::string word; in >> word;) {
        if (word == "voluntary_ctxt_switches:")
            found += static_cast<bool>(in >> out.voluntary);
        else if (word == "nonvoluntary_ctxt_switches:")
            found += static_cast<bool>(in >> out.involuntary);
    }
    return process > 0 && found == 2 ? std::optional(out) : std::nullopt;
}

static std::optional<std::uint64_t> residentBytesFrom(const char *path)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path, "r"), &std::fclose);
    unsigned long long size = 0;
    unsigned long long resident = 0;
    if (!file || std::fscanf(file.get(), "%llu %llu", &size, &resident) != 2)
        return std::nullopt;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::optional<std::uint64_t> residentBytes()
{
    return residentBytesFrom("/proc/self/statm");
}

std::optional<Duration> processCpuTime(std::int64_t process)
{
    clockid_t clock{};
    if (process <= 0 || ::clock_getcpuclockid(static_cast<pid_t>(process), &clock) != 0)
        return std::nullopt;
    timespec time{};
    if (::clock_gettime(clock, &time) != 0)
        return std::nullopt;
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::optional<std::uint64_t> residentBytes(std::int64_t process)
{
    return process > 0 ? residentBytesFrom(("/proc/" + std::to_string(process) + "/statm").c_str()) : std::nullopt;
}

double CpuSampler::sample(TimePoint now, Duration cpuTime)
{
    if (m_started && now > m_time)
        m_percent = 100.0 * seconds(cpuTime - m_cpu) / seconds(now - m_time);
    else if (m_started)
        return m_percent;
    m_started = true;
    m_time = now;
    m_cpu = cpuTime;
    return m_percent;
}

void MemorySampler::sample(std::uint64_t bytes)
{
    m_bytes = bytes;
    m_peak = std::max(m_peak, bytes);
}

} // namespace skyseal::metrics
