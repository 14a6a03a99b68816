// A chart over time as the rest of the window sees it: what is to be plotted, as values. Which library draws it is behind
// makeTimeSeriesChart().
#pragma once

#include <QtCore/QPointF>
#include <QtCore/QString>
#include <QtGui/QColor>
#include <QtWidgets/QWidget>

#include <vector>

namespace skyseal::ui {

/// A line without a break. Dashed lines are second quantities of the same chart.
struct ChartRun
{
    QColor color;
    bool dashed = false;
    std::vector<QPointF> points; ///< x in seconds before now (negative), y in the chart's unit
    bool operator==(const ChartRun &) const = default;
};

/// A moment worth seeing: a vertical line with a short text.
struct ChartMark
{
    double x = 0;
    QColor color;
    QString text;
    bool operator==(const ChartMark &) const = default;
};

struct ChartContent
{
    std::vector<ChartRun> runs;
    std::vector<ChartMark> marks;
    double span = 120;  ///< seconds shown
    double top = 1;     ///< end of the y axis; it begins at 0
    bool operator==(const ChartContent &) const = default;
};

class TimeSeriesChart : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    virtual void showContent(const ChartContent &content) = 0;
    /// What is plotted, read back from the drawing library: for tests and exports.
    virtual ChartContent plotted() const = 0;
};

/// The caller's parent owns it. `title` and `unit` stand above the plot.
TimeSeriesChart *makeTimeSeriesChart(const QString &title, const QString &unit, QWidget *parent);

} // namespace skyseal::ui
