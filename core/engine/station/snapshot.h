// The state of a station for windows and reports, as one immutable value that is built on the I/O thread: a reader never sees
// a mixture of two moments, and no packet crosses the threads.
#pragma once

#include "core/channel/session_info.h"
#include "core/engine/common/link_snapshot.h"
#include "core/engine/common/totals.h"
#include "core/engine/gateway/client_snapshot.h"
#include "core/engine/station/field_reading.h"
#include "core/engine/station/inspector_row.h"
#include "core/engine/station/metrics_sample.h"
#include "core/engine/station/other_systems_heard.h"
#include "core/engine/station/probe.h"
#include "core/engine/station/recording_snapshot.h"
#include "core/engine/station/replay_status.h"
#include "core/engine/station/security.h"
#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/unanswering_agent.h"
#include "core/engine/station/unknown_agent.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/mqtt/publisher_status.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

struct Snapshot
{
    std::uint64_t number = 0;
    double time = 0; ///< seconds since the station started
    Security security{};
    std::vector<LinkSnapshot> links;
    std::vector<LinkSnapshot> served; ///< links on which the gateway serves clients
    std::vector<ClientSnapshot> clients;
    std::optional<mqtt::PublisherStatus> broker; ///< set if the station publishes to a broker
    std::vector<SessionSnapshot> sessions;
    std::vector<VehicleSnapshot> vehicles;
    std::vector<UnansweringAgent> unanswering;
    std::vector<UnknownAgent> unknownAgents;
    std::vector<PendingVehicle> pendingApproval;
    channel::ReceiveCounters unmatched;
    std::vector<MetricsSample> samples; ///< the newest ones; a reader uses those with new numbers
    std::vector<InspectorRow> inspector;
    RecordingSnapshot recording;
    Reason storageProblem; ///< reason why this station's counters of handshakes are not stored; empty if they are
    double processCpuPercent = 0;
    std::uint64_t residentBytes = 0;
    std::uint64_t plaintextRefused = 0; ///< clear frames, including those of vehicles that await approval; see SenderPolicy
    std::uint64_t spoofed = 0;          ///< sealed frames with a system id that their peer may not use
    std::vector<OtherSystemsHeard> otherSystems; ///< behind agents, and of no peer
    std::uint64_t unreadable = 0;                ///< frames that Station::setBareCipher() did not decrypt
    std::uint64_t eventsDropped = 0;             ///< events that a hung reader did not receive, see OutputQueue
    MavlinkTotals mavlink;                       ///< since the start, all links
    MavlinkTotals clear;                         ///< of `mavlink`, what arrived in clear
    ChannelTotals channel;                       ///< since the start, including ended sessions
    std::optional<ReplayStatus> replay;          ///< set if this is the picture of a replay
    std::shared_ptr<const Probe> probe;          ///< null unless it was requested, see Station::requestProbe()
    std::vector<FieldReading> fields;            ///< only those chosen by Station::chooseFields()
};

} // namespace skyseal::engine
