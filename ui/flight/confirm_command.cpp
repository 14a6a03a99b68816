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

QString openItemsText(VehicleCommands &commands)
{
    constexpr int kNamed = 5;
    const QStringList open = commands.preflight().open(commands.systemId());
    if (open.isEmpty())
        return {};
    QStringList lines = open.mid(0, kNamed);
    if (open.size() > kNamed)
        lines << Text::tr("and %1 more").arg(open.size() - kNamed);
    return Text::tr("Not done on the checklist:") + QStringLiteral("\n• ") + lines.join(QStringLiteral("\n• "));
}

void armOrAsk(VehicleCommands &commands, QWidget *window)
{
    const QString open = openItemsText(commands);
    if (open.isEmpty())
        return commands.send(commands.systemId(), vehicle::Arm{});
    if (window->findChild<QMessageBox *>(QStringLiteral("confirmCommand"))
        == nullptr) // else one is open, and is answered first
        confirmCommand(commands, vehicle::Arm{}, Text::tr("Arm although the checklist is not done?"), open, window);
}

} // namespace skyseal::ui
