#include "core/experiment/metric.h"

#include "core/base/number_text.h"
#include "core/metrics/histogram.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

/// Percentiles are upper ends of histogram buckets, whose width is at most this share of the value.
constexpr Resolution kHistogramStep{.share = 1.0 / (1u << metrics::Histogram::kStepBits)};
/// At each of the two ends of a run, chance decides whether one frame is counted.
constexpr double kEdgeFrames = 2;

constexpr std::array<MetricInfo, kMetrics> kTable{{
    {.metric = Metric::Packets,
     .key = "packets",
     .title = sentence("Metric", "Packets transmitted"),
     .description = sentence(
         "Metric",
         "MAVLink frames that the station received from the vehicle during the run, without duplicates of clear frames"),
     .resolution = {.frames = kEdgeFrames},
     .setByVehicle = true,
     .shownIn = kPaperFigure | kDifferences | kEveryRun | kRatio},
    {.metric = Metric::FrameRate,
     .key = "frame_rate",
     .title = sentence("Metric", "Rate"),
     .unit = "frames/s",
     .description = sentence("Metric", "packets per second"),
     .resolution = {.frames = kEdgeFrames, .perSecond = true},
     .setByVehicle = true,
     .shownIn = kFigure | kDifferences | kTerminal},
    {.metric = Metric::ByteRate,
     .key = "byte_rate",
     .title = sentence("Metric", "Rate in bytes"),
     .unit = "B/s",
     .description = sentence("Metric", "MAVLink bytes received per second, after opening"),
     .setByVehicle = true},
    {.metric = Metric::Loss,
     .key = "loss",
     .title = sentence("Metric", "Frames lost"),
     .description = sentence(
         "Metric",
         "share of the vehicle's frames missing by MAVLink sequence numbers, 0 to 1; empty where jitter reorders the "
         "frames of the saturated load by more than 8 bits can number"),
     .shareOf = ShareOf::Frames,
     .shownIn = kFigure | kDifferences | kEveryRun | kTerminal},
    {.metric = Metric::RecordLoss,
     .key = "record_loss",
     .title = sentence("Metric", "Records lost, to the station"),
     .description = sentence("Metric", "share of the agent's records missing by their counters, 0 to 1"),
     .shareOf = ShareOf::RecordsToStation,
     .shownIn = kFigure | kDifferences},
    {.metric = Metric::RecordLossUp,
     .key = "record_loss_up",
     .title = sentence("Metric", "Records lost, to the agent"),
     .description = sentence("Metric",
                             "the same in the other direction, as counted by the agent and reported over the sealed link"),
     .shareOf = ShareOf::RecordsToAgent},
    {.metric = Metric::Cpu,
     .key = "cpu",
     .title = sentence("Metric", "CPU load, station"),
     .unit = "%",
     .description = sentence("Metric",
                             "CPU time of the station's I/O thread (receive, open, parse, send), percent of one core"),
     .shownIn = kPaperFigure | kDifferences | kEveryRun},
    {.metric = Metric::CpuProcess,
     .key = "cpu_process",
     .title = sentence("Metric", "CPU load, station's process"),
     .unit = "%",
     .description = sentence("Metric", "all threads of the measuring program")},
    {.metric = Metric::MeterCpu,
     .key = "meter_cpu",
     .title = sentence("Metric", "Share of the measurement in the CPU load, station"),
     .unit = "%",
     .description = sentence(
         "Metric",
         "CPU time in which the station's I/O thread made and handed out snapshots, probes and time lines, by its own clock, "
         "percent of its CPU time"),
     .explains = true},
    {.metric = Metric::Readings,
     .key = "readings",
     .title = sentence("Metric", "Snapshots during the run, station"),
     .description = sentence(
         "Metric",
         "snapshots that the station's I/O thread built from the first probe of the run on: 1, which is the last "
         "probe, or those of a window as well"),
     .explains = true},
    {.metric = Metric::CpuSuite,
     .key = "cpu_suite",
     .title = sentence("Metric", "CPU load of the suite, station"),
     .unit = "%",
     .description = sentence("Metric", "time inside seal and open, clocked around each call, percent of one core"),
     .zeroInPlain = true},
    {.metric = Metric::AgentCpu,
     .key = "agent_cpu",
     .title = sentence("Metric", "CPU load, agent"),
     .unit = "%",
     .description = sentence(
         "Metric",
         "CPU time of the agent's process, by the kernel's clock of it over the whole run for all arms alike; where the agent "
         "runs on another machine, between its reports over the sealed link, and empty in plain MAVLink, which has no reports"),
     .shownIn = kFigure | kDifferences | kEveryRun | kTerminal},
    {.metric = Metric::AgentCpuSuite,
     .key = "agent_cpu_suite",
     .title = sentence("Metric", "CPU load of the suite, agent"),
     .unit = "%",
     .description = sentence("Metric",
                             "time inside seal and open at the agent, reported over the sealed link, percent of one core"),
     .zeroInPlain = true},
    {.metric = Metric::CpuPerFrame,
     .key = "cpu_per_frame",
     .title = sentence("Metric", "CPU time per frame, station"),
     .unit = "ns",
     .description = sentence("Metric", "CPU time of the I/O thread divided by frames"),
     .shownIn = kFigure | kDifferences | kEveryRun | kTerminal | kRatio},
    {.metric = Metric::AgentCpuPerFrame,
     .key = "agent_cpu_per_frame",
     .title = sentence("Metric", "CPU time per frame, agent"),
     .unit = "ns",
     .description = sentence("Metric", "CPU load of the agent divided by the frame rate of the run"),
     .shownIn = kFigure | kDifferences | kRatio},
    {.metric = Metric::OpenP50,
     .key = "open_p50",
     .title = sentence("Metric", "Opening a record, median"),
     .unit = "ns",
     .description = sentence("Metric", "clocked around each call, including look-up and replay window; exact to 1/32"),
     .resolution = kHistogramStep,
     .shownIn = kFigure | kDifferences | kEveryRun | kTerminal},
    {.metric = Metric::OpenP99,
     .key = "open_p99",
     .title = sentence("Metric", "Opening a record, 99th percentile"),
     .unit = "ns",
     .description = sentence("Metric", "the same"),
     .resolution = kHistogramStep,
     .shownIn = kEveryRun},
    {.metric = Metric::SealP50,
     .key = "seal_p50",
     .title = sentence("Metric", "Sealing a record, median"),
     .unit = "ns",
     .description = sentence("Metric", "clocked around each call, at the station"),
     .resolution = kHistogramStep},
    {.metric = Metric::SealP99,
     .key = "seal_p99",
     .title = sentence("Metric", "Sealing a record, 99th percentile"),
     .unit = "ns",
     .description = sentence("Metric", "the same"),
     .resolution = kHistogramStep},
    {.metric = Metric::AgentOpen,
     .key = "agent_open",
     .title = sentence("Metric", "Opening a record, agent"),
     .unit = "ns",
     .description = sentence("Metric", "mean, clocked around each call at the agent, reported over the sealed link")},
    {.metric = Metric::AgentSeal,
     .key = "agent_seal",
     .title = sentence("Metric", "Sealing a record, agent"),
     .unit = "ns",
     .description = sentence("Metric", "the same")},
    {.metric = Metric::Memory,
     .key = "memory",
     .title = sentence("Metric", "Memory, station"),
     .unit = "B",
     .description = sentence(
         "Metric",
         "resident set of the measuring program at the end of the run; one process runs all suites, so the value does "
         "not belong to one suite"),
     .independent = false,
     .shownIn = kEveryRun},
    {.metric = Metric::AgentMemory,
     .key = "agent_memory",
     .title = sentence("Metric", "Memory, agent"),
     .unit = "B",
     .description = sentence(
         "Metric",
         "resident set of the agent at the end of the run, from /proc for all arms alike; where the agent runs on another "
         "machine, as reported over the sealed link; one process runs all suites, so the value does not belong to one suite"),
     .independent = false},
    {.metric = Metric::WireBytes,
     .key = "wire_bytes",
     .title = sentence("Metric", "Bytes on the wire"),
     .unit = "B",
     .description = sentence("Metric", "UDP payload of both directions during the run")},
    {.metric = Metric::WireRate,
     .key = "wire_rate",
     .title = sentence("Metric", "Bytes on the wire, to the station"),
     .unit = "B/s",
     .description = sentence("Metric", "UDP payload per second")},
    {.metric = Metric::LineLoad,
     .key = "line_load",
     .title = sentence("Metric", "Use of the line, to the station"),
     .unit = "%",
     .description = sentence(
         "Metric",
         "bytes that the impaired line carried to the station, announcements of the agent included and duplicates of the "
         "relay left out, percent of its rate; empty without a limited rate"),
     .explains = true},
    {.metric = Metric::WirePerFrame,
     .key = "wire_per_frame",
     .title = sentence("Metric", "Wire cost of a frame"),
     .unit = "B",
     .description = sentence("Metric",
                             "bytes to the station, including 28 of IPv4 and UDP headers for each datagram, divided by frames"),
     .shownIn = kFigure | kDifferences | kEveryRun | kRatio},
    {.metric = Metric::Overhead,
     .key = "overhead",
     .title = sentence("Metric", "Overhead on the wire"),
     .unit = "%",
     .description = sentence("Metric", "UDP payload to the station beyond the MAVLink bytes in it, percent of these"),
     .zeroInPlain = true},
    {.metric = Metric::FramesPerDatagram,
     .key = "frames_per_datagram",
     .title = sentence("Metric", "Frames in a datagram"),
     .description = sentence(
         "Metric",
         "MAVLink frames divided by the datagrams to the station, each of which is a record in the sealed framing; the "
         "fewer, the more records and wake-ups a frame costs"),
     .shownIn = kDifferences | kEveryRun},
    {.metric = Metric::Latency,
     .key = "latency",
     .title = sentence("Metric", "Latency"),
     .unit = "ms",
     .description = sentence("Metric", "round trip of TIMESYNC to the vehicle, mean of the run"),
     .shownIn = kFigure | kDifferences | kEveryRun | kTerminal | kRatio},
    {.metric = Metric::SessionMemory,
     .key = "session_memory",
     .title = sentence("Metric", "Memory of a session"),
     .unit = "B",
     .description = sentence(
         "Metric",
         "heap of a session at one end, including its keyed ciphers; measured once for each suite with separate sessions "
         "of this program"),
     .oncePerSuite = true},
    {.metric = Metric::Power,
     .key = "power",
     .title = sentence("Metric", "Power of the machine"),
     .unit = "W",
     .description = sentence(
         "Metric",
         "mean over the run, by the kernel's energy counters of the processor or the sensor of the supply: with all programs "
         "on it")},
    {.metric = Metric::PowerAboveIdle,
     .key = "power_above_idle",
     .title = sentence("Metric", "Power above idle"),
     .unit = "W",
     .description = sentence("Metric",
                             "the same, less the power of the idle machine before and after the launch of the programs"),
     .canBeNegative = true,
     .shownIn = kFigure | kDifferences},
    {.metric = Metric::EnergyPerFrame,
     .key = "energy_per_frame",
     .title = sentence("Metric", "Energy per frame"),
     .unit = "µJ",
     .description = sentence("Metric",
                             "the energy above idle divided by frames received by the station; all programs of the sweep"),
     .canBeNegative = true,
     .shownIn = kFigure | kDifferences},
    {.metric = Metric::Switch,
     .key = "switch",
     .title = sentence("Metric", "Time of the live switch"),
     .unit = "ms",
     .description = sentence(
         "Metric",
         "from the first order of the run to the confirmation by the other end, including orders that were not confirmed in "
         "time; empty if the suite of the run was in use already")},
    {.metric = Metric::WakeUps,
     .key = "wake_ups",
     .title = sentence("Metric", "Wake-ups, station"),
     .unit = "1/s",
     .description = sentence("Metric", "voluntary context switches of the station's I/O thread per second"),
     .explains = true},
    {.metric = Metric::Preemptions,
     .key = "preemptions",
     .title = sentence("Metric", "Involuntary context switches, station"),
     .unit = "1/s",
     .description = sentence("Metric", "of the station's I/O thread per second: another program took its core"),
     .explains = true},
    {.metric = Metric::AgentWakeUps,
     .key = "agent_wake_ups",
     .title = sentence("Metric", "Wake-ups, agent"),
     .unit = "1/s",
     .description = sentence("Metric",
                             "voluntary context switches of the agent's main thread per second, on the same machine only"),
     .explains = true},
    {.metric = Metric::AgentPreemptions,
     .key = "agent_preemptions",
     .title = sentence("Metric", "Involuntary context switches, agent"),
     .unit = "1/s",
     .description = sentence("Metric", "of the agent's main thread per second, on the same machine only"),
     .explains = true},
    {.metric = Metric::SimulatorCpu,
     .key = "simulator_cpu",
     .title = sentence("Metric", "CPU load, simulator"),
     .unit = "%",
     .description = sentence("Metric", "CPU time of the simulator that the sweep started, percent of one core"),
     .explains = true},
    {.metric = Metric::RelayCpu,
     .key = "relay_cpu",
     .title = sentence("Metric", "CPU load, relay"),
     .unit = "%",
     .description = sentence("Metric", "CPU time of the relay of an impaired link, percent of one core"),
     .explains = true},
    {.metric = Metric::AutopilotCpu,
     .key = "autopilot_cpu",
     .title = sentence("Metric", "CPU load, autopilot"),
     .unit = "%",
     .description = sentence(
         "Metric",
         "CPU time of the autopilot beside which the sweep ran, percent of one core; empty if its process was not found "
         "on this machine"),
     .explains = true},
    {.metric = Metric::MissedSends,
     .key = "missed_sends",
     .title = sentence("Metric", "Missed sends of the paced load"),
     .unit = "",
     .description = sentence(
         "Metric",
         "frames that the generator of a paced load did not send, since it was 20 ms late on its schedule or its queue "
         "was full; exact to a tenth of a second at the ends of the run; empty under other loads"),
     .explains = true},
    {.metric = Metric::OtherCpu,
     .key = "other_cpu",
     .title = sentence("Metric", "CPU load, other programs"),
     .unit = "%",
     .description = sentence(
         "Metric",
         "CPU time of this machine that was used neither by the measuring program, nor by programs that the sweep started or "
         "the autopilot, "
         "percent of one core; exact to the ticks of the kernel's clock on each core"),
     .explains = true},
    {.metric = Metric::Steal,
     .key = "steal",
     .title = sentence("Metric", "Time taken by the hypervisor"),
     .unit = "%",
     .description = sentence("Metric", "time in which a virtual core had work and was not run, percent of one core"),
     .explains = true},
    {.metric = Metric::Frequency,
     .key = "frequency",
     .title = sentence("Metric", "Frequency of the cores"),
     .unit = "MHz",
     .description = sentence("Metric", "mean over the cores and over the two ends of the run, as the kernel states it"),
     .explains = true},
    {.metric = Metric::FrequencyChange,
     .key = "frequency_change",
     .title = sentence("Metric", "Change of the frequency of the cores"),
     .unit = "%",
     .description = sentence("Metric", "difference between the two ends of the run, percent of their mean"),
     .explains = true},
    {.metric = Metric::LoadBegin,
     .key = "load_begin",
     .title = sentence("Metric", "Load average per core, at the start"),
     .description = sentence(
         "Metric",
         "load average of the last minute at the start of the run, divided by the number of cores; the sweep's own programs "
         "are part of it"),
     .explains = true},
    {.metric = Metric::LoadEnd,
     .key = "load_end",
     .title = sentence("Metric", "Load average per core, at the end"),
     .description = sentence("Metric", "the same at the end of the run"),
     .explains = true},
    {.metric = Metric::IdlePower,
     .key = "idle_power",
     .title = sentence("Metric", "Power of the idle machine"),
     .unit = "W",
     .description = sentence("Metric",
                             "mean of five seconds before the programs of the launch started and five after they ended"),
     .explains = true},
    {.metric = Metric::IdlePowerChange,
     .key = "idle_power_change",
     .title = sentence("Metric", "Change of the power of the idle machine"),
     .unit = "%",
     .description = sentence("Metric", "difference between the two, percent of their mean"),
     .explains = true},
    {.metric = Metric::Throttlings,
     .key = "throttlings",
     .title = sentence("Metric", "Throttlings of the processor"),
     .description = sentence(
         "Metric",
         "how often the processor slowed down during the run, hot or short of power: the kernel's counters of cores and "
         "packages, or one where the firmware says so at an end of the run"),
     .explains = true},
}};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < kTable.size(); ++i) {
        if (kTable[i].metric != static_cast<Metric>(i))
            return false;
    }
    return true;
}
static_assert(isInOrder());

std::string grouped(double value, int decimals = 0)
{
    std::string out = fixedText(std::abs(value), decimals);
    for (std::size_t place = std::min(out.find('.'), out.size()); place > 3; place -= 3)
        out.insert(place - 3, ",");
    return (value < 0 ? "-" : "") + out;
}

} // namespace

std::span<const MetricInfo> metrics()
{
    return kTable;
}

const MetricInfo &info(Metric metric)
{
    return kTable[static_cast<std::size_t>(metric)];
}

std::vector<Metric> metricsShownIn(ShownIn place)
{
    std::vector<Metric> out;
    for (const MetricInfo &entry : kTable) {
        if (entry.isShownIn(place))
            out.push_back(entry.metric);
    }
    return out;
}

std::optional<Metric> metricFromKey(std::string_view key)
{
    const auto found = std::find_if(kTable.begin(), kTable.end(), [&](const MetricInfo &entry) { return entry.key == key; });
    return found == kTable.end() ? std::nullopt : std::optional(found->metric);
}

std::string readable(double value)
{
    if (!std::isfinite(value))
        return "–";
    const double size = std::abs(value);
    if (size >= 999.5)
        return grouped(value);
    return significantText(value, 3);
}

std::string intervalText(double value, double low, double high)
{
    return fixedText(value, 3) + " (" + fixedText(low, 3) + "–" + fixedText(high, 3) + ")";
}

std::string percentText(double share)
{
    return readable(100 * share) + " %";
}

std::string readable(double mean, double low, double high)
{
    constexpr int kMostDecimals = 6, kMostOfNone = 9;
    const double above = high - mean, below = mean - low;
    const double halfWidth = std::max(above, below);
    if (!std::isfinite(mean) || !std::isfinite(low) || !std::isfinite(high))
        return readable(mean);
    if (halfWidth == 0)
        return readable(mean) + " ± 0";
    const int digits = 1 - static_cast<int>(std::floor(std::log10(halfWidth)));
    if (mean == 0 && low == 0)
        return "0 (≤ " + grouped(high, std::clamp(digits, 0, kMostOfNone)) + ")";
    const int decimals = std::clamp(digits, 0, kMostDecimals);
    if (low == 0 && above > mean)
        return grouped(mean, decimals) + " (≤ " + grouped(high, decimals) + ")";
    if (below > above * (1 + 1e-6))
        return grouped(mean, decimals) + " (≥ " + grouped(low, decimals) + ")";
    return grouped(mean, decimals) + " ± " + grouped(halfWidth, decimals);
}

} // namespace skyseal::experiment
