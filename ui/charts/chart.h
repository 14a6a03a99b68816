// A chart as the rest of the window sees it: what is to be plotted, as values. Which library draws it is behind
// makeTimeSeriesChart().
#pragma once

#include <QtCore/QPointF>
#include <QtCore/QString>
#include <QtGui/QColor>
#include <QtWidgets/QWidget>

#include <cstdint>
#include <optional>
#include <vector>

namespace skyseal::ui {

enum class Stroke : std::uint8_t { Solid, Dashed, Dotted };

/// A line without a break, of one quantity under one suite.
struct ChartRun
{
    QColor color;
    Stroke stroke = Stroke::Solid;
    QString line; ///< which of the chart's quantities, for the values under the mouse; empty where there is one only
    QString suite;
    std::vector<QPointF> points; ///< x in seconds, y in the chart's unit
    bool operator==(const ChartRun &) const = default;
};

/// A moment worth seeing: a vertical line, its text under the mouse. An incident has another shape than a switch.
struct ChartMark
{
    double x = 0;
    QColor color;
    QString text;
    bool incident = false;
    bool operator==(const ChartMark &) const = default;
};

/// The mean of a suite over all the time that it was in use, on the same scale as the lines beside it.
struct ChartBar
{
    QColor color;
    QString suite;
    double mean = 0, low = 0, high = 0;
    std::uint64_t samples = 0;
    bool operator==(const ChartBar &) const = default;
};

/// What the x axis counts.
enum class ChartTime : std::uint8_t {
    BeforeNow, ///< from `from` to `to`, both not above 0; 0 is now
    Frozen,    ///< the same, where 0 is the moment at which the charts were stopped
    InUse      ///< time that each suite was in use, from 0
};

struct ChartContent
{
    std::vector<ChartRun> runs;
    std::vector<ChartMark> marks;
    std::vector<ChartBar> bars;
    ChartTime time = ChartTime::BeforeNow;
    double from = -120, to = 0; ///< seconds shown
    double top = 1;             ///< end of the y axis; it begins at 0
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
    /// A vertical line with the values at that time; none without a time.
    virtual void showCursor(std::optional<double> x) = 0;
    /// The words beside the cursor, line by line.
    virtual QStringList cursorText() const = 0;

Q_SIGNALS:
    void hovered(double x);
    void hoverEnded();
    /// The wheel was turned: positive is closer.
    void zoomRequested(int steps);
    /// The operator drew a range with the mouse.
    void rangeRequested(double from, double to);
    void liveRequested();
};

/// What stands above and around a chart.
struct ChartTitle
{
    QString name, unit;
    QString key;         ///< which stroke is which: "to it dashed"
    QString note;        ///< what is measured and how
    QString remark = {}; ///< why there is nothing to see; empty where there is
};

/// The caller's parent owns it.
TimeSeriesChart *makeTimeSeriesChart(const ChartTitle &title, QWidget *parent);

} // namespace skyseal::ui
