// All that a window or a report may know, as values, taken on the I/O thread and handed over whole: the reader never
// sees a half of one moment and a half of another, and no packet crosses the threads.
#pragma once

#include "core/base/path.h"
#include "core/channel/events.h"
#include "core/channel/session_info.h"
#include "core/engine/station/probe.h"
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

/// What the operator must see at one glance.
enum class Security : std::uint8_t {
    Nothing, ///< nobody there
    Plain,   ///< clear MAVLink: "not sealed"
    Sealed,
    Switching,  ///< sealed, another suite is being agreed
    UnderAttack ///< sealed, and somebody forges or replays records; see isAttacked()
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
    double lossPercent = 0;     ///< to us, over the last second
    double peerLossPercent = 0; ///< to the peer, over the last second
};

/// Whether what was refused within the last minute is the work of an attacker. A wrong tag is: damage on the way is caught
/// by checksums below us. A record that came before is not by itself: networks deliver datagrams twice, and a copy looks
/// the same whoever made it. But a network does not make more copies than there were records, so beyond that somebody
/// replays. Slower replays are refused and counted all the same.
inline bool isAttacked(const SessionSnapshot &session)
{
    return session.forgedLastMinute > 0 || session.replayedLastMinute > session.goodLastMinute;
}

/// The session over which a vehicle was heard, and that is not there any more.
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
    std::optional<channel::SessionId> session; ///< over which it was heard last, also when that ended since; empty: plain
    std::optional<EndedSession> ended;         ///< that session, unless it is up or another one with the same peer is
    double lossPercent = 0;                    ///< by MAVLink sequence numbers, over the last second
    double framesPerSecond = 0;
    std::shared_ptr<const std::vector<vehicle::Parameter>> parameters; ///< null until asked for; shared while unchanged
    std::uint32_t parametersExpected = 0;
    std::shared_ptr<const std::vector<vehicle::MissionItem>> mission; ///< as last read from the vehicle
};

/// One row of the inspector: a kind of message of one sender. Filled only while an inspector is watching.
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
    double lossPercent = 0;     ///< channel, to us; MAVLink's where plain
    double peerLossPercent = 0; ///< channel, to the peer
    double mavlinkLossPercent = 0;
    double peerMavlinkLossPercent = vehicle::kUnknown; ///< to the vehicle, as its agent counts and tells once a second
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
    double sessionBytes = vehicle::kUnknown; ///< heap of a session under this suite; for whoever shows samples to fill in
    double powerWatts = vehicle::kUnknown;   ///< of the whole processor, by the kernel's counters; over the last second
    /// Signs of an attack so far: forged records, clear frames, and replayed ones where they outnumber the good.
    std::uint64_t refused = 0;
};

struct RecordingSnapshot
{
    bool active = false;
    std::string file;
    std::uint64_t bytes = 0, frames = 0, dropped = 0;
    std::string problem;
};

/// A known agent that is there, as its announcements show, and answers none of our handshakes.
struct UnansweringAgent
{
    std::string peerName;
    std::string remoteAddress;
    std::string ownFingerprint; ///< of this station's key, which the agent has to know
    double seconds = 0;         ///< since the first message that it did not answer
};

/// Something announces itself as an agent, with a key that is not among the known peers. Its key is not shown by that.
struct UnknownAgent
{
    std::string remoteAddress;
};

/// A vehicle in clear of which nothing is shown, and to which nothing is sent, before a person allows it; see
/// Station::allowPlaintext().
struct PendingVehicle
{
    std::uint8_t systemId = 0;
    std::string remoteAddress;
    std::string mayBe; ///< names of the known agents that were never heard sealed: it may pretend to be theirs
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
    std::vector<MetricsSample> samples; ///< the last few; take those with a number not seen yet
    std::vector<InspectorRow> inspector;
    RecordingSnapshot recording;
    double processCpuPercent = 0;
    std::uint64_t residentBytes = 0;
    std::uint64_t plaintextRefused = 0; ///< clear frames that were not taken, see SenderPolicy; held-back ones included
    std::uint64_t spoofed = 0;          ///< sealed frames that spoke as a system which their peer may not speak as
    std::uint64_t eventsDropped = 0;    ///< events that a reader which hung did not receive, see OutputQueue
    MavlinkTotals mavlink;              ///< since the start, all links
    ChannelTotals channel;              ///< since the start, ended sessions included
    std::shared_ptr<const Probe> probe; ///< null unless the station is being measured
};

/// The one word for the lock: of what the sessions and vehicles of a snapshot show.
Security securityOf(const Snapshot &snapshot);

} // namespace skyseal::engine
