#include "core/engine/station/metrics_sampler.h"

#include <algorithm>

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
    sample.rxBytesPerSecond = static_cast<double>(m_rxBytes.value());
    sample.txBytesPerSecond = static_cast<double>(m_txBytes.value());
    setCosts(sample, channel.cost);
    if (channel.up)
        setSealed(sample);
    else
        setPlain(sample);
    sample.refused = channel.rx.forged + m_replays.attacking() + channel.rx.plaintextDropped;
    m_samples.push_back(sample);
    if (m_samples.size() > kKept)
        m_samples.pop_front();
}

void MetricsSampler::Traffic::note(const MavlinkTotals &totals, std::uint64_t openedBytes)
{
    frames.note(totals.frames);
    bytes.note(openedBytes);
    mavlink.note(totals.frames - totals.duplicate, totals.lost);
}

void MetricsSampler::SessionTraffic::note(const Session &reading)
{
    const channel::SessionStats &stats = reading.stats;
    Traffic::note(reading.mavlink, stats.rx.openedBytes);
    suite = reading.suite;
    cpuPercent = reading.cpuPercent;
    records.note(stats.rx.good, stats.rx.lost);
    peerRecords.note(stats.peerRx.good, stats.peerRx.lost);
    reportsMavlink = stats.peerFrames.has_value();
    if (reportsMavlink)
        peerMavlink.note(stats.peerFrames->taken, stats.peerFrames->lost);
}

void MetricsSampler::note(const Reading &reading)
{
    const ChannelTotals &channel = reading.channel;
    std::erase_if(m_sessions, [&](const auto &known) {
        return std::ranges::find(reading.sessions, known.first, &Session::id) == reading.sessions.end();
    });
    for (const Session &session : reading.sessions)
        m_sessions[session.id].note(session);
    m_clear.note(reading.clear, reading.clear.bytes);
    m_rxBytes.note(reading.rxBytes);
    m_txBytes.note(reading.txBytes);
    m_rxOverhead.note(channel.wire.received, channel.wire.receivedFrames);
    m_txOverhead.note(channel.wire.sent, channel.wire.sentFrames);
    m_replays.note(channel.rx.good, channel.rx.replayed);
}

/// Clear frames needed no opening.
void MetricsSampler::setPlain(MetricsSample &sample) const
{
    sample.openedFramesPerSecond = static_cast<double>(m_clear.frames.value());
    sample.openedBytesPerSecond = static_cast<double>(m_clear.bytes.value());
    sample.mavlinkLossPercent = sample.lossPercent = m_clear.mavlink.share().percent();
    sample.rxOverheadPercent = sample.txOverheadPercent = 0;
}

void MetricsSampler::setSealed(MetricsSample &sample) const
{
    LossShare mavlink, records, peerRecords, peerMavlink;
    bool reportsMavlink = false;
    for (const auto &[id, session] : m_sessions) {
        if (session.suite != sample.suite)
            continue;
        sample.openedFramesPerSecond += static_cast<double>(session.frames.value());
        sample.openedBytesPerSecond += static_cast<double>(session.bytes.value());
        sample.suiteCpuPercent += session.cpuPercent;
        mavlink += session.mavlink.share();
        records += session.records.share();
        peerRecords += session.peerRecords.share();
        if (session.reportsMavlink)
            peerMavlink += session.peerMavlink.share();
        reportsMavlink = reportsMavlink || session.reportsMavlink;
    }
    sample.mavlinkLossPercent = mavlink.percent();
    sample.lossPercent = records.percent();
    sample.peerLossPercent = peerRecords.percent();
    if (reportsMavlink)
        sample.peerMavlinkLossPercent = peerMavlink.percent();
    sample.rxOverheadPercent = m_rxOverhead.percent().value_or(vehicle::kUnknown);
    sample.txOverheadPercent = m_txOverhead.percent().value_or(vehicle::kUnknown);
}

void MetricsSampler::setCosts(MetricsSample &sample, const SuiteCost &cost) const
{
    sample.processCpuPercent = m_process.cpuPercent();
    sample.ioCpuPercent = m_process.ioCpuPercent();
    sample.watchingCpuPercent = m_process.watchingCpuPercent();
    sample.residentBytes = m_process.residentBytes();
    sample.powerWatts = m_process.watts().value_or(vehicle::kUnknown);
    sample.openNsP50 = cost.openNsP50;
    sample.openNsP99 = cost.openNsP99;
    sample.openNextNsP50 = cost.openNextNsP50;
    sample.openNextNsP99 = cost.openNextNsP99;
    sample.sealNsP50 = cost.sealNsP50;
    sample.sealNsP99 = cost.sealNsP99;
}

} // namespace skyseal::engine
