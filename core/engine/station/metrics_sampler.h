// Takes the readings of the diagnostics: traffic, loss and cost of the link four times a second, CPU and memory of the
// process once a second. I/O thread.
#pragma once

#include "core/engine/common/loss_meter.h"
#include "core/engine/station/snapshot.h"
#include "core/metrics/energy_meter.h"
#include "core/metrics/process_usage.h"

#include <deque>

namespace skyseal::engine {

class MetricsSampler
{
public:
    static constexpr Duration kEvery = std::chrono::milliseconds(250);
    /// Samples that a snapshot carries, so that a reader that was busy for up to 10 s misses none.
    static constexpr std::size_t kKept = 40;

    /// `powercap`: folder of the kernel's energy counters.
    explicit MetricsSampler(const std::string &powercap = metrics::EnergyMeter::kFolder) : m_energy(powercap) {}

    /// The engine's values at the time of a sample.
    struct Reading
    {
        ChannelTotals channel;
        MavlinkTotals mavlink;
        bool linkUp = false;
        double latency = vehicle::kUnknown;     ///< seconds
        std::uint64_t rxBytes = 0, txBytes = 0; ///< of all links so far
    };

    void sample(TimePoint now, double time, const Reading &reading);
    const std::deque<MetricsSample> &samples() const { return m_samples; }
    double processCpuPercent() const { return m_cpu.percent(); }
    std::uint64_t residentBytes() const { return m_memory.bytes(); }

private:
    void samplePower(TimePoint now);

    metrics::CpuSampler m_cpu, m_ioCpu;
    metrics::MemorySampler m_memory;
    std::uint64_t m_number = 0;
    metrics::EnergyMeter m_energy;
    std::optional<std::uint64_t> m_microjoules;
    TimePoint m_energyAt{};
    double m_watts = vehicle::kUnknown;
    LossMeter m_channelLoss, m_peerLoss, m_mavlinkLoss, m_peerMavlinkLoss;
    Growth<4> m_frames, m_bytes, m_clearBytes, m_rxBytes, m_txBytes;
    Growth<4> m_wireReceived, m_wireReceivedFrames, m_wireSent, m_wireSentFrames;
    Growth<4> m_good, m_replayed;
    std::uint64_t m_replayedBefore = 0;
    std::uint64_t m_attackingReplays = 0; ///< counted only while replays outnumber originals; a network also duplicates some
    std::deque<MetricsSample> m_samples;
};

} // namespace skyseal::engine
