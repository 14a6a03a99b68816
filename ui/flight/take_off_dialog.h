// Vehicle -> Take off: asks how high, then wants the button held, as the one of the flight panel does. It is for the vehicle
// that was shown as it opened.
#pragma once

#include "ui/text/units.h"

#include <QtWidgets/QDialog>

namespace skyseal::ui {

class AltitudeBox;
class VehicleCommands;

class TakeOffDialog : public QDialog
{
    Q_OBJECT

public:
    TakeOffDialog(VehicleCommands &commands, UnitSystem units, QWidget *parent = nullptr);
};

} // namespace skyseal::ui
