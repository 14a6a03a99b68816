// The grid of the values that the operator has chosen, in as many columns as there is room for; digits grow with the cells.
// Below it stand the age of the vehicle's values and the button that opens the editor.
#pragma once

#include "ui/value_choice.h"
#include "ui/view_state.h"

#include <QtWidgets/QWidget>

#include <utility>

class QAction;
class QLabel;

namespace skyseal::ui {

class CellArea;

class ValuesGrid : public QWidget
{
    Q_OBJECT

public:
    explicit ValuesGrid(QWidget *parent = nullptr);

    void setValues(const ChosenValues &values);
    void setUnits(UnitSystem units) { m_units = units; }
    /// For each snapshot: only the lines of the last minute.
    void onSnapshot(const ViewState &view);
    void showViewState(const ViewState &view);
    /// Asks for the editor; for the button and context menus.
    QAction *editAction() { return m_edit; }

Q_SIGNALS:
    void editRequested();

private:
    CellArea *m_cells;
    QLabel *m_problem, *m_empty, *m_age;
    QAction *m_edit;
    ChosenValues m_values;
    UnitSystem m_units = UnitSystem::Metric;
    std::pair<int, bool> m_lineOf{-1, false}; ///< system id of the vehicle that the lines show, and whether it is replayed
};

} // namespace skyseal::ui
