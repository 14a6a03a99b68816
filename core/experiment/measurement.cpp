#include "core/experiment/measurement.h"

#include "core/engine/station/snapshot.h"
#include "core/metrics/sequence_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyseal::experiment {

namespace {

constexpr double kHeaders = 28;        // IPv4 and UDP
constexpr double kLeastReported = 0.9; ///< seconds between two reports; the first ones of a session come at shorter intervals

/// Growth of a counter. Late arrivals reduce a count of losses, but never below zero.
double growth(std::uint64_t begin, std::uint64_t end)
{
    return end > begin ? static_cast<double>(end - begin) : 0;
}

double share(double lost, double received)
{
    return lost + received > 0 ? lost / (lost + received) : std::numeric_limits<double>::quiet_NaN();
}

struct FrameCount
{
    double distinct = 0;
    double lost = 0; ///< NaN where sequence numbers do not count it
};

FrameCount framesBetween(const engine::MavlinkTotals &begin, const engine::MavlinkTotals &end, bool sealed, bool countsLoss)
{
    const double frames = growth(begin.frames, end.frames), lost = growth(begin.lost, end.lost);
    // Duplicates of clear frames are counted as frames; duplicates of records are dropped before that.
    const double copies = sealed || !countsLoss ? 0 : growth(begin.duplicate, end.duplicate);
    return {frames - copies, countsLoss ? lost : std::numeric_limits<double>::quiet_NaN()};
}

struct Traffic
{
    std::uint64_t rxBytes = 0, txBytes = 0, rxDatagrams = 0;
};

Traffic trafficOf(const engine::Snapshot &snapshot)
{
    Traffic out{0 - snapshot.probe->waitingBytes, 0, 0 - snapshot.probe->waitingDatagrams};
    for (const engine::LinkSnapshot &link : snapshot.links) {
        out.rxBytes += link.rxBytes;
        out.txBytes += link.txBytes;
        out.rxDatagrams += link.rxDatagrams;
    }
    return out;
}

void addCosts(Values &out, const engine::Probe &begin, const engine::Probe &end, double time, double frames, bool sealed)
{
    const double ioThread = seconds(end.ioThreadCpu - begin.ioThreadCpu);
    out[Metric::Cpu] = 100 * ioThread / time;
    out[Metric::CpuProcess] = 100 * seconds(end.processCpu - begin.processCpu) / time;
    out[Metric::MeterCpu] = 100 * seconds(end.watchingCpu - begin.watchingCpu) / ioThread;
    out[Metric::CpuPerFrame] = 1e9 * ioThread / frames;
    out[Metric::Memory] = static_cast<double>(end.residentBytes);
    out[Metric::CpuSuite] = 0;
    if (!sealed)
        return;
    const metrics::Histogram open = end.open.since(begin.open), seal = end.seal.since(begin.seal);
    out[Metric::CpuSuite] = 100 * static_cast<double>(open.sum() + seal.sum()) / 1e9 / time;
    if (open.count() > 0) {
        out[Metric::OpenP50] = static_cast<double>(open.percentile(0.5));
        out[Metric::OpenP99] = static_cast<double>(open.percentile(0.99));
    }
    if (seal.count() > 0) {
        out[Metric::SealP50] = static_cast<double>(seal.percentile(0.5));
        out[Metric::SealP99] = static_cast<double>(seal.percentile(0.99));
    }
}

void addChannel(Values &out, const Reading &begin, const Reading &end)
{
    out[Metric::RecordLoss] = share(growth(begin.rx.lost, end.rx.lost), growth(begin.rx.good, end.rx.good));
    out[Metric::RecordLossUp] = share(growth(begin.peerRx.lost, end.peerRx.lost), growth(begin.peerRx.good, end.peerRx.good));
}

void addLatency(Values &out, const engine::Snapshot &begin, const engine::Snapshot &end)
{
    double trips = 0, time = 0;
    for (const engine::VehicleSnapshot &after : end.vehicles) {
        const auto before = std::find_if(begin.vehicles.begin(), begin.vehicles.end(),
                                         [&](const auto &vehicle) { return vehicle.state.systemId == after.state.systemId; });
        if (before == begin.vehicles.end())
            continue;
        trips += growth(before->state.trips, after.state.trips);
        time += after.state.tripSeconds - before->state.tripSeconds;
    }
    if (trips > 0)
        out[Metric::Latency] = 1000 * time / trips;
}

/// Costs between two reports. Each report holds the agent's time, so its delay on the link does not matter.
void addReported(Values &out, const Reading &begin, const Reading &end)
{
    if (!begin.agent || !end.agent)
        return;
    const channel::EndCosts &before = begin.agent->costs, &after = end.agent->costs;
    const double time = static_cast<std::uint32_t>(end.agent->stamp - begin.agent->stamp) / 1e6;
    if (time < kLeastReported)
        return;
    const double sealing = growth(before.sealNanoseconds, after.sealNanoseconds);
    const double opening = growth(before.openNanoseconds, after.openNanoseconds);
    out[Metric::AgentCpu] = 100 * growth(before.cpuMicroseconds, after.cpuMicroseconds) / 1e6 / time;
    out[Metric::AgentMemory] = static_cast<double>(after.residentBytes);
    out[Metric::AgentCpuSuite] = 100 * (sealing + opening) / 1e9 / time;
    if (after.sealed > before.sealed)
        out[Metric::AgentSeal] = sealing / growth(before.sealed, after.sealed);
    if (after.opened > before.opened)
        out[Metric::AgentOpen] = opening / growth(before.opened, after.opened);
}

void addAgent(Values &out, const Reading &begin, const Reading &end, bool sealed)
{
    if (!sealed)
        out[Metric::AgentCpuSuite] = 0;
    if (sealed)
        addReported(out, begin, end);
    // One source for all arms: the kernel, over the whole run, wherever it knows the agent.
    const ProgramUsage &from = begin.programs, &to = end.programs;
    if (from.agentCpu && to.agentCpu)
        out[Metric::AgentCpu] = 100 * seconds(*to.agentCpu - *from.agentCpu) / seconds(to.at - from.at);
    if (to.agentMemory)
        out[Metric::AgentMemory] = static_cast<double>(*to.agentMemory);
    out[Metric::AgentCpuPerFrame] = 1e7 * out[Metric::AgentCpu] / out[Metric::FrameRate]; // from percent to ns
}

/// Percent of one core.
double load(const std::optional<Duration> &begin, const std::optional<Duration> &end, double time)
{
    return begin && end ? 100 * seconds(*end - *begin) / time : std::numeric_limits<double>::quiet_NaN();
}

/// Circumstances that may explain the values of the run. Programs and machine are read beside the station's thread, with a
/// clock of their own.
void addCircumstances(Values &out, const Reading &begin, const Reading &end, double stationTime)
{
    const engine::Probe &before = *begin.station->probe, &after = *end.station->probe;
    out[Metric::WakeUps] = growth(before.wakeUps, after.wakeUps) / stationTime;
    out[Metric::Preemptions] = growth(before.preemptions, after.preemptions) / stationTime;
    const ProgramUsage &from = begin.programs, &to = end.programs;
    const double time = seconds(to.at - from.at);
    if (from.agentSwitches && to.agentSwitches) {
        out[Metric::AgentWakeUps] = growth(from.agentSwitches->voluntary, to.agentSwitches->voluntary) / time;
        out[Metric::AgentPreemptions] = growth(from.agentSwitches->involuntary, to.agentSwitches->involuntary) / time;
    }
    out[Metric::SimulatorCpu] = load(from.simulatorCpu, to.simulatorCpu, time);
    out[Metric::RelayCpu] = load(from.relayCpu, to.relayCpu, time);
    if (from.missedSends && to.missedSends)
        out[Metric::MissedSends] = growth(*from.missedSends, *to.missedSends);
    out[Metric::AutopilotCpu] = load(from.autopilotCpu, to.autopilotCpu, time);
    double other = load(begin.machine.busy, end.machine.busy, time) - out[Metric::CpuProcess];
    for (const double own :
         {load(from.agentCpu, to.agentCpu, time), out[Metric::SimulatorCpu], out[Metric::RelayCpu], out[Metric::AutopilotCpu]})
        other -= std::isnan(own) ? 0 : own;
    out[Metric::OtherCpu] = std::isnan(other) ? other : std::max(0.0, other);
    out[Metric::Steal] = load(begin.machine.stolen, end.machine.stolen, time);
    if (begin.machine.megahertz && end.machine.megahertz) {
        const double mean = (*begin.machine.megahertz + *end.machine.megahertz) / 2;
        out[Metric::Frequency] = mean;
        out[Metric::FrequencyChange] = 100 * std::abs(*end.machine.megahertz - *begin.machine.megahertz) / mean;
    }
    out[Metric::LoadBegin] = begin.machine.load.value_or(std::numeric_limits<double>::quiet_NaN());
    out[Metric::LoadEnd] = end.machine.load.value_or(std::numeric_limits<double>::quiet_NaN());
    if (begin.machine.throttlings && end.machine.throttlings)
        out[Metric::Throttlings] = growth(*begin.machine.throttlings, *end.machine.throttlings)
            + (begin.machine.isThrottled || end.machine.isThrottled ? 1 : 0);
}

} // namespace

std::optional<AgentCostReport> agentCostReport(const engine::SessionSnapshot &session)
{
    if (!session.stats.peerCosts)
        return std::nullopt;
    return AgentCostReport{session.stats.peerStamp, *session.stats.peerCosts};
}

bool sequenceNumbersCountLoss(const impair::ImpairmentSettings &link, Load load)
{
    constexpr double kShortestFrame = 12, kBitsOfByte = 10, kStreams = 100; // frames a second, by far not reached
    if (load.isPaced())
        return (load.perSecond + kStreams) * seconds(link.jitter) <= metrics::SequenceTracker::kShortWindow;
    if (link.jitter <= Duration::zero() || load == Load::Natural)
        return true;
    // A saturated load fills the line: how many frames fit into the jitter?
    const double most = static_cast<double>(link.baud) / kBitsOfByte / kShortestFrame * seconds(link.jitter);
    return link.baud > 0 && most <= metrics::SequenceTracker::kShortWindow;
}

std::optional<double> lineRate(const impair::ImpairmentSettings &line)
{
    constexpr double kBitsOfByte = 10;
    return line.baud > 0 ? std::optional(static_cast<double>(line.baud) / kBitsOfByte) : std::nullopt;
}

/// The relay loses datagrams before the line, and makes duplicates behind it.
double lineLoad(const Reading &begin, const Reading &end, const impair::ImpairmentSettings &line)
{
    const auto received = [](const Reading &reading) {
        return trafficOf(*reading.station).rxBytes + reading.station->probe->waitingBytes;
    };
    const auto rate = lineRate(line);
    if (!rate)
        return std::numeric_limits<double>::quiet_NaN();
    const double carried = growth(received(begin), received(end)) / (1 + line.duplicate);
    return 100 * carried / (end.station->time - begin.station->time) / *rate;
}

Values valuesBetween(const Reading &begin, const Reading &end, bool sealed, bool countsLoss)
{
    Values out;
    const engine::Snapshot &before = *begin.station, &after = *end.station;
    const double time = after.time - before.time;
    const FrameCount counted = framesBetween(begin.mavlink, end.mavlink, sealed, countsLoss);
    const double frames = counted.distinct;
    const Traffic traffic = trafficOf(before), later = trafficOf(after);
    const double received = growth(traffic.rxBytes, later.rxBytes);
    const double mavlink = growth(begin.mavlink.bytes, end.mavlink.bytes);
    out[Metric::Packets] = frames;
    out[Metric::FrameRate] = frames / time;
    out[Metric::ByteRate] = mavlink / time;
    out[Metric::Loss] = share(counted.lost, frames);
    out[Metric::WireBytes] = received + growth(traffic.txBytes, later.txBytes);
    out[Metric::WireRate] = received / time;
    out[Metric::WirePerFrame] = (received + kHeaders * growth(traffic.rxDatagrams, later.rxDatagrams)) / frames;
    out[Metric::FramesPerDatagram] = frames / growth(traffic.rxDatagrams, later.rxDatagrams);
    out[Metric::Overhead] = 100 * (received / mavlink - 1);
    addCosts(out, *before.probe, *after.probe, time, frames, sealed);
    out[Metric::Readings] = growth(before.number, after.number);
    if (sealed)
        addChannel(out, begin, end);
    addLatency(out, before, after);
    addAgent(out, begin, end, sealed);
    addCircumstances(out, begin, end, time);
    if (begin.microjoules && end.microjoules)
        out[Metric::Power] = growth(*begin.microjoules, *end.microjoules) / 1e6 / time;
    return out;
}

std::map<std::uint32_t, std::uint64_t> messagesBetween(const Reading &begin, const Reading &end)
{
    std::map<std::uint32_t, std::uint64_t> out = end.station->probe->messages;
    for (const auto &[id, frames] : begin.station->probe->messages)
        out[id] -= std::min(frames, out[id]);
    std::erase_if(out, [](const auto &entry) { return entry.second == 0; });
    return out;
}

double foreignShare(const Reading &begin, const Reading &end)
{
    const double all = growth(begin.station->mavlink.frames, end.station->mavlink.frames);
    const double counted = growth(begin.mavlink.frames, end.mavlink.frames);
    return all > counted ? (all - counted) / all : 0;
}

Counted countedBy(const Reading &reading)
{
    const engine::MavlinkTotals &mavlink = reading.mavlink;
    return {
        {mavlink.frames, mavlink.lost, mavlink.late, mavlink.duplicate}, reading.rx, reading.peerRx, reading.programs.relay};
}

} // namespace skyseal::experiment
