// The dialog that adds a waypoint to the mission of the selected vehicle and sends the mission.
#pragma once

#include "ui/flight/altitude_dialog.h"

namespace skyseal::ui {

class AddWaypointDialog : public AltitudeDialog
{
    Q_OBJECT

public:
    /// `latitude` and `longitude` in degrees; `where` says them to the operator.
    AddWaypointDialog(VehicleCommands &commands, UnitSystem units, double latitude, double longitude, const QString &where,
                      QWidget *parent = nullptr);

private:
    void command(VehicleCommands &commands, std::uint8_t systemId, double metres) override;

    const double m_latitude, m_longitude;
};

} // namespace skyseal::ui
