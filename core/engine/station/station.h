// Interface of the station's engine for windows and command lines: calls go in, snapshots and events come out as signals. One
// I/O thread behind it owns sockets, timers, sessions and vehicles.
//
// Lives on the thread that creates it. If that thread does not answer for 3 s (a hung window), the station's heartbeat stops,
// so that the vehicle's own failsafe acts; meanwhile at most one snapshot and a limited number of events wait (OutputQueue).
#pragma once

#include "core/channel/pairing.h"
#include "core/engine/gateway/serve_config.h"
#include "core/engine/station/event.h"
#include "core/engine/station/feed.h"
#include "core/engine/station/field_reading.h"
#include "core/engine/station/protection.h"
#include "core/engine/station/station_config.h"
#include "core/keys/usable_peers.h"
#include "core/link/link_url.h"
#include "core/vehicle/request.h"

#include <QtCore/QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {
struct Snapshot;
}

namespace skyseal::crypto {
class MavsecCipher;
}

namespace skyseal::engine {

class Station : public QObject
{
    Q_OBJECT

public:
    /// Reads the key files and starts the I/O thread; call crypto::initCrypto() first. An unreadable or unsafe key file is an
    /// error that names the file.
    static Result<std::unique_ptr<Station>, InputError> create(StationConfig config);
    /// Sends Close to every peer, unless stop() was called, and ends the I/O thread.
    ~Station() override;

    LinkId addLink(const link::LinkUrl &url);
    /// A link whose frames are encrypted as by the published code of the paper MAVSec: INSECURE, receive only.
    LinkId addMavsecLink(const link::LinkUrl &url, crypto::MavsecCipher cipher);
    void removeLink(LinkId);
    /// Serves other ground stations on these links, in place of those of an earlier call; see Gateway.
    void serve(std::vector<ServeConfig> served);
    /// Also passes the accepted frames to `feed`, from the next one on.
    void setFeed(std::shared_ptr<Feed> feed);
    void switchSuite(channel::SessionId, crypto::SuiteId);
    /// For measurements: new sessions begin with this suite, in place of the configured preference, which nullopt restores.
    void holdSuite(std::optional<crypto::SuiteId>);
    /// Switches the sessions that are up to this suite. If no records arrive in any of them, only the next session
    /// begins with it.
    void resumeSuite(crypto::SuiteId);
    void setAllowResearch(bool);
    /// Stops offering suites weaker than this one; see crypto::SuiteStrength. Sessions that use one are switched.
    void setWeakestSuite(crypto::SuiteId weakest);
    /// Replaces the list of known peers; sessions of peers that are not listed end.
    void setPeers(std::vector<channel::Peer> peers);
    /// Accepts a vehicle in clear that awaits approval because it may be an impostor, until this station is destroyed. Only
    /// an explicit act of the operator may call it.
    void allowPlaintext(std::uint8_t systemId);
    /// Shows a vehicle that is lost no longer, until it is heard again; a vehicle that is not lost stays. Its protection
    /// stays known: if it was sealed, it is not accepted in clear.
    void forgetVehicle(std::uint8_t systemId);
    /// Waits for an agent that is open for pairing; progress is reported by pairing(). Requires an identity. `name` is this
    /// station's own. With `passphrase` only an agent with the same one is shown; null without one. Nothing is stored.
    void openPairing(std::string name, std::shared_ptr<const crypto::Passphrase> passphrase = {});
    /// The operator compared the code at both ends, or agreed on a passphrase, and accepts this key.
    void confirmPairing(const channel::PublicKey &key);
    void refusePairing();
    void cancelPairing();
    /// Sends a request to a vehicle and returns at once; its result arrives as an event with the returned id.
    vehicle::RequestId perform(std::uint8_t systemId, vehicle::Request request);
    void setInspecting(bool);
    /// Snapshot::fields then has the newest values of these fields, in place of those chosen before.
    void chooseFields(std::vector<FieldChoice> choices);
    void setRecording(bool);
    /// While true, the cost of each record is kept for probes.
    void setMeasuring(bool);
    /// While true, the reports of the peers, once a second, have their costs. They answer a change at once.
    void requestCosts(bool);
    /// Takes one snapshot with a Probe, in the order of the calls; it is emitted by probeTaken(), and none after stop().
    void requestProbe();
    /// Changes StationConfig::snapshotsPerSecond. 0: only requested snapshots, and the last.
    void setSnapshotsPerSecond(int);
    /// Sets the protection of MAVLink during a measurement, in place of the configuration, which nullopt restores. Sessions
    /// that do not match end and begin anew; links stay open.
    void setProtection(std::optional<Protection>);
    /// For a measurement of MAVSec's published code, in plain MAVLink: the vehicles encrypt the payloads that they send, and
    /// receive in clear. INSECURE. nullopt: they do not.
    void setBareCipher(std::optional<crypto::MavsecCipher> cipher);
    /// Sends Close to every peer, ends the recording and emits stopped(); nothing is received after that.
    void stop();
    /// The station's own public key; nullopt without an identity.
    std::optional<channel::PublicKey> publicKey() const;

Q_SIGNALS:
    void snapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void eventOccurred(skyseal::engine::Event event);
    void pairing(skyseal::channel::PairingEvent event);
    /// A snapshot that requestProbe() requested; it is not among those of snapshotReady().
    void probeTaken(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    /// The final signal, with the final counters.
    void stopped(std::shared_ptr<const skyseal::engine::Snapshot> last);

private:
    struct Private;
    explicit Station(std::unique_ptr<Private>);
    std::unique_ptr<Private> d;
};

} // namespace skyseal::engine
