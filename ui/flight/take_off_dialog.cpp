#include "ui/flight/take_off_dialog.h"

#include "ui/flight/confirm_command.h"
#include "ui/flight/vehicle_commands.h"

namespace skyseal::ui {

TakeOffDialog::TakeOffDialog(VehicleCommands &commands, UnitSystem units, QWidget *parent)
    : AltitudeDialog(commands, units, commands.takeOffAltitude(),
                     {.id = QStringLiteral("takeOffDialog"),
                      .title = tr("Take off"),
                      .hint = tr("Hold the button for half a second. The propellers speed up and the vehicle climbs."),
                      .verb = tr("Take off"),
                      .permit = vehicle::TakeOff{.altitude = commands.takeOffAltitude(), .prepare = true},
                      .armingHint = tr("Hold the button for half a second. The vehicle is armed, and takes off at once."),
                      .armingVerb = tr("Arm and take off")},
                     parent)
{}

void TakeOffDialog::command(VehicleCommands &commands, std::uint8_t systemId, double metres)
{
    commands.setTakeOffAltitude(metres);
    sendOrAsk(commands, systemId, vehicle::TakeOff{.altitude = metres, .prepare = true}, parentWidget());
}

} // namespace skyseal::ui

#include "moc_take_off_dialog.cpp"
