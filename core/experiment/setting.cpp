#include "core/experiment/setting.h"

#include "core/experiment/build_commit.h"
#include "core/experiment/metric.h"
#include "core/metrics/energy_meter.h"

#include <openssl/crypto.h>
#include <sodium.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif
#include <sys/utsname.h>
#include <unistd.h>

namespace skyseal::experiment {

namespace {

/// The value of "key : value" in /proc/cpuinfo or of KEY="value" in os-release; empty if there is none.
std::string valueIn(const char *file, std::string_view key, char separator)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const std::size_t sign = line.find(separator);
        if (sign == std::string::npos || line.compare(0, key.size(), key) != 0)
            continue;
        if (line.find_first_not_of(" \t", key.size()) != sign)
            continue;
        const std::size_t begin = line.find_first_not_of(" \t\"", sign + 1);
        const std::size_t end = line.find_last_not_of(" \t\"");
        return begin == std::string::npos ? std::string() : line.substr(begin, end - begin + 1);
    }
    return {};
}

std::string firstLine(const char *file)
{
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

/// The features of the processor that ciphers and hashes use.
std::string cryptoFeatures()
{
    std::string flags = valueIn("/proc/cpuinfo", "flags", ':');
    if (flags.empty())
        flags = valueIn("/proc/cpuinfo", "Features", ':'); // ARM
    std::istringstream in(flags);
    std::string out;
    for (std::string word; in >> word;) {
        for (const char *wanted : {"aes", "pclmulqdq", "sha_ni", "ssse3", "avx", "avx2", "avx512f", "vaes", "vpclmulqdq",
                                   "pmull", "sha1", "sha2", "asimd", "neon"}) {
            if (word == wanted)
                out += (out.empty() ? "" : " ") + word;
        }
    }
    return out.empty() ? "none" : out;
}

/// Whether the cores may run faster than their nominal frequency.
std::string turbo()
{
    if (const std::string off = firstLine("/sys/devices/system/cpu/intel_pstate/no_turbo"); !off.empty())
        return off == "0" ? "on" : "off";
    if (const std::string on = firstLine("/sys/devices/system/cpu/cpufreq/boost"); !on.empty())
        return on == "1" ? "on" : "off";
    return "unknown";
}

std::string compiler()
{
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "g++ " __VERSION__;
#else
    return "unknown";
#endif
}

std::string build()
{
    const std::string warning = buildWarning(SKYSEAL_BUILD_FLAGS).text();
    std::string out = warning.empty() ? "optimised" : warning;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    out += ", with sanitizers: the figures of this build are meaningless";
#endif
    return out;
}

std::string libc()
{
#if defined(__GLIBC__)
    return std::string("glibc ") + gnu_get_libc_version(); // that runs, not that of the build
#else
    return "unknown";
#endif
}

std::string memorySize()
{
    const auto pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGESIZE);
    return pages > 0 && size > 0 ? readable(static_cast<double>(pages) * static_cast<double>(size) / 1e9) + " GB" : "unknown";
}

/// The first number in a text; 0 without one.
double numberIn(const std::string &text)
{
    double out = 0;
    std::istringstream(text) >> out;
    return out;
}

/// The warning that machineSetting() gives for these values of a setting.
Reason warningFor(const std::string &flags, const std::string &loadAverage, const std::string &cores)
{
    Reason built = buildWarning(flags);
    Reason busy = busyWarning(numberIn(loadAverage), std::lround(numberIn(cores)));
    if (built.empty())
        return busy;
    built = sentence("Reason", "this build is %1")(built);
    return busy.empty() ? built : sentence("Reason", "%1; %2")(built, busy);
}

} // namespace

Reason busyWarning(double load, long cores)
{
    if (!(load > static_cast<double>(cores) / 2))
        return {};
    return sentence("Reason",
                    "the machine was busy with other work: load average %1 on %2 cores at the start; the figures are "
                    "noisier and may be wrong")(readable(load), cores);
}

Reason buildWarning(std::string_view flags)
{
    std::istringstream in{std::string(flags)};
    std::string level = "-O0"; // the last one counts
    for (std::string word; in >> word;)
        level = word.starts_with("-O") ? word : level;
    if (level == "-O2" || level == "-O3" || level == "-Ofast")
        return {};
    if (level == "-O0")
        return sentence("Reason", "not optimised: the figures of this build are not meaningful");
    return sentence("Reason", "optimised by %1 alone, as for tests: the figures are higher than those of a release")(level);
}

std::optional<bool> opensslUsesAes(std::string_view cpuInfo)
{
    // OPENSSL_ia32cap(3): bit 57 of the first word is AES-NI. On ARM, arm_arch.h: bit 2.
    constexpr std::pair<std::string_view, unsigned> kMasks[]{{"OPENSSL_ia32cap=0x", 57}, {"OPENSSL_armcap=0x", 2}};
    for (const auto &[key, bit] : kMasks) {
        const std::size_t at = cpuInfo.find(key);
        if (at == std::string_view::npos)
            continue;
        std::uint64_t word = 0;
        const char *begin = cpuInfo.data() + at + key.size();
        if (std::from_chars(begin, cpuInfo.data() + cpuInfo.size(), word, 16).ec == std::errc())
            return (word >> bit & 1) != 0;
    }
    return std::nullopt;
}

std::optional<bool> opensslUsesAes()
{
    return opensslUsesAes(OpenSSL_version(OPENSSL_CPU_INFO));
}

std::vector<Reason> warningsOf(const Setting &setting)
{
    const Reason own = warningFor(settingOf(setting, "build_flags"), settingOf(setting, "load_average_at_start"),
                                  settingOf(setting, "cores"));
    std::vector<Reason> out;
    for (const auto &[key, value] : setting) {
        if (key == "warning")
            out.push_back(own.text() == value ? own : Reason(value));
    }
    return out;
}

Setting machineSetting()
{
    utsname system{};
    ::uname(&system);
    const auto cores = ::sysconf(_SC_NPROCESSORS_ONLN);
    std::string processor = valueIn("/proc/cpuinfo", "model name", ':');
    if (const std::string speed = valueIn("/proc/cpuinfo", "cpu MHz", ':'); !speed.empty())
        processor += ", " + speed + " MHz";
    Setting out;
    out.emplace_back("processor", processor.empty() ? "unknown" : processor);
    out.emplace_back("cores", std::to_string(cores));
    out.emplace_back("memory", memorySize());
    out.emplace_back("processor_features", cryptoFeatures());
    if (const char *mask = std::getenv("OPENSSL_ia32cap"))
        out.emplace_back("openssl_ia32cap", mask);
    const std::string governor = firstLine("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
    out.emplace_back("frequency_governor", governor.empty() ? "unknown" : governor);
    const std::string microcode = valueIn("/proc/cpuinfo", "microcode", ':');
    out.emplace_back("microcode", microcode.empty() ? "unknown" : microcode);
    out.emplace_back("turbo", turbo());
    out.emplace_back("clock_source", firstLine("/sys/devices/system/clocksource/clocksource0/current_clocksource"));
    out.emplace_back("hypervisor",
                     valueIn("/proc/cpuinfo", "flags", ':').find(" hypervisor") != std::string::npos ? "yes" : "no");
    out.emplace_back("architecture", system.machine);
    out.emplace_back("system", valueIn("/etc/os-release", "PRETTY_NAME", '='));
    out.emplace_back("kernel", std::string(system.sysname) + " " + system.release);
    out.emplace_back("energy_counters", metrics::EnergyMeter().describe());
    out.emplace_back("load_average_at_start", firstLine("/proc/loadavg"));
    const Reason warning = warningFor(SKYSEAL_BUILD_FLAGS, settingOf(out, "load_average_at_start"), settingOf(out, "cores"));
    if (!warning.empty())
        out.emplace_back("warning", warning.text());
    out.emplace_back("libc", libc());
    out.emplace_back("libsodium", sodium_version_string());
    out.emplace_back("openssl", OpenSSL_version(OPENSSL_VERSION));
    out.emplace_back("openssl_cpu", OpenSSL_version(OPENSSL_CPU_INFO));
    out.emplace_back("compiler", compiler());
    out.emplace_back("build", build());
    out.emplace_back("build_type", SKYSEAL_BUILD_TYPE);
    out.emplace_back("build_flags", SKYSEAL_BUILD_FLAGS);
    out.emplace_back("commit", kBuildCommit);
    return out;
}

} // namespace skyseal::experiment
