// The buttons that command the vehicle, each held to confirm, and the result of the last command.
#pragma once

#include "ui/flight/hold_button.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/view_state.h"
#include "ui/text/units.h"

#include <QtWidgets/QWidget>

class QComboBox;

namespace skyseal::ui {

class AltitudeBox;
class ResultLabel;

class VehicleActions : public QWidget
{
    Q_OBJECT

public:
    explicit VehicleActions(VehicleCommands &commands, QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    void setUnits(UnitSystem units);
    void say(const QString &line, bool ok);

private:
    /// Aborts holds whose meaning has changed.
    void endHolds(const std::vector<HoldButton *> &buttons, const QString &why);
    void showPermit(const ViewState &view);
    /// Offers the modes of the vehicle and selects the one in use, unless the operator has selected another.
    void showModes(const std::vector<std::string> &modes, const std::string &current);

    VehicleCommands &m_commands;
    HoldButton *m_arm, *m_takeOff, *m_land, *m_return, *m_setMode;
    QComboBox *m_modes;
    AltitudeBox *m_altitude;
    ResultLabel *m_result;
    std::vector<std::string> m_knownModes;
    QString m_disabledReason; ///< reason why commands cannot be sent, as shown in the result line
    std::uint8_t m_systemId = 0;
    bool m_armed = false;
    bool m_modeEdited = false; ///< the selected mode is the operator's choice, which the vehicle is not in
};

} // namespace skyseal::ui
