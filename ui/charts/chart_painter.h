// Paints grid, labels, bars and marks around the lines that Qt Charts draws (qt_time_series_chart.cpp has the figures that
// speak for it). Made for one paint event.
#pragma once

#include "ui/charts/chart_plot.h"

#include <QtGui/QFont>
#include <QtGui/QPalette>

class QPainter;

namespace skyseal::ui {

class ChartPainter
{
public:
    /// References must outlive the painter.
    ChartPainter(QPainter &painter, const ChartPlot &plot, const QPalette &palette);

    void paintGrid();
    /// Labels, bars and marks. `font` is the one of the labels.
    void paintAround(const QFont &font);
    /// A text in the middle of the plot.
    void paintEmpty(const QString &text);
    /// The range between two pixel columns that the mouse selects.
    void paintSelection(qreal from, qreal to);

private:
    void paintValueLabels();
    void paintTimeLabels();
    void paintBars();
    void paintMarks();

    QPainter &m_painter;
    const ChartPlot &m_plot;
    const QPalette &m_palette;
};

} // namespace skyseal::ui
