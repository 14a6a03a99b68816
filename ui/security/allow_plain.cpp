#include "ui/security/allow_plain.h"

#include "core/engine/text/state_text.h"
#include "ui/station_interface.h"
#include "ui/text/state_text.h"

#include <QtCore/QCoreApplication>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

namespace skyseal::ui {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::AllowPlain)
};

} // namespace

QString allowPlainText(const engine::PendingVehicle &held)
{
    return Text::tr("Allow plain MAVLink for vehicle %1 …").arg(held.systemId);
}

void askAllowPlain(StationInterface &station, const engine::PendingVehicle &held, QWidget *parent)
{
    const QString question = Text::tr("Take vehicle %1 without a seal?").arg(held.systemId);
    auto *box = new QMessageBox(QMessageBox::Warning, Text::tr("Plain MAVLink"), question,
                                QMessageBox::Yes | QMessageBox::Cancel, parent);
    box->setObjectName(QStringLiteral("confirmPlain"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    // The consent is for the number alone: an address is no more proof than the number is.
    box->setInformativeText(
        Text::tr("It now sends from %2. But whoever says in clear that it is vehicle %1, from any address, is then shown "
                 "and flown as it, until this program ends or it is heard sealed. Anyone on the way can read and change "
                 "what is sent.\n\n"
                 "If this should be the vehicle of %3, say no: its sealed link is broken or being blocked.")
            .arg(held.systemId)
            .arg(fromStd(held.remoteAddress), engine::anyOfNames(held.mayBe)));
    box->setDefaultButton(QMessageBox::Cancel);
    box->setEscapeButton(QMessageBox::Cancel);
    box->button(QMessageBox::Yes)->setText(Text::tr("Allow plain MAVLink"));
    QObject::connect(box, &QMessageBox::finished, &station, [&station, systemId = held.systemId](int result) {
        if (result == QMessageBox::Yes)
            station.allowPlaintext(systemId);
    });
    box->open();
}

} // namespace skyseal::ui
