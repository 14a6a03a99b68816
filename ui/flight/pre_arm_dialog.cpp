#include "ui/flight/pre_arm_dialog.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/vehicle/flight_modes.h"
#include "ui/command_guard.h"
#include "ui/flight/checklist_box.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/text/command_permits.h"
#include "ui/text/pre_arm_text.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

namespace skyseal::ui {

namespace {

/// Of ArduPilot, which answers with the texts of the checks that fail.
vehicle::RawCommand runChecks()
{
    return {.command = mavlink::MAV_CMD_RUN_PREARM_CHECKS};
}

} // namespace

PreArmDialog::PreArmDialog(VehicleCommands &commands, QWidget *parent)
    : QDialog(parent), m_state(smallPrint({}, this)),
      m_list(named(new QListWidget(this), "preArmList", tr("Pre-arm failures, with what to do"))),
      m_check(named(new QPushButton(tr("Check now"), this), "preArmCheck", tr("Run the pre-arm checks now"))),
      m_checklist(new ChecklistBox(commands.preflight(), this))
{
    setObjectName(QStringLiteral("preArmDialog"));
    m_state->setObjectName(QStringLiteral("preArmState"));
    m_list->setWordWrap(true);
    m_list->setTextElideMode(Qt::ElideNone);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setSelectionMode(QAbstractItemView::NoSelection);
    m_list->setSpacing(kHalfGrid / 2);
    new CommandGuard(*m_check);
    connect(m_check, &QPushButton::clicked, this, [this, &commands] { commands.send(m_systemId, runChecks()); });
    auto *close = named(new QPushButton(tr("Close"), this), "preArmClose", tr("Close"));
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    for (QPushButton *button : {m_check, close})
        button->setAutoDefault(false);

    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(kGrid);
    buttons->addWidget(m_check);
    buttons->addStretch(1);
    buttons->addWidget(close);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(m_state);
    column->addWidget(m_list, 1);
    column->addWidget(m_checklist, 1);
    column->addLayout(buttons);
    resize(60 * kGrid, 60 * kGrid);
    close->setFocus();
    showViewState({});
}

void PreArmDialog::showViewState(const ViewState &view)
{
    m_systemId = view.vehicle ? view.vehicle->state.systemId : 0;
    setWindowTitle(m_systemId == 0 ? tr("Pre-arm checks") : tr("Pre-arm checks · vehicle %1").arg(m_systemId));
    const QString sentence = preArmSentence(view);
    if (m_state->text() != sentence)
        m_state->setText(sentence);
    m_checklist->showViewState(view);
    QStringList lines;
    if (preArmOf(view) == PreArm::Refused) {
        for (const std::string &reason : view.vehicle->state.preArmReasons)
            lines << fromStd(reason) + QStringLiteral("\n→ ") + preArmRemedy(fromStd(reason));
    }
    for (int i = 0; i < lines.size(); ++i) {
        if (i == m_list->count())
            m_list->addItem(lines[i]);
        else if (m_list->item(i)->text() != lines[i])
            m_list->item(i)->setText(lines[i]);
    }
    while (m_list->count() > lines.size())
        delete m_list->takeItem(m_list->count() - 1);

    const QString nothing = nothingCanBeSent(commandsDisabledReason(view));
    const bool knows = view.vehicle
        && vehicle::VehicleKind{view.vehicle->state.type, view.vehicle->state.autopilot}.isArduPilot();
    const bool armed = view.vehicle && view.vehicle->state.armed;
    const QString reason = !nothing.isEmpty() ? nothing
        : !knows                              ? tr("This autopilot runs its checks automatically")
        : armed                               ? tr("The vehicle is armed")
                                              : QString();
    m_check->setEnabled(reason.isEmpty());
    m_check->setToolTip(reason.isEmpty() ? tr("Makes the vehicle run its checks now and report failures") : reason);
}

} // namespace skyseal::ui

#include "moc_pre_arm_dialog.cpp"
