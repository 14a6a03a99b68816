#include "ui/flight/vehicle_actions.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/flight/altitude_box.h"
#include "ui/result_label.h"
#include "ui/text/command_permits.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QGridLayout>

namespace skyseal::ui {

VehicleActions::VehicleActions(VehicleCommands &commands, QWidget *parent) : QWidget(parent), m_commands(commands)
{
    m_arm = new HoldButton(tr("Arm"), this);
    m_arm->setObjectName(QStringLiteral("armButton"));
    m_takeOff = new HoldButton(tr("Take off"), this);
    m_takeOff->setObjectName(QStringLiteral("takeOffButton"));
    m_land = new HoldButton(tr("Land"), this);
    m_land->setObjectName(QStringLiteral("landButton"));
    m_return = new HoldButton(tr("RTL"), this);
    m_return->setObjectName(QStringLiteral("returnButton"));
    m_setMode = new HoldButton(tr("Set mode"), this);
    m_setMode->setObjectName(QStringLiteral("setModeButton"));
    for (HoldButton *button : {m_arm, m_takeOff, m_land, m_return, m_setMode})
        button->setAccessibleName(button->text());
    m_modes = new QComboBox(this);
    m_modes->setObjectName(QStringLiteral("modeBox"));
    m_modes->setAccessibleName(tr("Flight mode to set"));
    m_modes->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_modes->setMinimumContentsLength(8);
    connect(m_modes, &QComboBox::currentIndexChanged, this, [this] { m_modeEdited = true; });
    m_altitude = new AltitudeBox(this);
    m_altitude->setObjectName(QStringLiteral("takeOffAltitude"));
    m_altitude->setMetres(commands.takeOffAltitude());
    connect(m_altitude, &AltitudeBox::metresChanged, &commands, &VehicleCommands::setTakeOffAltitude);
    connect(&commands, &VehicleCommands::takeOffAltitudeChanged, m_altitude, &AltitudeBox::setMetres);
    m_result = new ResultLabel(this);
    m_result->setObjectName(QStringLiteral("commandResult"));
    m_result->setAccessibleName(tr("Result of the last command"));

    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(kGrid, kHalfGrid, kGrid, kGrid);
    grid->setSpacing(kHalfGrid);
    for (int column = 0; column < 6; ++column)
        grid->setColumnStretch(column, 1);
    grid->addWidget(m_arm, 0, 0, 1, 2);
    grid->addWidget(m_land, 0, 2, 1, 2);
    grid->addWidget(m_return, 0, 4, 1, 2);
    grid->addWidget(m_altitude, 1, 0, 1, 3);
    grid->addWidget(m_takeOff, 1, 3, 1, 3);
    grid->addWidget(m_modes, 2, 0, 1, 3);
    grid->addWidget(m_setMode, 2, 3, 1, 3);
    grid->addWidget(m_result, 3, 0, 1, 6);

    const auto send = [this](const vehicle::VehicleCommand &command) { m_commands.send(m_systemId, command); };
    connect(m_arm, &HoldButton::confirmed, this, [this, send] {
        send(m_armed ? vehicle::VehicleCommand(vehicle::Disarm{}) : vehicle::VehicleCommand(vehicle::Arm{}));
    });
    connect(m_takeOff, &HoldButton::confirmed, this, [this, send] { send(vehicle::TakeOff{m_altitude->metres()}); });
    connect(m_land, &HoldButton::confirmed, this, [send] { send(vehicle::Land{}); });
    connect(m_return, &HoldButton::confirmed, this, [send] { send(vehicle::ReturnToLaunch{}); });
    connect(m_setMode, &HoldButton::confirmed, this,
            [this, send] { send(vehicle::SetMode{m_modes->currentText().toStdString()}); });
    for (HoldButton *button : {m_arm, m_takeOff, m_land, m_return, m_setMode})
        connect(button, &HoldButton::aborted, this, [this] { say(tr("Not sent: hold the button to confirm"), true); });
    connect(&commands, &VehicleCommands::resultReported, this, &VehicleActions::say);
    showViewState({});
}

void VehicleActions::showViewState(const ViewState &view)
{
    const bool present = view.vehicle != nullptr;
    const std::uint8_t systemId = present ? view.vehicle->state.systemId : 0;
    if (systemId != m_systemId && m_systemId != 0)
        say({}, true); // the result was that of another vehicle
    if (systemId != m_systemId)
        endHolds({m_arm, m_takeOff, m_land, m_return, m_setMode}, tr("another vehicle is selected"));
    m_modeEdited = m_modeEdited && systemId == m_systemId;
    m_systemId = systemId;
    m_armed = present && view.vehicle->state.armed;
    const QString word = m_armed ? tr("Disarm") : tr("Arm");
    if (m_arm->text() != word) {
        endHolds({m_arm}, m_armed ? tr("the vehicle has been armed") : tr("the vehicle has been disarmed"));
        m_arm->setText(word);
        m_arm->setAccessibleName(word);
    }
    if (present)
        showModes(view.vehicle->state.modes, view.vehicle->state.mode);
    else
        showModes({}, {});
    showPermit(view);
}

void VehicleActions::endHolds(const std::vector<HoldButton *> &buttons, const QString &why)
{
    for (HoldButton *button : buttons) {
        if (!button->isHeld())
            continue;
        button->abort();
        say(tr("Not sent: %1").arg(why), false);
    }
}

void VehicleActions::showPermit(const ViewState &view)
{
    const QString reason = commandsDisabledReason(view);
    for (HoldButton *button : {m_arm, m_takeOff, m_land, m_return})
        button->setDisabledReason(nothingCanBeSent(reason));
    const bool noModes = reason.isEmpty() && m_knownModes.empty();
    m_setMode->setDisabledReason(noModes ? tr("The modes of this vehicle are not known") : nothingCanBeSent(reason));
    m_altitude->setEnabled(reason.isEmpty());
    m_modes->setEnabled(m_setMode->isEnabled());
    // Without a vehicle, the line stays empty.
    const QString line = view.vehicle ? nothingCanBeSent(reason) : QString();
    if (line == m_disabledReason)
        return;
    if (!line.isEmpty())
        say(line, false);
    else if (m_result->text() == m_disabledReason)
        say({}, true);
    m_disabledReason = line;
}

void VehicleActions::showModes(const std::vector<std::string> &modes, const std::string &current)
{
    const QSignalBlocker quiet(m_modes); // the signal is for changes of the operator
    if (modes != m_knownModes) {
        endHolds({m_setMode}, tr("the vehicle's modes have changed"));
        m_knownModes = modes;
        m_modes->clear();
        for (const std::string &mode : modes)
            m_modes->addItem(fromStd(mode));
        m_modes->setCurrentIndex(modes.empty() ? -1 : 0);
        m_modeEdited = false;
    }
    const int inUse = m_modes->findText(fromStd(current));
    if (inUse == m_modes->currentIndex())
        m_modeEdited = false;
    else if (inUse >= 0 && !m_modeEdited && !m_setMode->isHeld())
        m_modes->setCurrentIndex(inUse);
}

void VehicleActions::setUnits(UnitSystem units)
{
    m_altitude->setUnits(units);
}

void VehicleActions::say(const QString &line, bool ok)
{
    m_result->showResult(line);
    QPalette colors = palette();
    if (!ok)
        colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_result->setPalette(colors);
}

} // namespace skyseal::ui
