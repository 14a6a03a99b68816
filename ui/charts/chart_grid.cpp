#include "ui/charts/chart_grid.h"

#include "ui/theme/grid.h"

#include <QtWidgets/QGridLayout>

#include <algorithm>

namespace skyseal::ui {

namespace {
constexpr int kOneRow = 4;                          ///< charts that share one row if the width allows
constexpr int kLeastChart = 230, kUsualChart = 320; ///< pixels of a chart
} // namespace

ChartGrid::ChartGrid(QWidget *parent) : QScrollArea(parent)
{
    auto *sheet = new QWidget;
    m_grid = new QGridLayout(sheet);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(kGrid);
    setWidget(sheet);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
}

void ChartGrid::setCharts(const std::vector<QWidget *> &charts)
{
    for (QWidget *chart : m_charts)
        chart->hide();
    m_charts = charts;
    m_columns = 0;
    arrange();
    for (QWidget *chart : m_charts)
        chart->show();
}

void ChartGrid::arrange()
{
    const int count = static_cast<int>(m_charts.size());
    const int least = count <= kOneRow ? kLeastChart : kUsualChart;
    const int columns = std::clamp(viewport()->width() / least, 1, std::max(1, count));
    if (columns == m_columns)
        return;
    m_columns = columns;
    while (m_grid->count() > 0)
        delete m_grid->takeAt(0);
    for (int i = 0; i < m_grid->columnCount(); ++i)
        m_grid->setColumnStretch(i, i < columns ? 1 : 0);
    for (int i = 0; i < count; ++i) {
        m_grid->addWidget(m_charts[static_cast<std::size_t>(i)], i / columns, i % columns);
        m_grid->setColumnStretch(i % columns, 1);
    }
    m_grid->activate();
}

void ChartGrid::resizeEvent(QResizeEvent *event)
{
    arrange(); // first, because the minimum height of the sheet depends on it
    QScrollArea::resizeEvent(event);
}

} // namespace skyseal::ui

#include "moc_chart_grid.cpp"
