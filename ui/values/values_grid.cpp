#include "ui/values/values_grid.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/theme/form_pieces.h"
#include "ui/theme/grid.h"
#include "ui/values/cell_area.h"
#include "ui/values/value_cell.h"

#include <QtGui/QAction>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QToolButton>

namespace skyseal::ui {

ValuesGrid::ValuesGrid(QWidget *parent)
    : QWidget(parent), m_cells(new CellArea(this)), m_edit(new QAction(tr("Edit values…"), this))
{
    setObjectName(QStringLiteral("valuesGrid"));
    connect(m_edit, &QAction::triggered, this, &ValuesGrid::editRequested);
    m_problem = named(smallPrint({}, this), "valuesProblem", tr("Problem with the stored values"));
    m_empty = named(smallPrint(tr("No values are chosen."), this), "valuesEmpty", tr("No values"));
    m_age = named(new QLabel(this), "valueAge", tr("Age of the values"));
    m_age->setForegroundRole(QPalette::PlaceholderText);
    auto *edit = named(new QToolButton(this), "editValues", tr("Edit values"));
    edit->setDefaultAction(m_edit);
    edit->setAutoRaise(true);
    edit->setFocusPolicy(Qt::StrongFocus);
    edit->setToolTip(tr("Choose the values shown here, their limits and their lines"));

    auto *foot = new QHBoxLayout;
    foot->addWidget(m_age, 1);
    foot->addWidget(edit);
    foot->setContentsMargins(kGrid, 0, kHalfGrid, 0);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, kHalfGrid, 0, kHalfGrid);
    column->setSpacing(kHalfGrid);
    column->addWidget(m_problem);
    column->addWidget(m_empty);
    column->addWidget(m_cells, 1);
    column->addLayout(foot);
    for (QLabel *label : {m_problem, m_empty})
        label->setContentsMargins(kGrid, 0, kGrid, 0);
    setValues({});
}

void ValuesGrid::setValues(const ChosenValues &values)
{
    m_problem->setVisible(!values.problem.isEmpty());
    m_problem->setText(tr("The stored values cannot be read (%1). These are the defaults.").arg(values.problem));
    m_empty->setVisible(values.list.empty());
    if (values == m_values && m_cells->cells().size() == values.list.size())
        return; // the lines stay
    m_values = values;
    m_cells->setChoices(values.list);
    showViewState({});
}

void ValuesGrid::onSnapshot(const ViewState &view)
{
    const std::pair shown(view.vehicle ? view.vehicle->state.systemId : -1, view.isReplay());
    for (ValueCell *cell : m_cells->cells()) {
        if (!cell->choice().line)
            continue;
        if (shown != m_lineOf)
            cell->clearLine();
        if (view.vehicle)
            cell->addSample(view.time(), readValue(cell->choice().source, view));
    }
    m_lineOf = shown;
}

void ValuesGrid::showViewState(const ViewState &view)
{
    for (ValueCell *cell : m_cells->cells())
        cell->showReading(readValue(cell->choice().source, view), m_units);
    const QString age = view.stale() ? tr("Last heard %1 ago").arg(durationText(view.vehicle->state.messageAge)) : QString();
    if (m_age->text() != age)
        m_age->setText(age);
}

} // namespace skyseal::ui

#include "moc_values_grid.cpp"
