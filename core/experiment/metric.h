// What is measured in each run: keys as scripts and files name them, units, and in one sentence what each one is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

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
    WirePerFrame,
    Overhead,
    Latency,
    SessionMemory,
    Power,
    EnergyPerFrame,
    Switch
};
inline constexpr std::size_t kMetrics = 30;

/// What an instrument cannot tell apart: differences of means within it say nothing, however often they repeat.
struct Resolution
{
    double share = 0;       ///< of the value
    double frames = 0;      ///< in a run
    bool perSecond = false; ///< the value is those frames divided by the seconds of the run
};

struct MetricInfo
{
    Metric metric{};
    std::string_view key;   ///< "cpu_per_frame"
    std::string_view title; ///< "CPU time per frame, station"
    std::string_view unit;  ///< "ns"; empty for plain numbers
    std::string_view what;  ///< where it comes from
    Resolution resolution{};
    /// False for what one process carries from run to run, so that no run says anything that the one before did not: no interval
    /// can be given then, and no two suites be compared.
    bool independent = true;
    /// What plain MAVLink has none of by definition, so that its zero is compared with nothing.
    bool zeroInPlain = false;
};

std::span<const MetricInfo> metrics();
const MetricInfo &info(Metric metric);
/// Of frames or records that were lost: between 0 and 1, and people read it in per cent.
bool isShare(Metric metric);
std::optional<Metric> metricFromKey(std::string_view key);

/// One value for each metric; NaN = could not be measured, such as a record's cost without records.
class Values
{
public:
    Values() { m_values.fill(std::numeric_limits<double>::quiet_NaN()); }
    double &operator[](Metric metric) { return m_values[static_cast<std::size_t>(metric)]; }
    double operator[](Metric metric) const { return m_values[static_cast<std::size_t>(metric)]; }

private:
    std::array<double, kMetrics> m_values;
};

/// A number with a sensible count of digits for people: "1,234,567", "12.3", "0.00042"; "–" when it is not finite.
std::string readable(double value);
/// A mean with its interval: "21.613 ± 0.077", two digits of the half width, and the mean to the same place. "0.012 (≤ 0.034)"
/// where the interval was cut at zero, "0.98 (≥ 0.91)" where it was cut at its upper end. The mean alone where an end is not finite.
std::string readable(double mean, double low, double high);

} // namespace skyseal::experiment
