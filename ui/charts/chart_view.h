// The view of one Qt chart. It paints grid, labels, marks and bars, which Qt Charts draws slower or not at all (figures in
// qt_time_series_chart.cpp), and translates mouse actions to times.
#pragma once

#include "ui/charts/chart.h"

#include <QtCharts/QChartView>

namespace skyseal::ui {

class ChartCursor;

class ChartView : public QChartView
{
    Q_OBJECT

public:
    explicit ChartView(QChart *chart, QWidget *parent);

    /// Sets everything except the runs, which the chart's series hold.
    void setFrame(const ChartContent &content, bool anyRun);
    const ChartContent &frame() const { return m_frame; }
    void setUnit(const QString &unit) { m_unit = unit; }
    /// Sets the text of an empty plot.
    void setEmptyText(const QString &text) { m_emptyText = text; }
    /// Returns the time in seconds at this pixel, limited to the plot.
    double timeAt(qreal x) const;
    qreal placeOf(double time) const;
    ChartCursor *cursorLayer() const { return m_cursor; }
    QRectF plot() const;
    /// Returns the seconds per pixel.
    double secondsPerPixel() const;

Q_SIGNALS:
    void hovered(double x);
    void hoverEnded();
    void zoomRequested(int steps);
    void rangeRequested(double from, double to);
    void liveRequested();

protected:
    void drawBackground(QPainter *painter, const QRectF &rect) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    QFont labelFont() const;
    void placePlot();
    void drawTimeLabels(QPainter &painter, const QRectF &area) const;
    void drawValueLabels(QPainter &painter, const QRectF &area) const;
    void drawMarks(QPainter &painter, const QRectF &area) const;
    void drawBars(QPainter &painter, const QRectF &area) const;
    QRectF barAt(std::size_t index, const QRectF &area) const;
    QString barText(qreal x) const;

    ChartContent m_frame; ///< without runs
    QString m_unit;
    QString m_emptyText = tr("nothing measured yet");
    ChartCursor *m_cursor;
    bool m_anyRun = false;
    int m_bars = -1; ///< number of bars for which the plot area was computed
    qreal m_pressed = -1, m_dragged = -1;
};

} // namespace skyseal::ui
