#include "ui/text/command_permits.h"

#include "core/engine/station/snapshot.h"
#include "core/vehicle/flight_rules.h"
#include "ui/text/link_ended.h"
#include "ui/text/one_way.h"

#include <QtCore/QCoreApplication>

#include <cmath>

namespace skyseal::ui {

namespace {

struct CommandPermitsText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::CommandPermits)
};

} // namespace

QString commandsDisabledReason(const ViewState &view)
{
    if (view.isReplay())
        return CommandPermitsText::tr("a replay is shown");
    if (view.pendingApproval && !view.session)
        return CommandPermitsText::tr("it is not sealed, and plain MAVLink is not allowed");
    if (!view.vehicle)
        return CommandPermitsText::tr("no vehicle");
    if (const auto oneWay = oneWayOf(view))
        return oneWay->disabledReason;
    const auto ended = linkEndedOf(view);
    return ended ? ended->title : QString();
}

QString movesDisabledReason(const ViewState &view)
{
    QString reason = commandsDisabledReason(view);
    if (!reason.isEmpty())
        return reason;
    const vehicle::VehicleState &state = view.vehicle->state;
    if (!state.armed)
        return CommandPermitsText::tr("the vehicle is disarmed");
    return state.position.known() && std::isfinite(state.altitudeRelative)
        ? QString()
        : CommandPermitsText::tr("its position is not known");
}

QString climbsDisabledReason(const ViewState &view)
{
    QString reason = movesDisabledReason(view);
    if (!reason.isEmpty())
        return reason;
    return vehicle::rulesOf(view.vehicle->state).flies ? QString()
                                                       : CommandPermitsText::tr("this kind of vehicle does not fly");
}

QString nothingCanBeSent(const QString &reason)
{
    return reason.isEmpty() ? QString() : CommandPermitsText::tr("Nothing can be sent: %1").arg(reason);
}

QString demoDisabledReason(const ViewState &view)
{
    const SnapshotPtr &station = view.station();
    if (view.isReplay())
        return CommandPermitsText::tr("A replay is shown");
    if (!station)
        return {};
    if (!station->vehicles.empty() || !station->pendingApproval.empty())
        return CommandPermitsText::tr("A vehicle is connected: the demo would end its link");
    if (!station->sessions.empty())
        return CommandPermitsText::tr("A link is sealed: the demo would end it");
    return {};
}

} // namespace skyseal::ui
