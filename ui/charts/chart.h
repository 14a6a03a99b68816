// The interface of a time series chart: its content as values. The implementation, which knows the drawing library, is made by
// makeTimeSeriesChart() and lives on the GUI thread.
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

/// An unbroken line of one quantity under one suite.
struct ChartRun
{
    QColor color;
    Stroke stroke = Stroke::Solid;
    QString line; ///< name of the quantity's line, shown beside the cursor; empty if the chart has one line
    QString suite;
    std::vector<QPointF> points; ///< x in seconds, y in the chart's unit
    bool operator==(const ChartRun &) const = default;
};

/// An event: a vertical line whose text the cursor shows. Incidents and switches have different shapes.
struct ChartMark
{
    double x = 0;
    QColor color;
    QString text;
    bool incident = false;
    bool operator==(const ChartMark &) const = default;
};

/// The mean of a suite over all its time in use, on the scale of the lines.
struct ChartBar
{
    QColor color;
    QString suite;
    double mean = 0, low = 0, high = 0;
    std::uint64_t samples = 0;
    bool operator==(const ChartBar &) const = default;
};

/// The meaning of the x axis.
enum class ChartTime : std::uint8_t {
    BeforeNow, ///< seconds before now: `from` and `to` are not above 0
    Frozen,    ///< seconds before the moment at which the charts were frozen
    InUse      ///< seconds that each suite was in use, from 0
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
    /// Returns the content as the drawing library holds it, for tests and exports.
    virtual ChartContent plotted() const = 0;
    /// Shows a vertical line with the values at the time `x`; hides it without a time.
    virtual void showCursor(std::optional<double> x) = 0;
    /// Returns the lines of text beside the cursor.
    virtual QStringList cursorText() const = 0;

Q_SIGNALS:
    void hovered(double x);
    void hoverEnded();
    /// The wheel was turned; positive steps zoom in.
    void zoomRequested(int steps);
    /// The operator drew a range with the mouse.
    void rangeRequested(double from, double to);
    void liveRequested();
};

/// The texts around a chart.
struct ChartTitle
{
    QString name, unit;
    QString key;         ///< explains the strokes: "to vehicle dashed"
    QString note;        ///< how the quantity is measured
    QString remark = {}; ///< reason for an empty chart; empty if there is none
};

/// Makes a chart that is owned by `parent`.
TimeSeriesChart *makeTimeSeriesChart(const ChartTitle &title, QWidget *parent);

} // namespace skyseal::ui
