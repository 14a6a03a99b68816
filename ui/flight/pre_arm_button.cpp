#include "ui/flight/pre_arm_button.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/flight/pre_arm_dialog.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/modeless.h"
#include "ui/text/pre_arm_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

namespace skyseal::ui {

PreArmButton::PreArmButton(VehicleCommands &commands, QWidget *parent) : QPushButton(parent), m_commands(commands)
{
    setObjectName(QStringLiteral("preArmButton"));
    setAutoDefault(false);
    connect(this, &QPushButton::clicked, this, &PreArmButton::openList);
    showViewState({});
}

QString PreArmButton::lines(QString text, bool onTwoLines)
{
    return onTwoLines ? text.replace(QStringLiteral(": "), QStringLiteral(":\n")) : text;
}

int PreArmButton::leastWidth(bool onTwoLines) const
{
    return fontMetrics().size(0, lines(widestPreArmText(), onTwoLines)).width() + 2 * kGrid;
}

void PreArmButton::setOnTwoLines(bool on)
{
    m_onTwoLines = on;
    showViewState(m_view);
}

void PreArmButton::showViewState(const ViewState &view)
{
    if (&view != &m_view)
        m_view = view;
    const QString text = preArmText(view), shown = lines(text, m_onTwoLines);
    if (this->text() != shown) {
        setText(shown);
        setAccessibleName(text);
    }
    const auto open = view.vehicle && !view.isReplay() ? m_commands.preflight().open(view.vehicle->state.systemId).size() : 0;
    const QString list = open == 0 ? tr("Opens the list of failures and the checklist.")
                                   : tr("%1 open on the checklist. Opens the checklist and the list of failures.").arg(open);
    const QString tip = preArmSentence(view) + QLatin1Char('\n') + list;
    if (toolTip() != tip)
        setToolTip(tip);
    const StateColors &colors = stateColors(palette());
    const PreArm state = preArmOf(view);
    QPalette own;
    if (state == PreArm::Refused)
        own.setColor(QPalette::ButtonText, colors.warning);
    else if (state == PreArm::Ok)
        own.setColor(QPalette::ButtonText, colors.good);
    else if (state == PreArm::Unknown)
        own.setColor(QPalette::ButtonText, colors.dim);
    setPalette(own);
    Q_EMIT viewChanged(view);
}

void PreArmButton::openList()
{
    if (raiseOpen<PreArmDialog>(*window()))
        return;
    auto *dialog = new PreArmDialog(m_commands, window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(this, &PreArmButton::viewChanged, dialog, &PreArmDialog::showViewState);
    dialog->showViewState(m_view);
    showModeless(*dialog);
}

} // namespace skyseal::ui

#include "moc_pre_arm_button.cpp"
