#include "ui/flight/altitude_dialog.h"

#include "ui/flight/altitude_box.h"
#include "ui/flight/hold_button.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/text/command_permits.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

AltitudeDialog::AltitudeDialog(VehicleCommands &commands, UnitSystem units, double metres, const Wording &wording,
                               QWidget *parent)
    : QDialog(parent)
{
    setObjectName(wording.id);
    const std::uint8_t systemId = commands.systemId();
    setWindowTitle(commands.isOneOfSeveral() ? tr("%1 · vehicle %2").arg(wording.title).arg(systemId) : wording.title);
    auto *altitude = new AltitudeBox(this);
    altitude->setObjectName(wording.id + QStringLiteral("Altitude"));
    altitude->setAccessibleName(tr("Altitude above home"));
    altitude->setUnits(units);
    altitude->setHighest(wording.highest);
    altitude->setMetres(metres);
    auto *hint = new QLabel(wording.hint, this);
    hint->setObjectName(wording.id + QStringLiteral("Hint"));
    hint->setWordWrap(true);
    hint->setForegroundRole(QPalette::PlaceholderText);
    auto *go = new HoldButton(wording.verb, this);
    go->setObjectName(wording.id + QStringLiteral("Go"));
    go->setAccessibleName(go->text());
    auto *cancel = new QPushButton(tr("Cancel"), this);
    cancel->setAccessibleName(cancel->text());
    for (QPushButton *button : std::initializer_list<QPushButton *>{go, cancel}) {
        button->setAutoDefault(false); // Enter in the field must not send the command
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

    const auto permit = [go, hint, wording, systemId, &commands] {
        QString reason = nothingCanBeSent(commands.disabledReason());
        if (reason.isEmpty() && commands.systemId() != systemId)
            reason = tr("Not now: vehicle %1 is no longer selected").arg(systemId);
        else if (reason.isEmpty() && wording.permit)
            reason = commands.disabledReason(*wording.permit);
        go->setDisabledReason(reason);
        const bool arms = wording.permit && commands.systemId() == systemId && commands.armsFirst(*wording.permit);
        if (const QString verb = arms ? wording.armingVerb : wording.verb; go->text() != verb) {
            go->abort(); // it was held for something else
            go->setCommand(verb, verb);
        }
        const QString text = !reason.isEmpty() ? reason : arms ? wording.armingHint : wording.hint;
        if (hint->text() != text)
            hint->setText(text);
    };
    permit();
    connect(&commands, &VehicleCommands::permitsChanged, go, permit);
    connect(go, &HoldButton::confirmed, this, [this, &commands, altitude, systemId] {
        command(commands, systemId, altitude->metres());
        accept();
    });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    altitude->setFocus();
    altitude->selectAll();
}

} // namespace skyseal::ui

#include "moc_altitude_dialog.cpp"
