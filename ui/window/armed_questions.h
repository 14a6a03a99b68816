// The questions before what takes the controls of an armed vehicle from the operator.
#pragma once

#include <QtCore/QString>

#include <functional>

class QWidget;

namespace skyseal::engine {
struct Snapshot;
} // namespace skyseal::engine

namespace skyseal::ui {

/// The system IDs of the armed vehicles, as "1, 2"; empty if none is.
QString armedVehicles(const engine::Snapshot &snapshot);
/// The same of those that are heard over a session with this peer.
QString armedVehiclesOf(const engine::Snapshot &snapshot, const QString &peer);

/// Each asks over `window` and calls the function if the operator confirms. `armed`: not empty.
void askToReplay(const QString &armed, QWidget *window, std::function<void()> replay);
void askToQuit(const QString &armed, QWidget *window, std::function<void()> quit);

} // namespace skyseal::ui
