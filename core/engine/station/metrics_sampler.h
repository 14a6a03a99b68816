// Makes the points of the diagnostics' time lines: rates, loss and cost of the link four times a second, CPU, memory and power
// of the process once a second. Each meter converts counters into one kind of figure; the sampler feeds them. I/O thread.
//
// Rates, losses and the CPU of a suite are those of the sessions under it alone: it did not open frames that arrived in clear
// or under another suite.
#pragma once

#include "core/engine/common/loss_meter.h"
#include "core/engine/station/overhead_meter.h"
#include "core/engine/station/process_meter.h"
#include "core/engine/station/replay_meter.h"
#include "core/engine/station/metrics_sample.h"
#include "core/engine/common/totals.h"

#include <deque>
#include <map>
#include <vector>

namespace skyseal::engine {

class MetricsSampler
{
public:
    static constexpr Duration kEvery = std::chrono::milliseconds(250);
    /// Samples that a snapshot carries, so that a reader that was busy for up to 10 s misses none.
    static constexpr std::size_t kKept = 40;

    /// `sysfs`: see metrics::EnergyMeter.
    explicit MetricsSampler(const std::string &sysfs = metrics::EnergyMeter::kSysfs) : m_process(sysfs) {}

    struct Session
    {
        channel::SessionId id{};
        crypto::SuiteId suite{};
        MavlinkTotals mavlink; ///< see SessionSnapshot
        channel::SessionStats stats;
        double cpuPercent = 0; ///< see SuiteCost
    };

    /// The engine's values at the time of a sample.
    struct Reading
    {
        ChannelTotals channel;
        MavlinkTotals clear; ///< frames that arrived in clear
        std::vector<Session> sessions;
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
    /// The growth over the last second of what arrived in one session, or in clear.
    struct Traffic
    {
        void note(const MavlinkTotals &mavlink, std::uint64_t openedBytes);

        Growth<4> frames, bytes;
        LossMeter mavlink;
    };
    struct SessionTraffic : Traffic
    {
        void note(const Session &reading);

        crypto::SuiteId suite{};
        double cpuPercent = 0;
        LossMeter records, peerRecords, peerMavlink;
        bool reportsMavlink = false; ///< its agent counts our frames
    };

    void note(const Reading &reading);
    void setPlain(MetricsSample &sample) const;
    void setSealed(MetricsSample &sample) const;
    void setCosts(MetricsSample &sample, const SuiteCost &cost) const;

    ProcessMeter m_process;
    Traffic m_clear;
    std::map<channel::SessionId, SessionTraffic> m_sessions;
    Growth<4> m_rxBytes, m_txBytes;
    OverheadMeter m_rxOverhead, m_txOverhead;
    ReplayMeter m_replays;
    std::uint64_t m_number = 0;
    std::deque<MetricsSample> m_samples;
};

} // namespace skyseal::engine
