// The dialog that changes the altitude of a flying vehicle; it offers the present one.
#pragma once

#include "ui/flight/altitude_dialog.h"

namespace skyseal::ui {

class ChangeAltitudeDialog : public AltitudeDialog
{
    Q_OBJECT

public:
    /// `metres`: the present altitude above home.
    ChangeAltitudeDialog(VehicleCommands &commands, UnitSystem units, double metres, QWidget *parent = nullptr);

private:
    void command(VehicleCommands &commands, std::uint8_t systemId, double metres) override;
};

} // namespace skyseal::ui
