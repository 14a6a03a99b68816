// The metrics of a run and the one table that describes them: key for scripts and files, title, unit, description, statistical
// properties, and the places that show it. A new metric is an enumerator, its row in metric.cpp, and the code that measures it.
#pragma once

#include "core/base/reason.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::experiment {

/// In the order of the table in metric.cpp.
enum class Metric : std::uint8_t {
    Packets,
    FrameRate,
    ByteRate,
    Loss,
    RecordLoss,
    RecordLossUp,
    Cpu,
    CpuProcess,
    MeterCpu,
    Readings,
    CpuSuite,
    AgentCpu,
    AgentCpuSuite,
    CpuPerFrame,
    AgentCpuPerFrame,
    OpenP50,
    OpenP99,
    SealP50,
    SealP99,
    AgentOpen,
    AgentSeal,
    Memory,
    AgentMemory,
    WireBytes,
    WireRate,
    LineLoad,
    WirePerFrame,
    Overhead,
    FramesPerDatagram,
    Latency,
    SessionMemory,
    Power,
    PowerAboveIdle,
    EnergyPerFrame,
    Switch,
    WakeUps,
    Preemptions,
    AgentWakeUps,
    AgentPreemptions,
    SimulatorCpu,
    RelayCpu,
    AutopilotCpu,
    MissedSends,
    OtherCpu,
    Steal,
    Frequency,
    FrequencyChange,
    LoadBegin,
    LoadEnd,
    IdlePower,
    IdlePowerChange,
    Throttlings
};
inline constexpr std::size_t kMetrics = static_cast<std::size_t>(Metric::Throttlings) + 1;

/// Precision of an instrument. A difference of means within it is never significant, however often the runs are repeated.
struct Resolution
{
    double share = 0;       ///< of the value
    double frames = 0;      ///< in a run
    bool perSecond = false; ///< the value is those frames divided by the seconds of the run
};

/// The whole of which a metric is a share, if it is one: a value from 0 to 1, which reports print in per cent.
enum class ShareOf : std::uint8_t { Nothing, Frames, RecordsToStation, RecordsToAgent };

/// Flags: places that show a selection of the metrics. Tables of results, files and the window show all.
enum ShownIn : unsigned {
    kFigure = 1,          ///< a figure of the report
    kPaperFigure = 1 | 2, ///< a figure that the paper has as well; these come first
    kDifferences = 4,     ///< significant differences and the A/A comparison in the report
    kEveryRun = 8,        ///< the report's table of every run
    kTerminal = 16,       ///< the tables on the terminal
    kRatio = 32           ///< a figure of the ratios to plain MAVLink, and the ratios on the terminal
};

struct MetricInfo
{
    Metric metric{};
    std::string_view key;       ///< "cpu_per_frame"
    Sentence title;             ///< "CPU time per frame, station"
    std::string_view unit = {}; ///< "ns"; empty for plain numbers
    Sentence description;       ///< how it is measured
    Resolution resolution{};
    ShareOf shareOf = ShareOf::Nothing;
    /// False if the value is carried from run to run by a process that lives through all of them. Such runs are not independent
    /// samples: there is no confidence interval, and suites are not compared.
    bool independent = true;
    /// True if plain MAVLink has the value 0 by definition. It is not compared then.
    bool zeroInPlain = false;
    bool canBeNegative = false; ///< a difference itself, so that arms are compared by differences and not by ratios
    bool explains = false;      ///< what may have disturbed a run, and no property of a suite: suites are not compared by it
    bool setByVehicle =
        false; ///< except under the saturated load, the only one that uses a suite up: it is compared there alone
    bool oncePerSuite = false; ///< measured once for each suite instead of in each run
    unsigned shownIn = 0;      ///< flags of ShownIn

    bool isShare() const { return shareOf != ShareOf::Nothing; }
    bool isShownIn(ShownIn place) const { return (shownIn & place) == place; }
};

std::span<const MetricInfo> metrics();
const MetricInfo &info(Metric metric);
/// Metrics that a place shows, in the order of the table.
std::vector<Metric> metricsShownIn(ShownIn place);
std::optional<Metric> metricFromKey(std::string_view key);

/// One value for each metric; NaN if it could not be measured, such as the cost of a record in plain MAVLink.
class Values
{
public:
    Values() { m_values.fill(std::numeric_limits<double>::quiet_NaN()); }
    double &operator[](Metric metric) { return m_values[static_cast<std::size_t>(metric)]; }
    double operator[](Metric metric) const { return m_values[static_cast<std::size_t>(metric)]; }

private:
    std::array<double, kMetrics> m_values;
};

/// A number in three significant digits, or as a whole number from 1000 on: "1,234,567", "12.3", "0.00042"; "–" if not finite.
std::string readable(double value);
/// A mean with its interval: "21.613 ± 0.077", with two digits of the half width, and the mean to the same decimal place.
/// "0.012 (≤ 0.034)" if the interval is cut off at zero, "0.98 (≥ 0.91)" if it is cut off at its upper limit. Only the mean if
/// one end is not finite.
std::string readable(double mean, double low, double high);
/// A ratio with its interval in three decimals: "0.850 (0.810–0.890)".
std::string intervalText(double value, double low, double high);
/// 0.125: "12.5 %".
std::string percentText(double share);

} // namespace skyseal::experiment
