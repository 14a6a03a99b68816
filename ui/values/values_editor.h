// The dialog that chooses the values of the grid: their sources, captions, decimals, limits and lines. Modeless; changes take
// effect by Apply or OK.
#pragma once

#include "ui/value_choice.h"

#include <QtWidgets/QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QTreeView;
class QVBoxLayout;

namespace skyseal::ui {

class SourceModel;

class ValuesEditor : public QDialog
{
    Q_OBJECT

public:
    /// Limits are shown and entered in `units`.
    ValuesEditor(const ValueChoices &choices, UnitSystem units, QWidget *parent = nullptr);

Q_SIGNALS:
    void applied(const skyseal::ui::ValueChoices &choices);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeChosen();
    QWidget *makeDetails();
    QWidget *makeFinder();
    QWidget *makeButtons();
    void fillList(int current);
    void showDetails();
    void editCurrent(const std::function<void(ValueChoice &)> &change);
    void readLimits();
    void addFound();
    void useFound();
    void removeCurrent();
    void moveCurrent(int by);
    const ValueSource *found() const;
    ValueChoice *current();
    void updateButtons();
    static QString itemText(const ValueChoice &choice);

    ValueChoices m_choices;
    const UnitSystem m_units;
    SourceModel *m_sources;
    QListWidget *m_list;
    QLabel *m_source, *m_lowUnit, *m_highUnit, *m_problem;
    QLineEdit *m_caption, *m_unit, *m_low, *m_high, *m_find;
    QSpinBox *m_element, *m_decimals;
    QCheckBox *m_line;
    QTreeView *m_found;
    QPushButton *m_add, *m_use, *m_remove, *m_up, *m_down, *m_apply, *m_ok;
    bool m_filling = false; ///< the fields show another value; nothing is edited
};

} // namespace skyseal::ui
