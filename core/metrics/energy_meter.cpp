#include "core/metrics/energy_meter.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace skyseal::metrics {

namespace {

template<typename T> std::optional<T> numberIn(const std::string &file)
{
    std::ifstream in(file);
    T value{};
    return in >> value ? std::optional(value) : std::nullopt;
}

std::string lineIn(const std::string &file)
{
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

/// The entries of a folder in the order of their names; empty if it cannot be read.
std::vector<std::string> entriesOf(const std::string &folder)
{
    std::error_code error;
    std::vector<std::string> out;
    for (const auto &entry : std::filesystem::directory_iterator(folder, error))
        out.push_back(entry.path().string());
    std::sort(out.begin(), out.end());
    return out;
}

std::string fileName(const std::string &path)
{
    return std::filesystem::path(path).filename().string();
}

/// Of the supply: graphics cards, batteries and disks have sensors as well. Names of the kernel's drivers
/// (Documentation/hwmon of the kernel).
bool measuresTheMachine(const std::string &chip)
{
    constexpr std::array<std::string_view, 4> kBegin{"ina", "amd_energy", "power_meter", "fam15h_power"};
    return std::any_of(kBegin.begin(), kBegin.end(), [&chip](std::string_view begin) { return chip.rfind(begin, 0) == 0; });
}

} // namespace

EnergyMeter::EnergyMeter(const std::string &sysfs)
{
    findPackages(sysfs + "/class/powercap");
    if (m_counters.empty())
        findCounters(sysfs + "/class/hwmon");
    if (m_counters.empty())
        findSensor(sysfs + "/class/hwmon", "hwmon");
    if (m_counters.empty() && !m_sensor)
        findSensor(sysfs + "/bus/iio/devices", "IIO");
    if (m_problem.empty())
        m_problem = sysfs + " shows no processor package and no sensor of a supply";
}

void EnergyMeter::findPackages(const std::string &folder)
{
    for (const std::string &zone : entriesOf(folder)) {
        // Other zones are parts of a package (core, dram) or contain it (psys), so only packages are summed.
        Counter package{lineIn(zone + "/name"), zone + "/energy_uj", 0, 0};
        if (package.name.rfind("package", 0) != 0)
            continue;
        const auto now = numberIn<std::uint64_t>(package.file);
        if (!now) {
            m_problem = package.file + " is not for this user to read";
            m_counters.clear();
            return;
        }
        package.last = *now;
        package.range = numberIn<std::uint64_t>(zone + "/max_energy_range_uj").value_or(0);
        m_counters.push_back(std::move(package));
    }
}

void EnergyMeter::findCounters(const std::string &folder)
{
    for (const std::string &device : entriesOf(folder)) {
        const std::string chip = lineIn(device + "/name");
        if (!measuresTheMachine(chip))
            continue;
        for (const std::string &file : entriesOf(device)) {
            const std::string name = fileName(file), label = lineIn(file.substr(0, file.rfind('_')) + "_label");
            // amd_energy: "Esocket0" is the sum of the cores, "Ecore000" and so on.
            if (name.rfind("energy", 0) != 0 || !name.ends_with("_input") || label.rfind("Ecore", 0) == 0)
                continue;
            if (const auto now = numberIn<std::uint64_t>(file))
                m_counters.push_back({name.substr(0, name.find('_')) + " of " + chip + " (hwmon)", file, 0, *now});
        }
    }
}

void EnergyMeter::findSensor(const std::string &folder, const char *kind)
{
    for (const std::string &device : entriesOf(folder)) {
        const std::string chip = lineIn(device + "/name");
        if (measuresTheMachine(chip) && !m_sensor)
            findSensor(device, chip + " (" + kind + ")");
    }
}

void EnergyMeter::findSensor(const std::string &device, const std::string &label)
{
    for (const std::string &file : entriesOf(device)) {
        const std::string name = fileName(file);
        const bool isHwmon = name.rfind("power", 0) == 0 && (name.ends_with("_input") || name.ends_with("_average"));
        const bool isIio = name.rfind("in_power", 0) == 0 && (name.ends_with("_input") || name.ends_with("_raw"));
        const auto reading = isHwmon || isIio ? numberIn<double>(file) : std::nullopt;
        if (!reading)
            continue;
        constexpr double kPerMilliwatt = 1000; // IIO states milliwatts, hwmon microwatts
        double unit = isHwmon ? 1 : kPerMilliwatt;
        if (name.ends_with("_raw"))
            unit *= numberIn<double>(file.substr(0, file.size() - 3) + "scale").value_or(1);
        if (!m_sensor || *reading * unit > m_sensor->last)
            m_sensor = Sensor{name.substr(0, name.rfind('_')) + " of " + label, file, unit, *reading * unit};
    }
}

bool EnergyMeter::addCounters()
{
    for (Counter &counter : m_counters) {
        const auto now = numberIn<std::uint64_t>(counter.file);
        if (!now)
            return false;
        m_sum += static_cast<double>(*now >= counter.last ? *now - counter.last : counter.range - counter.last + *now);
        counter.last = *now;
    }
    return true;
}

bool EnergyMeter::addPower(TimePoint now)
{
    const auto reading = numberIn<double>(m_sensor->file);
    if (!reading)
        return false;
    const double power = *reading * m_sensor->microwatts;
    if (m_sensor->read != kNever)
        m_sum += (power + m_sensor->last) / 2 * seconds(now - m_sensor->read);
    m_sensor->last = power;
    m_sensor->read = now;
    return true;
}

std::optional<std::uint64_t> EnergyMeter::microjoules(TimePoint now)
{
    const bool isRead = m_sensor ? addPower(now) : !m_counters.empty() && addCounters();
    return isRead ? std::optional(static_cast<std::uint64_t>(m_sum)) : std::nullopt;
}

std::string EnergyMeter::describe() const
{
    if (m_sensor)
        return m_sensor->name;
    if (m_counters.empty())
        return "not readable here: " + m_problem;
    std::string out;
    for (const Counter &counter : m_counters)
        out += (out.empty() ? "" : ", ") + counter.name;
    return out;
}

} // namespace skyseal::metrics
