// What the processor draws, where the kernel shows it: the energy counters of its packages (Linux "powercap", from Intel's and
// AMD's RAPL). They count the whole processor, not a process, and most systems let only root read them (CVE-2020-8694).
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

    /// Looks for packages in the folder, once.
    explicit EnergyMeter(const std::string &folder = kFolder);

    /// Sum over all packages since this was made, never going back though each counter wraps; nullopt where there is none or
    /// it cannot be read. Call it more often than the smallest counter wraps (some minutes at full load).
    std::optional<std::uint64_t> microjoules();
    /// What is read, "package-0, package-1"; or why nothing is, "not readable here: …".
    std::string describe() const;

private:
    struct Package
    {
        std::string name, file;
        std::uint64_t range = 0; ///< the counter goes from here to 0
        std::uint64_t last = 0;
    };

    std::vector<Package> m_packages;
    std::string m_problem;
    std::uint64_t m_sum = 0;
};

} // namespace skyseal::metrics
