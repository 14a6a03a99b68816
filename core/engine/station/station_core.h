// The station's engine: wires links, secure channel, vehicles, recording and counters together and schedules them. The parts
// do the work; each can be read and tested by itself. Lives on the I/O thread; other threads reach it only through Station,
// which posts calls and passes on the output of the sinks.
//
// The path of a packet: linkReceived -> Ingress -> StationReceiver (record: the channel opens it in place | clear: FrameGate
// judges it) -> Fleet, recorder. Each wake-up ends in finishWake(): the outgoing frames of the vehicles are
// coalesced, sealed and flushed, and one timer is set for the earliest deadline of all parts.
#pragma once

#include "core/engine/common/deadline_timer.h"
#include "core/engine/common/ingress.h"
#include "core/engine/station/event.h"
#include "core/engine/station/fleet.h"
#include "core/engine/station/metrics_sampler.h"
#include "core/engine/station/recorder.h"
#include "core/engine/station/security_settings.h"
#include "core/engine/station/snapshot_pace.h"
#include "core/engine/station/station_channel.h"
#include "core/engine/station/station_config.h"
#include "core/engine/station/station_receiver.h"
#include "core/engine/station/station_sender.h"
#include "core/engine/station/station_storage.h"
#include "core/engine/station/station_snapshot.h"
#include "core/link/steady_now.h"

#include <functional>
#include <memory>
#include <optional>

namespace skyseal::engine {

/// Receivers of the core's output; called on the I/O thread.
struct StationSinks
{
    std::function<void(std::shared_ptr<const Snapshot>)> snapshot;
    Notify event;
    std::function<void(channel::PairingEvent)> pairing = {};
    std::function<void(std::shared_ptr<const Snapshot>)> probed = {};
    /// Events that did not reach the reader; shown in snapshots.
    std::function<std::uint64_t()> eventsDropped = {};
};

class StationCore : private link::LinkListener, private StationReceiver::EventHandler, private Gateway::Vehicles
{
public:
    /// `secrets` is empty for a station that can only use plain links.
    StationCore(StationConfig config, std::unique_ptr<SecretFiles> secrets, StationSinks sinks);
    ~StationCore() override;

    // Links.
    void addLink(LinkId id, const link::LinkUrl &url);
    /// A link whose frames are encrypted as by the published code of MAVSec: receive only.
    void addMavsecLink(LinkId id, const link::LinkUrl &url, crypto::MavsecCipher cipher);
    void removeLink(LinkId id);

    /// Serves clients on these links, in place of the earlier ones.
    void serve(std::vector<ServeConfig> served);

    /// Also passes the accepted frames to `feed`; null: no longer.
    void setFeed(std::shared_ptr<Feed> feed);

    // Security.
    void switchSuite(channel::SessionId session, crypto::SuiteId suite);
    void setAllowResearch(bool allow);
    void setWeakestSuite(crypto::SuiteId weakest);
    void setPeers(std::vector<channel::Peer> peers);
    void allowPlaintext(std::uint8_t systemId);

    // Pairing.
    /// Waits for an agent that is open for pairing; returns false without an identity. See Station.
    bool openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase);
    void confirmPairing(const channel::PublicKey &key);
    void refusePairing();
    void cancelPairing();

    // Vehicles.
    /// See Station.
    void forgetVehicle(std::uint8_t systemId)
    {
        if (m_fleet.forget(steadyNow(), systemId))
            m_pace.markChanged();
        finishWake();
    }
    /// Starts a request; its result arrives as an event with this id, at once if the vehicle is unknown.
    void perform(vehicle::RequestId id, std::uint8_t systemId, const vehicle::Request &request);

    // Measurements; see SecuritySettings.
    void holdSuite(std::optional<crypto::SuiteId> suite) { m_settings.holdSuite(suite); }
    void resumeSuite(crypto::SuiteId suite);
    void setProtection(std::optional<Protection> protection);
    /// See StationReceiver.
    void setBareCipher(std::optional<crypto::MavsecCipher> &&cipher) { m_receiver.setBareCipher(std::move(cipher)); }
    void setMeasuring(bool measuring);
    void requestCosts(bool request);
    void requestProbe();
    void setSnapshotsPerSecond(int perSecond)
    {
        m_pace.setPerSecond(perSecond);
        finishWake();
    }

    // Observation.
    void setInspecting(bool inspecting) { m_fleet.inspector().setWatching(inspecting); }
    void chooseFields(std::vector<FieldChoice> choices) { m_fleet.fields().choose(std::move(choices)); }
    void setRecording(bool recording);
    /// Whether the reader of snapshots answers; see Station.
    void setReaderAlive(bool alive) { m_sender.setReaderAlive(alive); }

    /// Closes sessions, links and recording; returns the last snapshot.
    std::shared_ptr<const Snapshot> stop();

private:
    /// Readings are taken four times a second, some of them every fourth time.
    struct Clock
    {
        TimePoint start;
        TimePoint nextQuarter = start;
        unsigned quarters = 0;
    };

    void linkReceived(link::Link &link, std::span<const link::ReceivedBlock> blocks) override;
    void linkPeerJoined(link::Link &link, const Path &path) override;
    void linkPeerLeft(link::Link &link, const Path &path) override;
    void linkChanged(link::Link &link);
    /// Sends to addresses from which nothing has arrived: to listening agents, and to routers that do not know the station yet.
    void callAgents(TimePoint now);
    void followLinks();
    bool isVehicle(std::uint8_t systemId) const override
    {
        return m_fleet.vehicles().all().contains(systemId) || m_receiver.gate().policy().isSealedSystem(systemId);
    }
    void forward(TimePoint now, std::uint8_t systemId, ByteView frame) override;
    void sendForwarded() override { finishWake(); }

    void finishWake();
    void handleDeadline();
    TimePoint nextDeadline() const;
    void everyQuarterSecond(TimePoint now);
    void everySecond(TimePoint now);
    void handleEvents(TimePoint now, std::optional<channel::SessionId> speaking) override;
    void handleEvent(TimePoint now, const channel::Event &event);
    void handleSessionUp(TimePoint now, const channel::SessionUp &up);
    void handleSessionDown(TimePoint now, const channel::SessionDown &down);
    void publishUnanswering(TimePoint now);
    void applyPolicy();
    void saveSealedSystems(TimePoint now);
    bool isClearAllowed() const { return m_settings.mode() != SecureMode::Required; }
    bool isSealing() const { return m_channel && !m_settings.isPlain(); }
    SnapshotSources sources();
    std::shared_ptr<Snapshot> takeSnapshot(TimePoint now, bool withProbe = false);
    void publishSnapshot(TimePoint now, bool withProbe);

    StationConfig m_config;
    StationSinks m_sinks;
    SecuritySettings m_settings;
    std::unique_ptr<SecretFiles> m_secrets;
    LinkPool m_links;
    Ingress m_ingress;
    std::unique_ptr<StationChannel> m_channel; ///< null without keys or with SecureMode::Off
    Fleet m_fleet;
    std::unique_ptr<Recorder> m_recorder;
    StationSender m_sender;
    StationReceiver m_receiver;
    std::unique_ptr<Gateway> m_gateway; ///< null while no clients are served
    std::shared_ptr<Feed> m_feed;       ///< null while nothing is published
    MetricsSampler m_sampler;
    SnapshotPace m_pace;
    EventPublisher<Event, StationCauses> m_events; ///< limits the events that strangers can cause
    StationStorage m_storage;
    Clock m_clock;
    bool m_measuring = false;
    Duration m_watchingCpu{}; ///< see Probe
    bool m_stopped = false;
    DeadlineTimer m_timer;
};

} // namespace skyseal::engine
