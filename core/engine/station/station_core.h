// The station's engine: joins links, secure channel, vehicles, recording and counters. Lives whole on the I/O thread; other
// threads reach it only through Station, which posts calls and hands out what the sinks are given.
//
// The path of a packet: linkReceived -> (record: the channel opens it in place | clear: SenderPolicy decides) -> takeFrame
// -> sequence counters, vehicles, inspector, recorder. Each wake-up ends in finishWake(): what the vehicles' conversations
// want sent is framed, coalesced, sealed and flushed, and one timer is set for the earliest deadline of all parts.
#pragma once

#include "core/engine/common/carrier_reader.h"
#include "core/engine/common/channel_driver.h"
#include "core/engine/common/deadline_timer.h"
#include "core/engine/common/sealed_in_place.h"
#include "core/mavlink/frame_intake.h"
#include "core/engine/station/event.h"
#include "core/engine/station/pending_vehicles.h"
#include "core/engine/station/inspector_table.h"
#include "core/engine/common/link_pool.h"
#include "core/engine/station/mavsec_stream.h"
#include "core/engine/station/metrics_sampler.h"
#include "core/engine/station/route_table.h"
#include "core/engine/common/pairing_driver.h"
#include "core/engine/station/protection.h"
#include "core/engine/station/recorder.h"
#include "core/engine/common/secret_files.h"
#include "core/engine/common/sender_policy.h"
#include "core/engine/station/station_config.h"
#include "core/engine/station/unanswering_agents.h"
#include "core/engine/station/unknown_agents.h"
#include "core/metrics/sequence_table.h"
#include "core/vehicle/gcs_heartbeat.h"
#include "core/vehicle/vehicle_set.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace skyseal::engine {

/// Where the core's output goes; called on the I/O thread.
struct StationSinks
{
    std::function<void(std::shared_ptr<const Snapshot>)> snapshot;
    std::function<void(Event)> event;
    std::function<void(channel::PairingEvent)> pairing = {};
};

class StationCore : private link::LinkListener
{
public:
    /// `secrets` is empty for a station that can only do plain links.
    StationCore(StationConfig config, std::unique_ptr<SecretFiles> secrets, StationSinks sinks);
    ~StationCore() override;

    void addLink(LinkId id, const link::LinkUrl &url);
    /// A link whose frames are encrypted as by the published code of MAVSec: read, never sent to.
    void addMavsecLink(LinkId id, const link::LinkUrl &url, crypto::MavsecCipher cipher);
    void removeLink(LinkId id);
    void switchSuite(channel::SessionId session, crypto::SuiteId suite);
    void holdSuite(std::optional<crypto::SuiteId> suite);
    void resumeSuite(crypto::SuiteId suite);
    void setAllowResearch(bool allow);
    void setWeakestSuite(crypto::SuiteId weakest);
    void setPeers(std::vector<channel::Peer> peers);
    void allowPlaintext(std::uint8_t systemId);
    /// Waits for an agent that is open for pairing; false without an identity. See Station.
    bool openPairing(std::string name, channel::PeerRole roleAsked, std::shared_ptr<const Key32> passphraseKey);
    void confirmPairing(const channel::PublicKey &key);
    void refusePairing();
    void cancelPairing();
    void command(vehicle::CommandId id, std::uint8_t systemId, const vehicle::VehicleCommand &command);
    /// Does something with a vehicle, if it is known; false otherwise.
    bool withVehicle(std::uint8_t systemId, const std::function<void(vehicle::Vehicle &, TimePoint)> &act);
    void setInspecting(bool inspecting);
    void setRecording(bool recording);
    void setMeasuring(bool measuring);
    /// In place of what the settings say, until it is called with nothing.
    void setProtection(std::optional<Protection> protection);
    /// The reader of snapshots answered; see Station.
    void setReaderAlive(bool alive) { m_readerAlive = alive; }
    /// Closes sessions, links and recording; the last snapshot.
    std::shared_ptr<const Snapshot> stop();

private:
    /// Frames that were refused and not told yet: one event a second at the most.
    template<typename Refused> struct Refusals
    {
        std::uint64_t total = 0;
        Refused pending;
        TimePoint notified = TimePoint::min();

        void count(std::uint8_t systemId)
        {
            ++total;
            ++pending.frames;
            pending.systemId = systemId;
        }
        bool isDue(TimePoint now) const
        {
            return pending.frames > 0 && (notified == TimePoint::min() || now - notified >= std::chrono::seconds(1));
        }
        Refused takePending(TimePoint now)
        {
            notified = now;
            return std::exchange(pending, {});
        }
    };
    /// What is measured of one session beside its own counters.
    struct SessionWatch
    {
        channel::PublicKey peer{};
        std::string peerName;
        LossMeter loss, peerLoss;
        Growth<60> forged, replayed, good; ///< a reading a second
    };
    struct Ended
    {
        channel::PublicKey peer{};
        std::string peerName;
        channel::DownReason reason{};
        TimePoint at;
    };
    struct VehicleWatch
    {
        LinkId link{};
        std::optional<channel::SessionId> session;
        std::optional<Ended> ended; ///< `session`
        LossMeter loss;
        Growth<4> frames;
        bool lost = false;
    };

    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerJoined(link::Link &link, const Path &path) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void linkChanged(link::Link &link);
    void noteRemoteOf(link::Link &link);

    bool maySeal(const link::Link &link) const;
    void takeStream(const link::Link &link, const link::ReceivedBlock &block);
    void takeDatagram(const link::Link &link, const link::ReceivedBlock &block);
    bool takeTunnel(const link::ReceivedBlock &block, const mavlink::ScanItem &item);
    void takeMessage(const link::ReceivedBlock &message);
    void takeRecord(TimePoint now, const link::ReceivedBlock &block);
    void takeInline(const link::ReceivedBlock &block, const mavlink::ScanItem &item);
    void takeSealed(TimePoint now, const Path &from, const channel::Delivery &delivery);
    void takeClear(TimePoint now, const Path &from, const mavlink::ScanItem &item);
    bool isOrWasSealed(const Path &from, std::uint8_t systemId) const;
    void refuseClear(TimePoint now, const Path &from, std::uint8_t systemId);
    void awaitApproval(TimePoint now, const Path &from, const mavlink::Frame &frame);
    void takeFrame(TimePoint now, const Path &from, const mavlink::Frame &frame, std::optional<channel::SessionId> session);
    void refuseSystem(TimePoint now, channel::SessionId session, std::uint8_t systemId);
    void nameSpoofer();
    void tellRefusals(TimePoint now);

    void finishWake();
    void handleDeadline();
    void handleEvents(TimePoint now, std::optional<channel::SessionId> speaking = {});
    void handleEvent(TimePoint now, const channel::Event &event);
    void serveVehicles(TimePoint now);
    void serveVehicle(TimePoint now, std::uint8_t systemId, vehicle::Vehicle &vehicle);
    void sendHeartbeats(TimePoint now);
    bool mayBeatAt(const Route &route) const;
    void greetRouters();
    void send(TimePoint now, Route &route, const vehicle::OutMessage &message);
    void everyQuarterSecond(TimePoint now);
    void everySecond(TimePoint now);
    void noteUnanswering(TimePoint now);
    void noteUp(const channel::SessionUp &up);
    void noteDown(TimePoint now, const channel::SessionDown &down);
    void keepSealedSystems();
    void notify(Event event) { m_sinks.event(std::move(event)); }

    void publish(TimePoint now);
    std::shared_ptr<Snapshot> takeSnapshot(TimePoint now); ///< in station_snapshot.cpp
    std::shared_ptr<const Probe> probe() const;
    SessionSnapshot describe(TimePoint now, const channel::SessionInfo &info) const;
    VehicleSnapshot describe(TimePoint now, const vehicle::Vehicle &vehicle) const;
    MavlinkTotals mavlinkTotals() const;
    ChannelTotals channelTotals() const;
    TimePoint nextDeadline() const;
    SecureMode secureMode() const; ///< in station_protection.cpp, as the next
    channel::Policy policy() const;
    void beginWithSuite(TimePoint now, const channel::SessionUp &up);
    bool isSealing(std::optional<Protection> protection) const { return m_channel && protection != Protection::Plain; }
    bool isSealing() const { return isSealing(m_protection); }

    void repeatGoodbye(TimePoint now, const Path &from);

    StationConfig m_config;
    std::optional<Protection> m_protection;         ///< of a measurement
    std::vector<ChannelDriver::Goodbye> m_goodbyes; ///< of the sessions that it ended
    TimePoint m_goodbyeAgain{};
    std::optional<crypto::SuiteId> m_heldSuite; ///< of a measurement: every session begins with it
    std::optional<crypto::SuiteId> m_nextSuite; ///< the next session begins with it
    std::vector<crypto::SuiteId> m_suites;      ///< as they were configured, before the weak ones were taken out
    StationSinks m_sinks;
    std::unique_ptr<SecretFiles> m_secrets;
    LinkPool m_links;
    std::unique_ptr<ChannelDriver> m_channel; ///< null without keys or with SecureMode::Off
    std::unique_ptr<PairingDriver> m_pairing; ///< null as well then
    SenderPolicy m_policy;
    mavlink::FrameIntake m_intake;
    CarrierReader m_carriers;
    std::map<LinkId, MavsecStream> m_mavsec;
    RouteTable m_routes;
    vehicle::VehicleSet m_vehicles;
    vehicle::GcsHeartbeat m_heartbeat;
    metrics::SequenceTable m_sequences;
    InspectorTable m_inspector;
    std::unique_ptr<Recorder> m_recorder;
    MetricsSampler m_sampler;
    std::map<channel::SessionId, SessionWatch> m_sessionWatches;
    std::map<std::uint8_t, VehicleWatch> m_vehicleWatches;
    // Who it was stands beside them as it comes with each frame; words are made of it when they are told.
    Refusals<PlaintextRefused> m_refusals;
    Address m_refusedFrom;
    Refusals<SystemRefused> m_spoofed; ///< sealed frames of a system that their peer may not speak as
    channel::SessionId m_spoofer{};
    UnansweringAgents m_unanswering{std::string()};
    UnknownAgents m_unknownAgents;
    PendingVehicles m_pendingVehicles;
    std::uint64_t m_garbage = 0; ///< datagrams that are neither records nor MAVLink
    std::uint64_t m_frameBytes = 0;
    std::uint64_t m_waitingBytes = 0, m_waitingDatagrams = 0; ///< see Probe
    bool m_readerAlive = true;
    bool m_measuring = false;
    bool m_stopped = false;
    bool m_changed = true;
    std::uint64_t m_snapshotNumber = 0;
    TimePoint m_start, m_lastSnapshot, m_nextQuarter;
    unsigned m_quarters = 0;
    DeadlineTimer m_timer;
};

} // namespace skyseal::engine
