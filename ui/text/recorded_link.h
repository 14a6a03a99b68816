// How the link of a vehicle in a replay was protected, as far as it is noted beside the recording: a replay has no link of its
// own that could be sealed or not.
#pragma once

#include "core/crypto/suite.h"
#include "ui/view_state.h"

#include <QtCore/QString>

#include <optional>

namespace skyseal::ui {

struct RecordedLink
{
    bool isNoted = false;
    /// None: it was plain MAVLink; nullopt also for a suite that this build does not know.
    std::optional<crypto::SuiteId> suite = {};
    QString suiteName = {}; ///< of a sealed link; empty if several links with different suites may be meant
    QString peers = {};     ///< of a sealed link

    bool isPlain() const { return suite == crypto::SuiteId::None; }
    /// "Was sealed · ChaCha20-Poly1305 · air-1", and shorter.
    QStringList variants() const;
    /// The same in a sentence.
    QString sentence() const;
};

/// At the position of the replay; nullopt if the vehicle is not heard by a recording.
std::optional<RecordedLink> recordedLinkOf(const ViewState &view, const engine::VehicleSnapshot &vehicle);

} // namespace skyseal::ui
