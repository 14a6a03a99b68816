// Energy drawn by the machine, by what its kernel offers: counters of the processor's packages (Linux powercap; RAPL of Intel
// and AMD), energy counters of hwmon, or the power of a supply sensor of hwmon or IIO (INA2xx and the like on companion
// computers), which is added up over time. They count the processor or the whole board, not a process, and most systems allow
// only root to read the first (CVE-2020-8694).
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::metrics {

class EnergyMeter
{
public:
    static constexpr const char *kSysfs = "/sys";

    /// Searches below `sysfs`, once, and takes the first kind that can be read: packages, energy counters, a power sensor.
    explicit EnergyMeter(const std::string &sysfs = kSysfs);

    /// Microjoules since this object was made; nullopt when nothing can be read. Handles counters that wrap, if called more
    /// often than the smallest one wraps (some minutes at full load). The power of a sensor counts from call to call, as the
    /// mean of the two readings, so that it has to be called some ten times a second.
    std::optional<std::uint64_t> microjoules(TimePoint now);
    /// The sensors, "package-0, package-1" or "power1 of ina226 (hwmon)", or the reason why there is nothing, "not readable
    /// here: …".
    std::string describe() const;

private:
    struct Counter
    {
        std::string name, file;
        std::uint64_t range = 0; ///< largest value before the counter wraps to 0; 0: it does not
        std::uint64_t last = 0;
    };
    /// Of several sensors of a chip the one that reads most: the supply of the others.
    struct Sensor
    {
        std::string name, file;
        double microwatts = 1; ///< of one unit of the file
        double last = 0;       ///< microwatts at `read`
        TimePoint read = kNever;
    };

    void findPackages(const std::string &folder);
    void findCounters(const std::string &folder);
    void findSensor(const std::string &folder, const char *kind);
    void findSensor(const std::string &device, const std::string &label);
    bool addCounters();
    bool addPower(TimePoint now);

    std::vector<Counter> m_counters;
    std::optional<Sensor> m_sensor;
    std::string m_problem;
    double m_sum = 0; ///< microjoules
};

} // namespace skyseal::metrics
