// Makes the points of the diagnostics' time lines: rates, loss and cost of the link four times a second, CPU, memory and power
// of the process once a second. Each meter converts counters into one kind of figure; the sampler feeds them. I/O thread.
#pragma once

#include "core/engine/common/loss_meter.h"
#include "core/engine/station/overhead_meter.h"
#include "core/engine/station/process_meter.h"
#include "core/engine/station/replay_meter.h"
#include "core/engine/station/metrics_sample.h"
#include "core/engine/common/totals.h"

#include <deque>

namespace skyseal::engine {

class MetricsSampler
{
public:
    static constexpr Duration kEvery = std::chrono::milliseconds(250);
    /// Samples that a snapshot carries, so that a reader that was busy for up to 10 s misses none.
    static constexpr std::size_t kKept = 40;

    /// `sysfs`: see metrics::EnergyMeter.
    explicit MetricsSampler(const std::string &sysfs = metrics::EnergyMeter::kSysfs) : m_process(sysfs) {}

    /// The engine's values at the time of a sample.
    struct Reading
    {
        ChannelTotals channel;
        MavlinkTotals mavlink;
        bool linkUp = false;
        double latency = vehicle::kUnknown;     ///< seconds
        std::uint64_t rxBytes = 0, txBytes = 0; ///< of all links so far
        Duration watchingCpu{};                 ///< see Probe
    };

    /// Appends a sample. Call every kEvery; `time` is seconds since the station started.
    void sample(TimePoint now, double time, const Reading &reading);
    /// The newest kKept samples, oldest first.
    const std::deque<MetricsSample> &samples() const { return m_samples; }
    double processCpuPercent() const { return m_process.cpuPercent(); }
    std::uint64_t residentBytes() const { return m_process.residentBytes(); }

private:
    void note(const Reading &reading);
    void setTraffic(MetricsSample &sample, const Reading &reading) const;
    void setLosses(MetricsSample &sample, const Reading &reading) const;
    void setCosts(MetricsSample &sample, const SuiteCost &cost) const;

    ProcessMeter m_process;
    LossMeter m_channelLoss, m_peerLoss, m_mavlinkLoss, m_peerMavlinkLoss;
    Growth<4> m_frames, m_openedBytes, m_clearBytes, m_rxBytes, m_txBytes;
    OverheadMeter m_rxOverhead, m_txOverhead;
    ReplayMeter m_replays;
    std::uint64_t m_number = 0;
    std::deque<MetricsSample> m_samples;
};

} // namespace skyseal::engine
