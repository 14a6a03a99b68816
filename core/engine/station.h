// The station's engine as a window or a command line sees it: commands go in from any thread, snapshots and happenings
// come out as queued signals. Behind it one I/O thread owns sockets, timers, sessions and vehicles.
//
// Lives on the thread that creates it. When that thread stops answering for 3 s (a hung window), the ground station's
// heartbeat stops as well, so that the vehicle's own failsafe still works.
#pragma once

#include "core/channel/policy.h"
#include "core/engine/happening.h"
#include "core/engine/snapshot.h"
#include "core/link/link_url.h"
#include "core/vehicle/vehicle_command.h"

#include <QtCore/QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

Q_DECLARE_METATYPE(std::shared_ptr<const skyseal::engine::Snapshot>)
Q_DECLARE_METATYPE(skyseal::engine::Happening)

namespace skyseal::engine {

/// What the operator asks of the link's security.
enum class SecureMode : std::uint8_t {
    Preferred, ///< sealed where the vehicle's agent is known; plain vehicles are shown as "not sealed"
    Required,  ///< clear MAVLink is never shown
    Off        ///< plain only: no handshake
};

/// Where the secrets and the known peers are; empty paths mean a station that can only do plain links.
struct KeyPaths
{
    std::string identity; ///< private key file
    std::string peers;    ///< known peers
};

struct StationConfig
{
    std::uint8_t systemId = 255;
    std::uint8_t componentId = 190;
    SecureMode secure = SecureMode::Preferred;
    KeyPaths keys;
    channel::Policy policy;
    bool record = true;
    std::string recordFolder;
    bool lowBandwidth = false; ///< ask vehicles for slower streams
    int snapshotsPerSecond = 30; ///< at most 30
};

class Station : public QObject
{
    Q_OBJECT

public:
    /// Reads the key files and starts the I/O thread. An unreadable or unsafe key file is an error that names it.
    static Result<std::unique_ptr<Station>, InputError> create(StationConfig config);
    ~Station() override;

    LinkId addLink(const link::LinkUrl &url);
    void removeLink(LinkId);
    void switchSuite(channel::SessionId, crypto::SuiteId);
    /// Every session that is up now or comes up later begins with this suite.
    void setPreferredSuite(crypto::SuiteId);
    void setAllowResearch(bool);
    void reloadPeers(); ///< after the peers file was changed
    vehicle::CommandId command(std::uint8_t systemId, vehicle::VehicleCommand command);
    void requestParameters(std::uint8_t systemId);
    void writeParameter(std::uint8_t systemId, std::string name, double value);
    void readMission(std::uint8_t systemId);
    void writeMission(std::uint8_t systemId, std::vector<vehicle::MissionItem> items);
    void setInspecting(bool);
    void setRecording(bool);
    /// Our own public key; nullopt without an identity.
    std::optional<channel::PublicKey> publicKey() const;

Q_SIGNALS:
    void snapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void happened(skyseal::engine::Happening happening);

private:
    struct Private;
    explicit Station(std::unique_ptr<Private>);
    std::unique_ptr<Private> d;
};

} // namespace skyseal::engine
