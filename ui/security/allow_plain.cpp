#include "ui/security/allow_plain.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/engine/text/state_text.h"
#include "ui/confirm_box.h"
#include "ui/station_interface.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct AllowPlainText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::AllowPlain)
};

} // namespace

QString allowPlainText(const engine::PendingVehicle &held)
{
    return AllowPlainText::tr("Allow plain MAVLink for vehicle %1…").arg(held.systemId);
}

void askAllowPlain(StationInterface &station, const engine::PendingVehicle &held, QWidget *parent)
{
    // The consent is for the system id alone, because an address proves no more than the id does.
    askToConfirm(
        {.objectName = QStringLiteral("confirmPlain"),
         .title = AllowPlainText::tr("Plain MAVLink"),
         .text = AllowPlainText::tr("Accept plain MAVLink from vehicle %1?").arg(held.systemId),
         .details =
             AllowPlainText::tr(
                 "It currently sends from %2. If you allow it, any sender of plain MAVLink that claims to be vehicle %1, "
                 "from any address, is shown and commanded as that vehicle until this program ends or a sealed link to "
                 "the vehicle is up. Anyone on the path can read and change the traffic.\n\nIf this should be the "
                 "vehicle of %3, choose Cancel: its sealed link is broken or blocked.")
                 .arg(held.systemId)
                 .arg(fromStd(held.remoteAddress), engine::anyOfNames(held.mayBe)),
         .yes = AllowPlainText::tr("Allow plain MAVLink"),
         .icon = QMessageBox::Warning},
        parent, &station, [&station, systemId = held.systemId] { station.allowPlaintext(systemId); });
}

} // namespace skyseal::ui
