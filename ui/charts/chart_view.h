// The view of one Qt chart: lays out the plot, translates mouse actions to times, and lets ChartPainter paint around the lines.
#pragma once

#include "ui/charts/chart_plot.h"

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
    void setUnit(const QString &unit) { m_unit = unit; }
    /// Sets the text of an empty plot.
    void setEmptyText(const QString &text) { m_emptyText = text; }
    const ChartPlot &plot() const { return m_plot; }
    ChartCursor *cursorLayer() const { return m_cursor; }

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
    QString barText(qreal x) const;

    ChartPlot m_plot;
    QString m_unit;
    QString m_emptyText = tr("nothing measured yet");
    ChartCursor *m_cursor;
    bool m_anyRun = false;
    int m_bars = -1; ///< number of bars for which the plot area was computed
    qreal m_pressed = -1, m_dragged = -1;
};

} // namespace skyseal::ui
