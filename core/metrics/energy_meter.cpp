#include "core/metrics/energy_meter.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace skyseal::metrics {

namespace {

std::optional<std::uint64_t> numberIn(const std::string &file)
{
    std::ifstream in(file);
    std::uint64_t value = 0;
    return in >> value ? std::optional(value) : std::nullopt;
}

std::string lineIn(const std::string &file)
{
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

} // namespace

EnergyMeter::EnergyMeter(const std::string &folder)
{
    std::error_code error;
    std::vector<std::string> zones;
    for (const auto &entry : std::filesystem::directory_iterator(folder, error))
        zones.push_back(entry.path().string());
    if (error) {
        m_problem = folder + ": " + error.message();
        return;
    }
    std::sort(zones.begin(), zones.end());
    for (const std::string &zone : zones) {
        // Other zones are parts of a package (core, dram) or contain it (psys), so only packages are summed.
        Package package{lineIn(zone + "/name"), zone + "/energy_uj", 0, 0};
        if (package.name.rfind("package", 0) != 0)
            continue;
        const auto now = numberIn(package.file);
        if (!now) {
            m_problem = package.file + " is not for this user to read";
            m_packages.clear();
            return;
        }
        package.last = *now;
        package.range = numberIn(zone + "/max_energy_range_uj").value_or(0);
        m_packages.push_back(std::move(package));
    }
    if (m_packages.empty())
        m_problem = folder + " shows no processor package";
}

std::optional<std::uint64_t> EnergyMeter::microjoules()
{
    if (m_packages.empty())
        return std::nullopt;
    for (Package &package : m_packages) {
        const auto now = numberIn(package.file);
        if (!now)
            return std::nullopt;
        m_sum += *now >= package.last ? *now - package.last : package.range - package.last + *now;
        package.last = *now;
    }
    return m_sum;
}

std::string EnergyMeter::describe() const
{
    if (m_packages.empty())
        return "not readable here: " + m_problem;
    std::string out;
    for (const Package &package : m_packages)
        out += (out.empty() ? "" : ", ") + package.name;
    return out;
}

} // namespace skyseal::metrics
