// The replay of one recording beside the station, with its own picture: plays, pauses, changes the speed, and seeks. A thread
// of its own reads the file.
//
// A seek backward begins anew and takes everything from the beginning up to the new position, since home, parameters
// and texts may have been recorded long before it; only so is the picture that of the whole flight. A million frames, those of
// about two hours, take a few tenths of a second. Until then the picture of before stays; a newer seek replaces one that is
// under way.
//
// Lives on the thread that creates it.
#pragma once

#include "core/engine/replay/replay_command.h"
#include "core/engine/station/event.h"
#include "core/engine/station/field_reading.h"
#include "core/engine/station/snapshot_ptr.h"
#include "core/link/link_url.h"

#include <QtCore/QObject>

#include <memory>

namespace skyseal::engine {

class Replay : public QObject
{
    Q_OBJECT

public:
    /// Plays at once, from the beginning. `recording` is the URL of a recording; whether it can be read is shown by the link of
    /// the snapshots.
    explicit Replay(const link::LinkUrl &recording);
    ~Replay() override;

    /// Returns at once; its effect is shown by the snapshots.
    void perform(const ReplayCommand &command);
    void setInspecting(bool inspecting);
    /// See Station::chooseFields(). Messages that were played before show no values of them; the next message or jump does.
    void chooseFields(std::vector<FieldChoice> choices);

Q_SIGNALS:
    /// At most 30 a second; Snapshot::replay is set.
    void snapshotReady(std::shared_ptr<const skyseal::engine::Snapshot> snapshot);
    /// Events of the recording as it is played; those that a seek passes over are not emitted.
    void eventOccurred(skyseal::engine::Event event);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace skyseal::engine
