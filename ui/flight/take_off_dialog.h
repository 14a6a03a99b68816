// The take-off dialog of the Vehicle menu.
#pragma once

#include "ui/flight/altitude_dialog.h"

namespace skyseal::ui {

class TakeOffDialog : public AltitudeDialog
{
    Q_OBJECT

public:
    TakeOffDialog(VehicleCommands &commands, UnitSystem units, QWidget *parent = nullptr);

private:
    void command(VehicleCommands &commands, std::uint8_t systemId, double metres) override;
};

} // namespace skyseal::ui
