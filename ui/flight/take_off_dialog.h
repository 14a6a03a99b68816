// The take-off dialog of the Vehicle menu: asks for the altitude and uses a hold button, like the flight panel. It applies to
// the vehicle that was selected when it opened.
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
