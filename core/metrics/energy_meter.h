// Energy counters of the processor packages (Linux powercap; RAPL of Intel and AMD). They count the whole processor, not a
// process, and most systems allow only root to read them (CVE-2020-8694).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::metrics {

class EnergyMeter
{
public:
    static constexpr const char *kFolder = "/sys/class/powercap";

    /// Searches `folder` for packages, once.
    explicit EnergyMeter(const std::string &folder = kFolder);

    /// Microjoules of all packages since this object was made; nullopt when there is no readable counter. Handles counters
    /// that wrap, if called more often than the smallest one wraps (some minutes at full load).
    std::optional<std::uint64_t> microjoules();
    /// The counters that are read, "package-0, package-1", or the reason why there are none, "not readable here: …".
    std::string describe() const;

private:
    struct Package
    {
        std::string name, file;
        std::uint64_t range = 0; ///< largest value before the counter wraps to 0
        std::uint64_t last = 0;
    };

    std::vector<Package> m_packages;
    std::string m_problem;
    std::uint64_t m_sum = 0;
};

} // namespace skyseal::metrics
