#include "core/experiment/metric.h"

#include "core/metrics/histogram.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace skyseal::experiment {

namespace {

/// Percentiles are ends of a histogram's buckets, which are at most this far apart.
constexpr Resolution kHistogramStep{1.0 / (1u << metrics::Histogram::kStepBits)};
/// Whether a frame falls within a run or next to it is chance, at each of the run's two ends.
constexpr double kEdgeFrames = 2;

constexpr std::array<MetricInfo, kMetrics> kTable{{
    {Metric::Packets,
     "packets",
     "Packets transmitted",
     "",
     "MAVLink frames that the station took in from the vehicle during the run, second copies of clear ones left out",
     {0, kEdgeFrames}},
    {Metric::FrameRate, "frame_rate", "Rate", "frames/s", "the same for each second", {0, kEdgeFrames, true}},
    {Metric::ByteRate, "byte_rate", "Rate in bytes", "B/s", "MAVLink bytes taken in for each second, after opening"},
    {Metric::Loss, "loss", "Frames lost", "",
     "share of the vehicle's frames missing by MAVLink sequence numbers, 0 to 1; not told where jitter lets frames "
     "of the saturated load overtake more others than 8 bits can number"},
    {Metric::RecordLoss, "record_loss", "Records lost, to the station", "",
     "share of the agent's records missing by their counters, 0 to 1"},
    {Metric::RecordLossUp, "record_loss_up", "Records lost, to the agent", "",
     "the same in the other direction, as the agent counted and reported it over the sealed link"},
    {Metric::Cpu, "cpu", "CPU load, station", "%",
     "CPU time of the station's I/O thread (receive, open, parse, send), percent of one core"},
    {Metric::CpuProcess, "cpu_process", "CPU load, station's process", "%", "all threads of the measuring program"},
    {Metric::CpuSuite,
     "cpu_suite",
     "CPU load of the suite, station",
     "%",
     "time inside seal and open, clocked around each call, percent of one core",
     {},
     true,
     true},
    {Metric::AgentCpu, "agent_cpu", "CPU load, agent", "%",
     "CPU time of the agent's process, as it reports over the sealed link; in clear and in runs of under 2 s by the kernel's "
     "clock of that process, same machine only"},
    {Metric::AgentCpuSuite,
     "agent_cpu_suite",
     "CPU load of the suite, agent",
     "%",
     "time inside seal and open at the agent, as it reports over the sealed link, percent of one core",
     {},
     true,
     true},
    {Metric::CpuPerFrame, "cpu_per_frame", "CPU time per frame, station", "ns", "I/O thread's time divided by frames"},
    {Metric::AgentCpuPerFrame, "agent_cpu_per_frame", "CPU time per frame, agent", "ns",
     "agent's CPU load over its reports, divided by the frame rate of the run"},
    {Metric::OpenP50, "open_p50", "Opening a record, median", "ns",
     "clocked around each call, look-up and replay window included; exact to 1/32", kHistogramStep},
    {Metric::OpenP99, "open_p99", "Opening a record, 99th percentile", "ns", "the same", kHistogramStep},
    {Metric::SealP50, "seal_p50", "Sealing a record, median", "ns", "clocked around each call, at the station", kHistogramStep},
    {Metric::SealP99, "seal_p99", "Sealing a record, 99th percentile", "ns", "the same", kHistogramStep},
    {Metric::AgentOpen, "agent_open", "Opening a record, agent", "ns",
     "mean, clocked around each call at the agent, as it reports over the sealed link"},
    {Metric::AgentSeal, "agent_seal", "Sealing a record, agent", "ns", "the same"},
    {Metric::Memory,
     "memory",
     "Memory, station",
     "B",
     "resident set of the measuring program at the end of the run; one process through all suites, so no suite's own",
     {},
     false},
    {Metric::AgentMemory,
     "agent_memory",
     "Memory, agent",
     "B",
     "resident set of the agent at the end of the run, as it reports over the sealed link, otherwise from /proc, same machine "
     "only; one process through all suites, so no suite's own",
     {},
     false},
    {Metric::WireBytes, "wire_bytes", "Bytes on the wire", "B", "UDP payload of both directions during the run"},
    {Metric::WireRate, "wire_rate", "Bytes on the wire, to the station", "B/s", "UDP payload for each second"},
    {Metric::WirePerFrame, "wire_per_frame", "Wire cost of a frame", "B",
     "bytes to the station, 28 of IPv4 and UDP headers for each datagram included, divided by frames"},
    {Metric::Overhead,
     "overhead",
     "Overhead on the wire",
     "%",
     "UDP payload to the station over the MAVLink bytes in it",
     {},
     true,
     true},
    {Metric::Latency, "latency", "Latency", "ms", "TIMESYNC to the vehicle and back, mean of the run"},
    {Metric::SessionMemory, "session_memory", "Memory of a session", "B",
     "heap that one end's session takes, its keyed ciphers included; measured in this program with a session of its own"},
    {Metric::Power, "power", "Power of the processor", "W",
     "mean over the run, by the kernel's energy counters: the whole processor and all that runs on it"},
    {Metric::EnergyPerFrame, "energy_per_frame", "Energy per frame", "µJ",
     "the same energy divided by frames taken in by the station, idle power included"},
    {Metric::Switch, "switch", "Time of the live switch", "ms",
     "from the run's first order until the other end confirmed, orders that it did not confirm in time included; when the run's "
     "suite was not in use already"},
}};

std::string grouped(double value, int decimals = 0)
{
    char digits[400];
    std::snprintf(digits, sizeof digits, "%.*f", decimals, std::abs(value));
    std::string out(digits);
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

bool isShare(Metric metric)
{
    return metric == Metric::Loss || metric == Metric::RecordLoss || metric == Metric::RecordLossUp;
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
    char out[32];
    std::snprintf(out, sizeof out, "%.3g", value == 0 ? 0.0 : value);
    return out;
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
