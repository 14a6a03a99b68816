#include "ui/values/cell_area.h"

#include "ui/theme/grid.h"
#include "ui/values/value_cell.h"

#include <QtCore/QEvent>
#include <QtGui/QFontInfo>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr int kFewestColumns = 2;      ///< if there are as many values: what a dock of the usual width has
constexpr int kGreatestDigits = 3;     ///< times the font of the window
constexpr int kDigitsInWidth = 5;      ///< the greatest digits leave room for a number like 888.8 m/s in a cell
constexpr int kGreatestCellHeight = 5; ///< times the font of the window, without the line

} // namespace

CellArea::CellArea(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CellArea::setChoices(const ValueChoices &choices)
{
    for (ValueCell *cell : m_cells)
        delete cell;
    m_cells.clear();
    for (const ValueChoice &choice : choices) {
        m_cells.push_back(new ValueCell(choice, this));
        m_cells.back()->show();
    }
    place();
    updateGeometry();
}

QSize CellArea::smallestCell() const
{
    QSize out(0, 0);
    for (const ValueCell *cell : m_cells)
        out = out.expandedTo(cell->minimumSizeHint());
    return out;
}

int CellArea::rows() const
{
    return (static_cast<int>(m_cells.size()) + m_columns - 1) / m_columns;
}

QSize CellArea::minimumSizeHint() const
{
    const QSize cell = smallestCell();
    return {std::min<int>(static_cast<int>(m_cells.size()), kFewestColumns) * cell.width(),
            rows() * cell.height() + allLineRoom()};
}

int CellArea::lineRoom(int row) const
{
    const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns);
    const std::size_t end = std::min(m_cells.size(), first + static_cast<std::size_t>(m_columns));
    for (std::size_t i = first; i < end; ++i) {
        if (m_cells[i]->choice().line)
            return ValueCell::kLineHeight;
    }
    return 0;
}

int CellArea::allLineRoom() const
{
    int sum = 0;
    for (int row = 0; row < rows(); ++row)
        sum += lineRoom(row);
    return sum;
}

void CellArea::place()
{
    if (m_cells.empty())
        return;
    const QSize least = smallestCell();
    const int columns = std::clamp(width() / std::max(1, least.width()), 1, static_cast<int>(m_cells.size()));
    if (columns != m_columns) {
        m_columns = columns;
        updateGeometry();
    }
    const int font = QFontInfo(this->font()).pixelSize();
    const int lines = allLineRoom();
    const int greatest = std::max(least.height(), kGreatestCellHeight * font);
    setMaximumHeight(rows() * greatest + lines);
    const int cellHeight = std::clamp((height() - lines) / rows(), least.height(), greatest);
    const int cellWidth = width() / m_columns;
    const int digitRoom = cellHeight - m_cells.front()->captionHeight() - kHalfGrid;
    const int digits = std::clamp(std::min(digitRoom * 4 / 5, (cellWidth - 2 * kGrid) / kDigitsInWidth), font,
                                  kGreatestDigits * font);
    int top = 0;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const int column = static_cast<int>(i) % m_columns, line = lineRoom(static_cast<int>(i) / m_columns);
        m_cells[i]->setRoom(digits, line);
        m_cells[i]->setGeometry(column * cellWidth, top, cellWidth, cellHeight + line);
        if (column == m_columns - 1)
            top += cellHeight + line;
    }
}

void CellArea::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    place();
}

void CellArea::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        place();
        updateGeometry();
    }
}

} // namespace skyseal::ui

#include "moc_cell_area.cpp"
