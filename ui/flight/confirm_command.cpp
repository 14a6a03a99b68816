#include "ui/flight/confirm_command.h"

#include "ui/confirm_box.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ConfirmCommand)
};

} // namespace

QMessageBox *confirmCommand(VehicleCommands &commands, const vehicle::VehicleCommand &command, const QString &question,
                            const QString &details, QWidget *window)
{
    const std::uint8_t systemId = commands.systemId();
    const QString text = commands.isOneOfSeveral() ? Text::tr("Vehicle %1: %2").arg(systemId).arg(question) : question;
    return askToConfirm({.objectName = QStringLiteral("confirmCommand"),
                         .title = Text::tr("Confirm"),
                         .text = text,
                         .details = details,
                         .yes = commandText(command)},
                        window, &commands, [&commands, systemId, command] { commands.send(systemId, command); });
}

} // namespace skyseal::ui
