// The station as the windows see it: what they may ask and what they hear. The application puts the engine behind it,
// tests a scripted one, so that no window needs sockets or a thread to be shown or tested.
#pragma once

#include "core/base/result.h"
#include "core/engine/station/event.h"
#include "core/engine/station/mavsec_settings.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/request.h"

#include <QtCore/QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::ui {

using SnapshotPtr = std::shared_ptr<const engine::Snapshot>;

/// Lives on the GUI thread. Commands return at once; what became of them comes as a event.
class StationInterface : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// A link by its URL, or what is wrong with the text. Whether it opens shows in the snapshot's links.
    virtual Result<LinkId, InputError> addLink(const std::string &url) = 0;
    /// The same for a stream of MAVSec's published code: insecure, only read. Also an error when its key cannot be read.
    virtual Result<LinkId, InputError> addMavsecLink(const std::string &url, const engine::MavsecSettings &settings) = 0;
    virtual void removeLink(LinkId link) = 0;
    virtual void switchSuite(channel::SessionId session, crypto::SuiteId suite) = 0;
    virtual void setAllowResearch(bool allow) = 0;
    virtual void setWeakestSuite(crypto::SuiteId weakest) = 0;
    virtual void allowPlaintext(std::uint8_t systemId) = 0;
    /// Sends a request to a vehicle; its result arrives as an event with the returned id.
    virtual vehicle::RequestId perform(std::uint8_t systemId, vehicle::Request request) = 0;
    virtual void setInspecting(bool inspecting) = 0;
    virtual void setRecording(bool recording) = 0;
    virtual std::optional<channel::PublicKey> publicKey() const = 0;

Q_SIGNALS:
    void snapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    void eventOccurred(skyseal::engine::Event event);
};

} // namespace skyseal::ui
