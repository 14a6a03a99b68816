// The state of a station for windows and reports, as one immutable value that is built on the I/O thread: a reader never sees
// a mixture of two moments, and no packet crosses the threads.
#pragma once

#include "core/base/path.h"
#include "core/channel/events.h"
#include "core/channel/session_info.h"
#include "core/engine/station/probe.h"
#include "core/engine/station/unanswering_agent.h"
#include "core/engine/common/link_snapshot.h"
#include "core/engine/common/totals.h"
#include "core/vehicle/mission.h"
#include "core/vehicle/parameter.h"
#include "core/vehicle/vehicle_state.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

/// The security state that the operator must see at a glance.
enum class Security : std::uint8_t {
    Nothing, ///< no vehicle and no session
    Plain,   ///< clear MAVLink: "not sealed"
    Sealed,
    Switching,  ///< sealed, and a switch of suites is in progress
    UnderAttack ///< sealed, and records are forged or replayed; see isAttacked()
};

struct SessionSnapshot
{
    channel::SessionInfo info;
    channel::SessionStats stats;
    SuiteCost cost;
    std::string fingerprint; ///< of the peer's key
    std::string remoteAddress;
    double age = 0; ///< seconds since the session is up
    std::uint64_t forgedLastMinute = 0, replayedLastMinute = 0, goodLastMinute = 0;
    double lossPercent = 0;     ///< from the peer, over the last second
    double peerLossPercent = 0; ///< to the peer, over the last second
};

/// Whether the records that were refused within the last minute show an attacker. A wrong tag does: transmission errors are
/// caught by lower checksums. A repeated record alone does not: networks duplicate datagrams, and a copy looks the same
/// in both cases. But a network does not make more copies than there were records, so more than that are replays. Slower
/// replays are refused and counted all the same.
inline bool isAttacked(const SessionSnapshot &session)
{
    return session.forgedLastMinute > 0 || session.replayedLastMinute > session.goodLastMinute;
}

/// The ended session over which a vehicle was heard.
struct EndedSession
{
    std::string peerName;
    channel::DownReason reason{};
    double age = 0; ///< seconds since it ended
};

struct VehicleSnapshot
{
    vehicle::VehicleState state;
    LinkId link{};
    std::optional<channel::SessionId> session; ///< over which it was heard last, even if that ended; nullopt: plain
    std::optional<EndedSession> ended;         ///< set if that session ended and its peer has no other
    double lossPercent = 0;                    ///< by MAVLink sequence numbers, over the last second
    double framesPerSecond = 0;
    std::shared_ptr<const std::vector<vehicle::Parameter>> parameters; ///< null until requested; shared while unchanged
    std::uint32_t parametersExpected = 0;
    std::shared_ptr<const std::vector<vehicle::MissionItem>> mission; ///< as last read from the vehicle
};

/// One row of the inspector: a kind of message of one sender. Filled only while an inspector is open.
struct InspectorRow
{
    std::uint32_t messageId = 0;
    std::string name;
    std::uint8_t systemId = 0, componentId = 0;
    std::uint64_t count = 0;
    double rate = 0; ///< a second
    std::uint8_t version = 2;
    bool isSigned = false;
    std::uint8_t payloadSize = 0;
    std::array<std::uint8_t, 255> payload{}; ///< of the newest one, zero-filled
    double age = 0;                          ///< seconds
};

/// One point of the diagnostics' time lines, four a second.
struct MetricsSample
{
    std::uint64_t number = 0; ///< rises by one per sample
    double time = 0;          ///< seconds since the station started
    crypto::SuiteId suite{};  ///< None = plain
    std::uint32_t epoch = 0;
    bool linkUp = false;
    double openedFramesPerSecond = 0;
    double openedBytesPerSecond = 0;
    double lossPercent = 0;     ///< channel, from the peer; MAVLink's where plain
    double peerLossPercent = 0; ///< channel, to the peer
    double mavlinkLossPercent = 0;
    double peerMavlinkLossPercent = vehicle::kUnknown; ///< to the vehicle, as its agent reports once a second
    double processCpuPercent = 0;                      ///< of one core, all threads; over the last second
    double ioCpuPercent = 0;                           ///< of the thread that receives, opens, parses and sends
    double suiteCpuPercent = 0;                        ///< of one core, in seal and open
    double openNsP50 = 0, openNsP99 = 0;               ///< see SuiteCost
    double openNextNsP50 = 0, openNextNsP99 = 0;
    double sealNsP50 = 0, sealNsP99 = 0;
    double latency = vehicle::kUnknown;           ///< seconds there and back by TIMESYNC, of the vehicle heard last
    double roundTrip = vehicle::kUnknown;         ///< seconds, of the channel's own reports
    double rxOverheadPercent = vehicle::kUnknown; ///< datagram bytes beyond the frames in them, over the last second
    double txOverheadPercent = vehicle::kUnknown;
    double rxBytesPerSecond = 0, txBytesPerSecond = 0; ///< all links, datagrams as they are
    std::uint64_t residentBytes = 0;
    double sessionBytes = vehicle::kUnknown; ///< heap of a session under this suite; filled in by the reader
    double powerWatts = vehicle::kUnknown;   ///< of the whole processor, by the kernel's counters; over the last second
    /// Signs of an attack so far: forged records, refused clear frames, and replays while they outnumber good records.
    std::uint64_t refused = 0;
};

struct RecordingSnapshot
{
    bool active = false;
    std::string file;
    std::uint64_t bytes = 0, frames = 0, dropped = 0;
    std::string problem;
};

/// An agent announces itself with a key that is not among the known peers. The announcement does not contain the key.
struct UnknownAgent
{
    std::string remoteAddress;
};

/// A vehicle in clear that is neither shown nor sent to before the operator allows it; see
/// Station::allowPlaintext().
struct PendingVehicle
{
    std::uint8_t systemId = 0;
    std::string remoteAddress;
    std::string mayBe; ///< names of the known agents, never heard sealed, that it may impersonate
};

struct Snapshot
{
    std::uint64_t number = 0;
    double time = 0; ///< seconds since the station started
    Security security{};
    std::vector<LinkSnapshot> links;
    std::vector<SessionSnapshot> sessions;
    std::vector<VehicleSnapshot> vehicles;
    std::vector<UnansweringAgent> unanswering;
    std::vector<UnknownAgent> unknownAgents;
    std::vector<PendingVehicle> pendingApproval;
    channel::ReceiveCounters unmatched;
    std::vector<MetricsSample> samples; ///< the newest ones; use those with a number not seen before
    std::vector<InspectorRow> inspector;
    RecordingSnapshot recording;
    std::string storageProblem; ///< why this station's counters of handshakes are not stored; empty if they are
    double processCpuPercent = 0;
    std::uint64_t residentBytes = 0;
    std::uint64_t plaintextRefused = 0; ///< clear frames, including those of vehicles that await approval; see SenderPolicy
    std::uint64_t spoofed = 0;          ///< sealed frames with a system id that their peer may not use
    std::uint64_t eventsDropped = 0;    ///< events that a reader which hung did not receive, see OutputQueue
    MavlinkTotals mavlink;              ///< since the start, all links
    ChannelTotals channel;              ///< since the start, including ended sessions
    std::shared_ptr<const Probe> probe; ///< null unless a measurement is in progress
};

/// Derives the security state from the sessions and vehicles of a snapshot.
Security securityOf(const Snapshot &snapshot);

} // namespace skyseal::engine
