// Places the cells of the grid of values: rows of equal cells, the columns as many as fit.
#pragma once

#include "ui/value_choice.h"

#include <QtWidgets/QWidget>

#include <vector>

namespace skyseal::ui {

class ValueCell;

class CellArea : public QWidget
{
    Q_OBJECT

public:
    explicit CellArea(QWidget *parent = nullptr);

    /// Makes the cells anew.
    void setChoices(const ValueChoices &choices);
    const std::vector<ValueCell *> &cells() const { return m_cells; }
    int columns() const { return m_columns; }

    QSize sizeHint() const override { return minimumSizeHint(); }
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    QSize smallestCell() const;
    int rows() const;
    /// Height below the digits of a row that is kept for lines: none if no cell of the row has one.
    int lineRoom(int row) const;
    int allLineRoom() const;
    void place();

    std::vector<ValueCell *> m_cells;
    int m_columns = 2;
};

} // namespace skyseal::ui
