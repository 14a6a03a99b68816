// The station's engine as a window or a command line sees it: commands go in from any thread, snapshots and events
// come out as queued signals. Behind it one I/O thread owns sockets, timers, sessions and vehicles.
//
// Lives on the thread that creates it. When that thread stops answering for 3 s (a hung window), the ground station's
// heartbeat stops as well, so that the vehicle's own failsafe still works.
#pragma once

#include "core/channel/pairing.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/engine/station/event.h"
#include "core/engine/station/protection.h"
#include "core/engine/station/station_config.h"
#include "core/engine/station/snapshot.h"
#include "core/keys/peers_file.h"
#include "core/link/link_url.h"
#include "core/vehicle/request.h"

#include <QtCore/QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

Q_DECLARE_METATYPE(std::shared_ptr<const skyseal::engine::Snapshot>)
Q_DECLARE_METATYPE(skyseal::engine::Event)

namespace skyseal::engine {

class Station : public QObject
{
    Q_OBJECT

public:
    /// Reads the key files and starts the I/O thread; call crypto::initCrypto() first. An unreadable or unsafe key file is
    /// an error that names it.
    static Result<std::unique_ptr<Station>, InputError> create(StationConfig config);
    ~Station() override;

    LinkId addLink(const link::LinkUrl &url);
    /// A link whose frames are encrypted as by the published code of the paper MAVSec: INSECURE, read, and never sent to.
    LinkId addMavsecLink(const link::LinkUrl &url, crypto::MavsecCipher cipher);
    void removeLink(LinkId);
    void switchSuite(channel::SessionId, crypto::SuiteId);
    /// While something is measured: sessions that come up begin with this suite, in place of the one that the configuration
    /// prefers. nullopt ends that.
    void holdSuite(std::optional<crypto::SuiteId>);
    /// The sessions that are up go over to this suite. Where none is heard, the next one that comes up does, and no other.
    void resumeSuite(crypto::SuiteId);
    void setAllowResearch(bool);
    /// Suites weaker than this one are no longer offered; see channel::strengthOf. Sessions that use one are switched.
    void setWeakestSuite(crypto::SuiteId weakest);
    /// After the peers file was changed; sessions of peers that are no longer in it end. An error leaves the old list in
    /// force; otherwise what is in force now.
    Result<keys::PeersInForce, InputError> reloadPeers();
    /// Takes a vehicle in clear that is held back because it may be an impostor, for as long as this station lives. A
    /// person's explicit act, and nothing else's.
    void allowPlaintext(std::uint8_t systemId);
    /// Waits for an agent that is open for pairing; what happens comes as pairing(). Needs an identity. `name` is what we
    /// call ourselves, `roleAsked` what we want to be there; `passphraseKey` is of channel::pairingPassphraseKey(), null without
    /// a passphrase. Nothing is stored.
    void openPairing(std::string name, channel::PeerRole roleAsked, std::shared_ptr<const Key32> passphraseKey = {});
    /// The person compared the fingerprints of this key at both ends.
    void confirmPairing(const channel::PublicKey &key);
    void refusePairing();
    void cancelPairing();
    /// Sends a request to a vehicle and returns at once; its result arrives as an event with the returned id.
    vehicle::RequestId perform(std::uint8_t systemId, vehicle::Request request);
    void setInspecting(bool);
    void setRecording(bool);
    /// Snapshots carry a Probe from now on.
    void setMeasuring(bool);
    /// How links carry MAVLink while they are measured, in place of what the configuration says; nullopt ends that. Sessions
    /// that do not fit end and begin anew; links stay open.
    void setProtection(std::optional<Protection>);
    /// Says goodbye to every peer, ends the recording and answers with stopped(); nothing is received after that.
    void stop();
    /// Our own public key; nullopt without an identity.
    std::optional<channel::PublicKey> publicKey() const;

Q_SIGNALS:
    void snapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void eventOccurred(skyseal::engine::Event event);
    void pairing(skyseal::channel::PairingEvent event);
    /// The last word: all counters as they stood at the end.
    void stopped(std::shared_ptr<const skyseal::engine::Snapshot> last);

private:
    struct Private;
    explicit Station(std::unique_ptr<Private>);
    std::unique_ptr<Private> d;
};

} // namespace skyseal::engine
