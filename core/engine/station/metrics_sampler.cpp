#include "core/engine/station/metrics_sampler.h"

namespace skyseal::engine {

void MetricsSampler::sample(TimePoint now, double time, const Reading &reading)
{
    constexpr std::uint64_t kPerSecond = 4;
    if (m_number % kPerSecond == 0)
        m_process.sample(now, reading.watchingCpu);
    note(reading);

    const ChannelTotals &channel = reading.channel;
    MetricsSample sample;
    sample.number = ++m_number;
    sample.time = time;
    sample.suite = channel.suite;
    sample.epoch = channel.epoch;
    sample.linkUp = reading.linkUp;
    sample.latency = reading.latency;
    if (channel.up && channel.roundTrip > Duration::zero())
        sample.roundTrip = seconds(channel.roundTrip);
    setTraffic(sample, reading);
    setLosses(sample, reading);
    setCosts(sample, channel.cost);
    sample.refused = channel.rx.forged + m_replays.attacking() + channel.rx.plaintextDropped;
    m_samples.push_back(sample);
    if (m_samples.size() > kKept)
        m_samples.pop_front();
}

void MetricsSampler::note(const Reading &reading)
{
    const ChannelTotals &channel = reading.channel;
    m_channelLoss.note(channel.rx.good, channel.rx.lost);
    m_peerLoss.note(channel.peerRx.good, channel.peerRx.lost);
    m_mavlinkLoss.note(reading.mavlink.frames - reading.mavlink.duplicate, reading.mavlink.lost);
    if (channel.peerFrames)
        m_peerMavlinkLoss.note(channel.peerFrames->taken, channel.peerFrames->lost);
    m_frames.note(reading.mavlink.frames);
    m_openedBytes.note(channel.rx.openedBytes);
    m_clearBytes.note(reading.mavlink.bytes);
    m_rxBytes.note(reading.rxBytes);
    m_txBytes.note(reading.txBytes);
    m_rxOverhead.note(channel.wire.received, channel.wire.receivedFrames);
    m_txOverhead.note(channel.wire.sent, channel.wire.sentFrames);
    m_replays.note(channel.rx.good, channel.rx.replayed);
}

void MetricsSampler::setTraffic(MetricsSample &sample, const Reading &reading) const
{
    const bool up = reading.channel.up;
    sample.openedFramesPerSecond = static_cast<double>(m_frames.value());
    sample.rxBytesPerSecond = static_cast<double>(m_rxBytes.value());
    sample.txBytesPerSecond = static_cast<double>(m_txBytes.value());
    // Clear frames needed no opening.
    sample.openedBytesPerSecond = static_cast<double>(up ? m_openedBytes.value() : m_clearBytes.value());
    sample.rxOverheadPercent = up ? m_rxOverhead.percent().value_or(vehicle::kUnknown) : 0;
    sample.txOverheadPercent = up ? m_txOverhead.percent().value_or(vehicle::kUnknown) : 0;
}

void MetricsSampler::setLosses(MetricsSample &sample, const Reading &reading) const
{
    const ChannelTotals &channel = reading.channel;
    sample.mavlinkLossPercent = m_mavlinkLoss.percent();
    sample.lossPercent = channel.up ? m_channelLoss.percent() : sample.mavlinkLossPercent;
    sample.peerLossPercent = channel.up ? m_peerLoss.percent() : 0;
    if (channel.up && channel.peerFrames)
        sample.peerMavlinkLossPercent = m_peerMavlinkLoss.percent();
}

void MetricsSampler::setCosts(MetricsSample &sample, const SuiteCost &cost) const
{
    sample.processCpuPercent = m_process.cpuPercent();
    sample.ioCpuPercent = m_process.ioCpuPercent();
    sample.watchingCpuPercent = m_process.watchingCpuPercent();
    sample.residentBytes = m_process.residentBytes();
    sample.powerWatts = m_process.watts().value_or(vehicle::kUnknown);
    sample.suiteCpuPercent = cost.cpuPercent;
    sample.openNsP50 = cost.openNsP50;
    sample.openNsP99 = cost.openNsP99;
    sample.openNextNsP50 = cost.openNextNsP50;
    sample.openNextNsP99 = cost.openNextNsP99;
    sample.sealNsP50 = cost.sealNsP50;
    sample.sealNsP99 = cost.sealNsP99;
}

} // namespace skyseal::engine
