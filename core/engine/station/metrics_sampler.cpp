#include "core/engine/station/metrics_sampler.h"

#include <utility>

namespace skyseal::engine {

namespace {

double overheadPercent(const Growth<4> &wire, const Growth<4> &frames)
{
    const auto carried = static_cast<double>(frames.value());
    return carried > 0 ? 100 * (static_cast<double>(wire.value()) / carried - 1) : vehicle::kUnknown;
}

} // namespace

void MetricsSampler::samplePower(TimePoint now)
{
    const auto before = std::exchange(m_microjoules, m_energy.microjoules());
    const double passed = seconds(now - std::exchange(m_energyAt, now));
    m_watts = before && m_microjoules && passed > 0 ? static_cast<double>(*m_microjoules - *before) / 1e6 / passed
                                                    : vehicle::kUnknown;
}

void MetricsSampler::sample(TimePoint now, double time, const Reading &reading)
{
    if (m_number % 4 == 0) {
        m_cpu.sample(now, metrics::processCpuTime());
        m_ioCpu.sample(now, metrics::threadCpuTime());
        m_memory.sample(metrics::residentBytes().value_or(0));
        samplePower(now);
    }
    const ChannelTotals &channel = reading.channel;
    m_channelLoss.note(channel.rx.good, channel.rx.lost);
    m_peerLoss.note(channel.peerRx.good, channel.peerRx.lost);
    m_mavlinkLoss.note(reading.mavlink.frames - reading.mavlink.duplicate, reading.mavlink.lost);
    if (channel.peerFrames)
        m_peerMavlinkLoss.note(channel.peerFrames->taken, channel.peerFrames->lost);
    m_frames.note(reading.mavlink.frames);
    m_bytes.note(channel.rx.openedBytes);
    m_clearBytes.note(reading.mavlink.bytes);
    m_good.note(channel.rx.good);
    m_replayed.note(channel.rx.replayed);
    if (m_replayed.value() > m_good.value())
        m_attackingReplays += channel.rx.replayed - m_replayedBefore;
    m_replayedBefore = channel.rx.replayed;
    m_rxBytes.note(reading.rxBytes);
    m_txBytes.note(reading.txBytes);
    m_wireReceived.note(channel.wire.received);
    m_wireReceivedFrames.note(channel.wire.receivedFrames);
    m_wireSent.note(channel.wire.sent);
    m_wireSentFrames.note(channel.wire.sentFrames);

    MetricsSample one;
    one.number = ++m_number;
    one.time = time;
    one.suite = channel.suite;
    one.epoch = channel.epoch;
    one.linkUp = reading.linkUp;
    one.openedFramesPerSecond = static_cast<double>(m_frames.value());
    one.rxBytesPerSecond = static_cast<double>(m_rxBytes.value());
    one.txBytesPerSecond = static_cast<double>(m_txBytes.value());
    // Clear frames needed no opening.
    one.openedBytesPerSecond = static_cast<double>(channel.up ? m_bytes.value() : m_clearBytes.value());
    one.rxOverheadPercent = channel.up ? overheadPercent(m_wireReceived, m_wireReceivedFrames) : 0;
    one.txOverheadPercent = channel.up ? overheadPercent(m_wireSent, m_wireSentFrames) : 0;
    one.latency = reading.latency;
    if (channel.up && channel.roundTrip > Duration::zero())
        one.roundTrip = seconds(channel.roundTrip);
    one.mavlinkLossPercent = m_mavlinkLoss.percent();
    one.lossPercent = channel.up ? m_channelLoss.percent() : one.mavlinkLossPercent;
    one.peerLossPercent = channel.up ? m_peerLoss.percent() : 0;
    if (channel.up && channel.peerFrames)
        one.peerMavlinkLossPercent = m_peerMavlinkLoss.percent();
    one.powerWatts = m_watts;
    one.processCpuPercent = m_cpu.percent();
    one.ioCpuPercent = m_ioCpu.percent();
    one.suiteCpuPercent = channel.cost.cpuPercent;
    one.openNsP50 = channel.cost.openNsP50;
    one.openNsP99 = channel.cost.openNsP99;
    one.openNextNsP50 = channel.cost.openNextNsP50;
    one.openNextNsP99 = channel.cost.openNextNsP99;
    one.sealNsP50 = channel.cost.sealNsP50;
    one.sealNsP99 = channel.cost.sealNsP99;
    one.refused = channel.rx.forged + m_attackingReplays + channel.rx.plaintextDropped;
    one.residentBytes = m_memory.bytes();
    m_samples.push_back(one);
    if (m_samples.size() > kKept)
        m_samples.pop_front();
}

} // namespace skyseal::engine
