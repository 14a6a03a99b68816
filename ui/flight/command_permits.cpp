#include "ui/flight/command_permits.h"

#include "ui/status/link_ended.h"
#include "ui/status/one_way.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::CommandPermits)
};

} // namespace

QString whyNoCommands(const ViewState &view)
{
    if (view.pendingApproval && !view.session)
        return Words::tr("it is not sealed, and plain MAVLink is not allowed");
    if (!view.vehicle)
        return Words::tr("no vehicle");
    if (const auto oneWay = oneWayOf(view))
        return oneWay->whyNot;
    const auto ended = linkEndedOf(view);
    return ended ? ended->title : QString();
}

QString nothingCanBeSent(const QString &reason)
{
    return reason.isEmpty() ? QString() : Words::tr("Nothing can be sent: %1").arg(reason);
}

} // namespace skyseal::ui
