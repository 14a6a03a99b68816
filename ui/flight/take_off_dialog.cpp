#include "ui/flight/take_off_dialog.h"

#include "ui/flight/altitude_box.h"
#include "ui/text/command_permits.h"
#include "ui/flight/hold_button.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

TakeOffDialog::TakeOffDialog(VehicleCommands &commands, UnitSystem units, QWidget *parent) : QDialog(parent)
{
    setObjectName(QStringLiteral("takeOffDialog"));
    const std::uint8_t systemId = commands.systemId();
    setWindowTitle(commands.isOneOfSeveral() ? tr("Take off · vehicle %1").arg(systemId) : tr("Take off"));
    auto *altitude = new AltitudeBox(this);
    altitude->setObjectName(QStringLiteral("takeOffDialogAltitude"));
    altitude->setUnits(units);
    altitude->setMetres(commands.takeOffAltitude());
    auto *hint = new QLabel(tr("Hold the button for half a second. The propellers speed up and the vehicle climbs."), this);
    hint->setWordWrap(true);
    hint->setForegroundRole(QPalette::PlaceholderText);
    auto *go = new HoldButton(tr("Take off"), this);
    go->setObjectName(QStringLiteral("takeOffDialogGo"));
    go->setAccessibleName(go->text());
    auto *cancel = new QPushButton(tr("Cancel"), this);
    cancel->setAccessibleName(cancel->text());
    for (QPushButton *button : std::initializer_list<QPushButton *>{go, cancel}) {
        button->setAutoDefault(false); // Enter in the field must not start the take-off
        button->setMinimumWidth(12 * kGrid);
    }

    auto *form = new QFormLayout;
    form->addRow(tr("&Altitude above home"), altitude);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(kGrid);
    buttons->addStretch(1);
    buttons->addWidget(go);
    buttons->addWidget(cancel);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addLayout(form);
    column->addWidget(hint);
    column->addSpacing(kGrid);
    column->addLayout(buttons);
    setMinimumWidth(44 * kGrid);

    const auto permit = [go](const QString &reason) { go->setDisabledReason(nothingCanBeSent(reason)); };
    permit(commands.disabledReason());
    connect(&commands, &VehicleCommands::disabledReasonChanged, go, permit);
    connect(go, &HoldButton::confirmed, this, [this, &commands, altitude, systemId] {
        commands.setTakeOffAltitude(altitude->metres());
        commands.send(systemId, vehicle::TakeOff{altitude->metres()});
        accept();
    });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    altitude->setFocus();
    altitude->selectAll();
}

} // namespace skyseal::ui
