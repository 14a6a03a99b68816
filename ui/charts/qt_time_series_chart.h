// The time series chart drawn by Qt Charts. The x axis stands still ("120 s ago … now") and the data move under it, since a
// moving axis costs half of a redraw; series are kept and refilled, never made anew.
#pragma once

#include "ui/charts/chart.h"

#include <QtCharts/QChartView>

class QLabel;
class QLineSeries;
class QValueAxis;

namespace skyseal::ui {

/// Draws the marks over the plot.
class MarkedChartView : public QChartView
{
    Q_OBJECT

public:
    explicit MarkedChartView(QChart *chart, QWidget *parent);
    void setMarks(const std::vector<ChartMark> &marks, double span);
    const std::vector<ChartMark> &marks() const { return m_marks; }

protected:
    void drawForeground(QPainter *painter, const QRectF &rect) override;

private:
    std::vector<ChartMark> m_marks;
    double m_span = 120;
};

class QtTimeSeriesChart : public TimeSeriesChart
{
    Q_OBJECT

public:
    QtTimeSeriesChart(const QString &title, const QString &unit, QWidget *parent);

    void showContent(const ChartContent &content) override;
    ChartContent plotted() const override;

    QSize minimumSizeHint() const override { return {176, 112}; }

protected:
    void changeEvent(QEvent *event) override;

private:
    QLineSeries *series(std::size_t index);
    void applyColors();

    QChart *m_chart;
    MarkedChartView *m_view;
    QValueAxis *m_time, *m_value;
    QLabel *m_title;
    std::vector<QLineSeries *> m_series;
    std::size_t m_used = 0;
};

} // namespace skyseal::ui
