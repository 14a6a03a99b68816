#include "ui/flight/confirm_command.h"

#include "ui/confirm_box.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/modeless.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct ConfirmCommandText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ConfirmCommand)
};

const QString kQuestion = QStringLiteral("confirmCommand");
constexpr const char *kVehicle = "skyseal_vehicle"; ///< property of a question: the system ID of its vehicle

} // namespace

QMessageBox *confirmCommand(VehicleCommands &commands, const vehicle::VehicleCommand &command, const QString &question,
                            const QString &details, QWidget *window)
{
    const std::uint8_t systemId = commands.systemId();
    const QString text = commands.isOneOfSeveral() ? ConfirmCommandText::tr("Vehicle %1: %2").arg(systemId).arg(question)
                                                   : question;
    QMessageBox *open = openQuestion(*window, kQuestion);
    if (open && open->text() == text && open->property(kVehicle).toInt() == systemId) { // as by a key that is held
        open->setInformativeText(details);
        showModeless(*open);
        return open;
    }
    QMessageBox *box = askToConfirm({.objectName = kQuestion,
                                     .title = ConfirmCommandText::tr("Confirm"),
                                     .text = text,
                                     .details = details,
                                     .yes = commandText(command, commands.units())},
                                    window, &commands, [&commands, systemId, command] { commands.send(systemId, command); });
    box->setProperty(kVehicle, int{systemId});
    return box;
}

QString openItemsText(VehicleCommands &commands)
{
    constexpr int kNamed = 5;
    const QStringList open = commands.preflight().open(commands.systemId());
    if (open.isEmpty())
        return {};
    QStringList lines = open.mid(0, kNamed);
    if (open.size() > kNamed)
        lines << ConfirmCommandText::tr("and %1 more").arg(open.size() - kNamed);
    return ConfirmCommandText::tr("Not done on the checklist:") + QStringLiteral("\n• ") + lines.join(QStringLiteral("\n• "));
}

void sendOrAsk(VehicleCommands &commands, std::uint8_t systemId, const vehicle::VehicleCommand &command, QWidget *window)
{
    const bool arms = std::holds_alternative<vehicle::Arm>(command) || commands.armsFirst(command);
    const QString open = arms && systemId == commands.systemId() ? openItemsText(commands) : QString();
    if (open.isEmpty())
        return commands.send(systemId, command);
    confirmCommand(commands, command, ConfirmCommandText::tr("Arm with an incomplete checklist?"), open, window);
}

} // namespace skyseal::ui
