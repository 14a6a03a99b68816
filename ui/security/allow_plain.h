// The one act by which an operator takes a vehicle in clear that may be an impostor of a known agent: a question that says
// what it means, whose answer is no unless yes is chosen.
#pragma once

#include "core/engine/station/snapshot.h"

#include <QtCore/QString>

class QWidget;

namespace skyseal::ui {

class StationInterface;

/// "Allow plain MAVLink for vehicle 1 …", of buttons and the menu.
QString allowPlainText(const engine::PendingVehicle &held);
void askAllowPlain(StationInterface &station, const engine::PendingVehicle &held, QWidget *parent);

} // namespace skyseal::ui
