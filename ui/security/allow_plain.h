// The confirmation by which an operator allows plain MAVLink for a vehicle that may be an impostor of a known agent. The
// dialog explains the consequences; the default answer is Cancel.
#pragma once

#include <QtCore/QString>

class QWidget;

namespace skyseal::engine {
struct PendingVehicle;
}

namespace skyseal::ui {

class StationInterface;

/// The text "Allow plain MAVLink for vehicle 1…" for buttons and the menu.
QString allowPlainText(const engine::PendingVehicle &held);
void askAllowPlain(StationInterface &station, const engine::PendingVehicle &held, QWidget *parent);

} // namespace skyseal::ui
