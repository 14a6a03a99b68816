#include "core/engine/metrics_sampler.h"

namespace skyseal::engine {

void MetricsSampler::sample(TimePoint now, double time, const Reading &reading)
{
    if (m_number % 4 == 0) {
        m_cpu.sample(now, metrics::processCpuTime());
        m_memory.sample(metrics::residentBytes().value_or(0));
    }
    const ChannelTotals &channel = reading.channel;
    m_channelLoss.note(channel.rx.good, channel.rx.lost);
    m_peerLoss.note(channel.peerRx.good, channel.peerRx.lost);
    m_mavlinkLoss.note(reading.mavlink.frames, reading.mavlink.lost);
    m_frames.note(reading.mavlink.frames);
    m_bytes.note(channel.rx.openedBytes);

    MetricsSample one;
    one.number = ++m_number;
    one.time = time;
    one.suite = channel.suite;
    one.epoch = channel.epoch;
    one.linkUp = reading.linkUp;
    one.openedFramesPerSecond = static_cast<double>(m_frames.value());
    one.openedBytesPerSecond = static_cast<double>(m_bytes.value());
    one.mavlinkLossPercent = m_mavlinkLoss.percent();
    one.lossPercent = channel.up ? m_channelLoss.percent() : one.mavlinkLossPercent;
    one.peerLossPercent = channel.up ? m_peerLoss.percent() : 0;
    one.processCpuPercent = m_cpu.percent();
    one.suiteCpuPercent = channel.cost.cpuPercent;
    one.openNsP50 = channel.cost.openNsP50;
    one.openNsP99 = channel.cost.openNsP99;
    one.residentBytes = m_memory.bytes();
    m_samples.push_back(one);
    if (m_samples.size() > kKept)
        m_samples.pop_front();
}

} // namespace skyseal::engine
