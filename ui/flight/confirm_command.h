// The question before a command that a menu sends: names the vehicle if there are several, and the command as the verb.
#pragma once

#include "core/vehicle/vehicle_command.h"

#include <QtCore/QString>

class QMessageBox;
class QWidget;

namespace skyseal::ui {

class VehicleCommands;

/// Asks once about the vehicle that is shown at this moment, in a box over `window`. Closing the box or Esc means no. `details`
/// may be empty. There is one question at a time: the same one comes to the front, another one is closed. Returns the box,
/// which deletes itself when it closes.
QMessageBox *confirmCommand(VehicleCommands &commands, const vehicle::VehicleCommand &command, const QString &question,
                            const QString &details, QWidget *window);

/// Open items of the shown vehicle's checklist, as the details of a question; empty if nothing is.
QString openItemsText(VehicleCommands &commands);
/// Sends a command that the operator has held. One that arms the vehicle waits for a confirmation if something is open on its
/// checklist.
void sendOrAsk(VehicleCommands &commands, std::uint8_t systemId, const vehicle::VehicleCommand &command, QWidget *window);

} // namespace skyseal::ui
