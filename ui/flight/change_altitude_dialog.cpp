#include "ui/flight/change_altitude_dialog.h"

#include "ui/flight/vehicle_commands.h"

namespace skyseal::ui {

ChangeAltitudeDialog::ChangeAltitudeDialog(VehicleCommands &commands, UnitSystem units, double metres, QWidget *parent)
    : AltitudeDialog(commands, units, metres,
                     {.id = QStringLiteral("changeAltitudeDialog"),
                      .title = tr("Change altitude"),
                      .hint = tr("Hold the button for half a second. The vehicle leaves its mission, and climbs or descends "
                                 "where it is."),
                      .verb = tr("Change altitude"),
                      .highest = kHighestFlown,
                      .permit = vehicle::ChangeAltitude{metres, true}},
                     parent)
{}

void ChangeAltitudeDialog::command(VehicleCommands &commands, std::uint8_t systemId, double metres)
{
    commands.send(systemId, vehicle::ChangeAltitude{metres, true});
}

} // namespace skyseal::ui

#include "moc_change_altitude_dialog.cpp"
