// Builds the snapshot of a station from its parts. I/O thread.
#pragma once

#include "core/engine/common/link_pool.h"
#include "core/engine/station/fleet.h"
#include "core/engine/station/datagram_counters.h"
#include "core/engine/station/frame_gate.h"
#include "core/engine/station/metrics_sampler.h"
#include "core/engine/station/recorder.h"
#include "core/engine/common/totals.h"
#include "core/engine/station/station_channel.h"

#include <memory>
#include <string_view>

namespace skyseal::engine {

class Feed;
class Gateway;
struct Snapshot;

/// The parts that a snapshot describes; references are valid during the call.
struct SnapshotSources
{
    LinkPool &links;
    const StationChannel *channel; ///< null without keys
    const DatagramCounters &datagrams;
    const FrameGate &gate;
    const Fleet &fleet;
    const MetricsSampler &sampler;
    const Recorder *recorder;   ///< null when nothing is recorded
    Duration watchingCpu{};     ///< see Probe
    Gateway *gateway = nullptr; ///< null while no clients are served
    const Feed *feed = nullptr; ///< null while nothing is published
    Reason storageProblem = {}; ///< see Snapshot
};

MavlinkTotals mavlinkTotals(const SnapshotSources &from);
ChannelTotals channelTotals(const SnapshotSources &from);

/// The values of a point of the diagnostics. `anyHeard`: result of Fleet::sample().
MetricsSampler::Reading metricsReading(const SnapshotSources &from, TimePoint now, bool anyHeard);

/// The caller fills in the number and the time.
std::shared_ptr<Snapshot> buildSnapshot(const SnapshotSources &from, TimePoint now, bool withProbe);

} // namespace skyseal::engine
