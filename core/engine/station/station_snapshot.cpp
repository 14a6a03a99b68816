// The part of StationCore that describes it: everything that readers may know, copied into one value.
#include "core/engine/station/station_core.h"

#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"

namespace skyseal::engine {

MavlinkTotals StationCore::mavlinkTotals() const
{
    const metrics::SequenceCounts counts = m_sequences.total();
    return {counts.received,     counts.lost,           counts.late, counts.duplicate,
            m_links.badFrames(), m_sequences.evicted(), m_frameBytes};
}

ChannelTotals StationCore::channelTotals() const
{
    ChannelTotals out;
    if (m_channel)
        out = m_channel->totals();
    out.rx.malformed += m_garbage;
    out.rx.plaintextDropped = m_refusals.total;
    return out;
}

SessionSnapshot StationCore::describe(TimePoint now, const channel::SessionInfo &info) const
{
    SessionSnapshot out;
    out.info = info;
    if (const auto stats = m_channel->endpoint().stats(info.session))
        out.stats = *stats;
    out.cost = m_channel->cost(info.session);
    out.fingerprint = keys::fingerprint(info.peer);
    out.remoteAddress = link::toText(info.path.remote);
    out.age = seconds(now - info.since);
    if (const auto found = m_sessionWatches.find(info.session); found != m_sessionWatches.end()) {
        const SessionWatch &watch = found->second;
        out.forgedLastMinute = static_cast<std::uint64_t>(watch.forged.value());
        out.goodLastMinute = static_cast<std::uint64_t>(watch.good.value());
        out.replayedLastMinute = static_cast<std::uint64_t>(watch.replayed.value());
        out.lossPercent = watch.loss.percent();
        out.peerLossPercent = watch.peerLoss.percent();
    }
    return out;
}

VehicleSnapshot StationCore::describe(TimePoint now, const vehicle::Vehicle &vehicle) const
{
    VehicleSnapshot out;
    out.state = vehicle.state(now);
    const metrics::SequenceCounts counts = m_sequences.countsOfSystem(vehicle.systemId());
    out.state.sequence = {counts.received, counts.lost, counts.late, counts.duplicate};
    if (const auto found = m_vehicleWatches.find(vehicle.systemId()); found != m_vehicleWatches.end()) {
        const VehicleWatch &watch = found->second;
        out.link = watch.link;
        out.session = watch.session;
        if (watch.ended)
            out.ended = EndedSession{watch.ended->peerName, watch.ended->reason, seconds(now - watch.ended->at)};
        out.lossPercent = watch.loss.percent();
        out.framesPerSecond = static_cast<double>(watch.frames.value());
    }
    out.parameters = vehicle.parameters();
    out.parametersExpected = vehicle.parametersExpected();
    out.mission = vehicle.mission();
    return out;
}

std::shared_ptr<const Probe> StationCore::probe() const
{
    auto out = std::make_shared<Probe>();
    out->processCpu = metrics::processCpuTime();
    out->ioThreadCpu = metrics::threadCpuTime();
    out->residentBytes = metrics::residentBytes().value_or(0);
    out->waitingBytes = m_waitingBytes;
    out->waitingDatagrams = m_waitingDatagrams;
    if (m_channel) {
        out->open = m_channel->opening();
        out->seal = m_channel->sealing();
    }
    return out;
}

std::shared_ptr<Snapshot> StationCore::takeSnapshot(TimePoint now)
{
    auto out = std::make_shared<Snapshot>();
    out->number = ++m_snapshotNumber;
    out->time = seconds(now - m_start);
    out->links = m_links.snapshots(now);
    if (m_channel) {
        for (const channel::SessionId session : m_channel->endpoint().sessions()) {
            if (const auto info = m_channel->endpoint().sessionInfo(session))
                out->sessions.push_back(describe(now, *info));
        }
        out->unanswering = m_unanswering.all();
        out->unknownAgents = m_unknownAgents.all(now);
        // Nobody is to be heard any more: the next of their frames is taken or refused, and they wait for no person.
        if (const std::string mayBe = m_policy.neverHeard(); !mayBe.empty())
            out->pendingApproval = m_pendingVehicles.all(mayBe);
        out->unmatched = m_channel->endpoint().unmatched();
    }
    for (const auto &[systemId, vehicle] : m_vehicles.all())
        out->vehicles.push_back(describe(now, vehicle));
    out->samples.assign(m_sampler.samples().begin(), m_sampler.samples().end());
    out->inspector = m_inspector.rows(now);
    if (m_recorder)
        out->recording = m_recorder->snapshot();
    out->processCpuPercent = m_sampler.processCpuPercent();
    out->residentBytes = m_sampler.residentBytes();
    out->plaintextRefused = m_refusals.total + m_pendingVehicles.frames();
    out->spoofed = m_spoofed.total;
    out->mavlink = mavlinkTotals();
    out->channel = channelTotals();
    if (m_measuring)
        out->probe = probe();
    out->security = securityOf(*out);
    return out;
}

} // namespace skyseal::engine
