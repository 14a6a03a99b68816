#include "ui/vehicles/vehicle_list_row.h"

#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/engine/text/state_text.h"
#include "core/engine/text/system_text.h"
#include "ui/text/lock_face.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

using engine::Security;

namespace {

/// The translation context of the functions below.
struct VehicleListRowText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::VehicleListRow)
};

constexpr double kUnknownLast = 1e9; ///< the rank of a figure that is not known
constexpr double kPoorPercent = 90;  ///< of the frames that arrive, as in the status strip

VehicleListCell nameCell(const ViewState &view)
{
    const int id = view.vehicle->state.systemId;
    const QString peer = view.session ? fromStd(view.session->info.peerName) : QString();
    VehicleListCell cell{.text = peer.isEmpty() ? QString::number(id) : QStringLiteral("%1 · %2").arg(id).arg(peer),
                         .rank = double(id)};
    cell.tip = peer.isEmpty() ? VehicleListRowText::tr("Vehicle %1").arg(id)
                              : VehicleListRowText::tr("Vehicle %1, agent %2").arg(id).arg(peer);
    return cell;
}

/// The tip names the firmware, and the other components of the system.
VehicleListCell kindCell(const vehicle::VehicleState &state)
{
    QStringList tip;
    if (!state.firmware.empty())
        tip << fromStd(state.firmware);
    for (const vehicle::Component &component : state.components)
        tip << engine::componentText(component);
    return {.text = engine::vehicleTypeText(state.type), .tip = tip.join(QLatin1Char('\n'))};
}

VehicleListCell batteryCell(const vehicle::VehicleState &state)
{
    const bool known = std::isfinite(state.batteryPercent);
    const bool low = state.batteryPercent <= kLowBatteryPercent;
    const QString percent = number(state.batteryPercent, 0) + QStringLiteral(" %");
    return {.text = !known ? dash()
                : low      ? VehicleListRowText::tr("%1 · low").arg(percent)
                           : percent,
            .tone = low ? CellTone::Alarm : CellTone::Usual,
            .tip = VehicleListRowText::tr("%1 V").arg(number(state.batteryVoltage, 1)),
            .rank = known ? std::round(state.batteryPercent) : kUnknownLast};
}

bool isLost(const ViewState &view)
{
    return view.vehicle->state.lost || view.stale() || (!view.session && view.vehicle->session);
}

VehicleListCell linkCell(const ViewState &view)
{
    if (isLost(view))
        return {.text = VehicleListRowText::tr("lost"),
                .tone = CellTone::Alarm,
                .tip = VehicleListRowText::tr("No frames received"),
                .rank = -1};
    const double arrived = 100 - (view.session ? view.session->lossPercent : view.vehicle->lossPercent);
    const QString percent = number(arrived, 0) + QStringLiteral(" %");
    const bool poor = arrived < kPoorPercent;
    return {.text = poor ? VehicleListRowText::tr("%1 · poor").arg(percent) : percent,
            .tone = poor ? CellTone::Warning : CellTone::Usual,
            .tip = VehicleListRowText::tr("Share of the frames that arrived within the last second"),
            .rank = std::round(arrived)};
}

/// In whole seconds, so that it stands still while frames arrive.
VehicleListCell ageCell(const ViewState &view)
{
    const double age = view.vehicle->state.messageAge;
    return {.text = !std::isfinite(age) ? dash()
                : age < 1               ? VehicleListRowText::tr("< 1 s")
                : age < 60              ? VehicleListRowText::tr("%1 s").arg(std::floor(age))
                                        : durationText(age),
            .tone = view.stale() ? CellTone::Alarm : CellTone::Usual,
            .tip = VehicleListRowText::tr("Since the newest frame"),
            .rank = std::isfinite(age) ? std::floor(age) : kUnknownLast};
}

VehicleListCell lockCell(const ViewState &view)
{
    const LockFace face = lockFaceOf(view);
    const QString brief = face.variants.last(); // the suite, or what there is in place of a session
    VehicleListCell cell{.text = brief, .tip = face.toolTip, .icon = face.icon, .rank = double(face.security)};
    switch (face.security) {
    case Security::Sealed: cell.text = VehicleListRowText::tr("Sealed · %1").arg(brief); break;
    case Security::UnderAttack:
        cell.text = VehicleListRowText::tr("Under attack · %1").arg(brief);
        cell.tone = CellTone::Alarm;
        break;
    case Security::Plain: cell.tone = CellTone::Warning; break;
    case Security::Nothing: cell.tone = face.lost ? CellTone::Warning : CellTone::Dim; break;
    case Security::Switching: break;
    }
    return cell;
}

/// How many there are, and how grave the gravest is.
VehicleListCell alertsCell(std::uint8_t systemId, std::span<const Alert> alerts)
{
    int count = 0;
    AlertSeverity gravest{};
    QStringList texts;
    for (const Alert &alert : alerts) {
        if (alert.id.systemId != systemId)
            continue;
        ++count;
        gravest = std::max(gravest, alert.severity);
        texts << alert.text;
    }
    if (count == 0)
        return {.text = dash(), .tone = CellTone::Dim, .tip = VehicleListRowText::tr("No alerts")};
    const QString word = gravest == AlertSeverity::Severe ? VehicleListRowText::tr("severe")
        : gravest == AlertSeverity::Warning               ? VehicleListRowText::tr("warning")
                                                          : VehicleListRowText::tr("notice");
    return {.text = QStringLiteral("%1 · %2").arg(count).arg(word),
            .tone = gravest == AlertSeverity::Severe ? CellTone::Alarm
                : gravest == AlertSeverity::Warning  ? CellTone::Warning
                                                     : CellTone::Usual,
            .tip = texts.join(QLatin1Char('\n')),
            .rank = 1000.0 * double(gravest) + count};
}

} // namespace

VehicleListRow vehicleListRowOf(const ViewState &view, std::span<const Alert> alerts)
{
    using enum VehicleListRow::Column;
    const vehicle::VehicleState &state = view.vehicle->state;
    VehicleListRow row{.systemId = state.systemId, .cells = {}};
    row[Vehicle] = nameCell(view);
    row[Kind] = kindCell(state);
    row[Mode] = {.text = state.mode.empty() ? dash() : fromStd(state.mode)};
    row[Armed] = {.text = state.armed ? VehicleListRowText::tr("Armed") : VehicleListRowText::tr("Disarmed"),
                  .tone = state.armed ? CellTone::Alarm : CellTone::Usual,
                  .rank = state.armed ? 0.0 : 1.0};
    row[Battery] = batteryCell(state);
    if (view.stale()) // these values are old, and the link and its age say so
        for (const auto column : {Kind, Mode, Armed, Battery})
            row[column].tone = CellTone::Dim;
    row[Link] = linkCell(view);
    row[LastFrame] = ageCell(view);
    row[Lock] = lockCell(view);
    row[Alerts] = alertsCell(state.systemId, alerts);
    return row;
}

} // namespace skyseal::ui
