#include "core/engine/station/station_snapshot.h"

#include "core/engine/gateway/gateway.h"
#include "core/engine/station/feed.h"
#include "core/engine/station/snapshot.h"
#include "core/metrics/process_usage.h"

namespace skyseal::engine {

namespace {

std::shared_ptr<const Probe> makeProbe(const SnapshotSources &from)
{
    auto out = std::make_shared<Probe>();
    out->processCpu = metrics::processCpuTime();
    out->ioThreadCpu = metrics::threadCpuTime();
    out->watchingCpu = from.watchingCpu;
    const metrics::ContextSwitches switches = metrics::threadSwitches();
    out->wakeUps = switches.voluntary;
    out->preemptions = switches.involuntary;
    out->residentBytes = metrics::residentBytes().value_or(0);
    out->waitingBytes = from.datagrams.waitingBytes;
    out->waitingDatagrams = from.datagrams.waitingCount;
    out->messages = from.fleet.messages().all();
    if (from.channel) {
        out->open = from.channel->driver.costs().opening();
        out->seal = from.channel->driver.costs().sealing();
    }
    return out;
}

} // namespace

MavlinkTotals mavlinkTotals(const SnapshotSources &from)
{
    MavlinkTotals out = from.fleet.totals();
    out.badCrc = from.links.badFrames();
    return out;
}

ChannelTotals channelTotals(const SnapshotSources &from)
{
    ChannelTotals out;
    if (from.channel)
        out = from.channel->driver.totals();
    out.rx.malformed += from.datagrams.garbage;
    out.rx.plaintextDropped = from.gate.refusals().plaintextFrames();
    return out;
}

MetricsSampler::Reading metricsReading(const SnapshotSources &from, TimePoint now, bool anyHeard)
{
    MetricsSampler::Reading out;
    out.channel = channelTotals(from);
    out.clear = from.fleet.clearTotals();
    out.linkUp = anyHeard;
    out.latency = from.fleet.latency(now);
    if (from.channel) {
        const channel::Endpoint &endpoint = from.channel->driver.endpoint();
        for (const channel::SessionId session : endpoint.sessions()) {
            const auto info = endpoint.sessionInfo(session);
            const auto stats = endpoint.stats(session);
            if (info && stats)
                out.sessions.push_back({session, info->suite, from.fleet.sealedTotals(session), *stats,
                                        from.channel->driver.costs().of(session).cpuPercent});
        }
    }
    from.links.forEach([&](const link::Link &link) {
        out.rxBytes += link.counters().rxBytes;
        out.txBytes += link.counters().txBytes;
    });
    out.watchingCpu = from.watchingCpu;
    return out;
}

std::shared_ptr<Snapshot> buildSnapshot(const SnapshotSources &from, TimePoint now, bool withProbe)
{
    auto out = std::make_shared<Snapshot>();
    if (withProbe)
        out->probe = makeProbe(from);
    out->links = from.links.snapshots(now);
    if (from.channel) {
        from.channel->describe(now, *out);
        for (SessionSnapshot &session : out->sessions)
            session.mavlink = from.fleet.sealedTotals(session.info.session);
        // Once every known agent was heard, the next clear frame is accepted or refused without asking the operator.
        if (const std::string mayBe = from.gate.policy().neverHeard(); !mayBe.empty())
            out->pendingApproval = from.gate.pending().all(mayBe);
    }
    for (const auto &[systemId, vehicle] : from.fleet.vehicles().all())
        out->vehicles.push_back(from.fleet.describe(now, vehicle));
    out->samples.assign(from.sampler.samples().begin(), from.sampler.samples().end());
    out->inspector = from.fleet.inspector().rows(now);
    out->fields = from.fleet.fields().readings(now);
    if (from.recorder)
        out->recording = from.recorder->snapshot();
    if (from.gateway) {
        out->served = from.gateway->links(now);
        out->clients = from.gateway->clients();
    }
    if (from.feed)
        out->broker = from.feed->status();
    out->storageProblem = from.storageProblem;
    out->processCpuPercent = from.sampler.processCpuPercent();
    out->residentBytes = from.sampler.residentBytes();
    out->plaintextRefused = from.gate.refusals().plaintextFrames() + from.gate.pending().frames();
    out->spoofed = from.gate.refusals().systemFrames();
    out->otherSystems = from.gate.otherSystems().all();
    out->unreadable = from.datagrams.unreadable;
    out->mavlink = mavlinkTotals(from);
    out->clear = from.fleet.clearTotals();
    out->channel = channelTotals(from);
    out->security = securityOf(*out);
    return out;
}

} // namespace skyseal::engine
