// The interface of the window to the station: requests, snapshots and events. The application implements it with the engine,
// tests with a fake, so that no test of the window needs sockets or threads.
#pragma once

#include "core/base/result.h"
#include "core/engine/gateway/serve_config.h"
#include "core/engine/replay/recording_info.h"
#include "core/engine/replay/replay_command.h"
#include "core/engine/station/event.h"
#include "core/engine/common/mavsec_settings.h"
#include "core/engine/station/field_reading.h"
#include "core/engine/station/snapshot_ptr.h"
#include "core/vehicle/request.h"

#include <QtCore/QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::ui {

using engine::SnapshotPtr;

/// Lives on the GUI thread. Requests return at once; results arrive as events.
class StationInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Adds a link by its URL. Fails if the URL is invalid; the snapshot shows whether the link opens.
    virtual Result<LinkId, InputError> addLink(const std::string &url) = 0;
    /// Adds a listen-only link for a stream of MAVSec's published code, which is insecure. Fails if its key cannot be read.
    virtual Result<LinkId, InputError> addMavsecLink(const std::string &url, const engine::MavsecSettings &settings) = 0;
    virtual void removeLink(LinkId link) = 0;
    /// Serves other ground stations on these links from now on, in place of the links before.
    virtual void serve(std::vector<engine::ServeConfig> served) = 0;
    virtual void switchSuite(channel::SessionId session, crypto::SuiteId suite) = 0;
    virtual void setAllowResearch(bool allow) = 0;
    virtual void setWeakestSuite(crypto::SuiteId weakest) = 0;
    virtual void allowPlaintext(std::uint8_t systemId) = 0;
    /// Shows a vehicle that is lost no longer, until it is heard again.
    virtual void forgetVehicle(std::uint8_t systemId) = 0;
    /// Sends a request to a vehicle; its result arrives as an event with the returned id.
    virtual vehicle::RequestId perform(std::uint8_t systemId, vehicle::Request request) = 0;
    virtual void setInspecting(bool inspecting) = 0;
    virtual void setRecording(bool recording) = 0;
    virtual std::optional<channel::PublicKey> publicKey() const = 0;
    /// Replays a recording beside the station, which goes on unchanged: nothing of the recording meets its peers, vehicles and
    /// links. Ends the replay before. Fails if the URL is not that of a recording.
    virtual Result<void, InputError> startReplay(const std::string &url) = 0;
    /// Without a replay it has no effect.
    virtual void controlReplay(const engine::ReplayCommand &command) = 0;
    virtual void endReplay() = 0;
    /// Lists the recordings in a folder: recordingsListed() follows, then recordingRead() for each that was not read before.
    /// Ends an earlier listing.
    virtual void listRecordings(const std::string &folder) = 0;
    virtual void stopListing() = 0;
    /// Snapshots then have the newest values of these fields, those of a replay as well.
    virtual void chooseFields(std::vector<engine::FieldChoice> choices) = 0;

Q_SIGNALS:
    void snapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void eventOccurred(skyseal::engine::Event event);
    /// A part of this program has sent a command by perform() for which a vehicle may change its mode.
    void modeChangeSent(std::uint8_t systemId);
    void replaySnapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void replayEventOccurred(skyseal::engine::Event event);
    void recordingsListed(std::vector<skyseal::engine::RecordingInfo> recordings);
    void recordingRead(skyseal::engine::RecordingInfo recording);
};

} // namespace skyseal::ui
