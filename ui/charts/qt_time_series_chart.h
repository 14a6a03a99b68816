// The time series chart drawn by Qt Charts. The x axis stands still ("120 s ago … now") and the data move under it, since a
// moving axis costs half of a redraw; series are kept and refilled, never made anew.
#pragma once

#include "ui/charts/chart.h"

#include <QtCharts/QChartView>

class QLabel;
class QLineSeries;
class QValueAxis;

namespace skyseal::ui {

/// Draws marks and the axes' labels around the plot.
class MarkedChartView : public QChartView
{
    Q_OBJECT

public:
    explicit MarkedChartView(QChart *chart, QWidget *parent);
    void setMarks(const std::vector<ChartMark> &marks, double span, double top);
    const std::vector<ChartMark> &marks() const { return m_marks; }

protected:
    void drawForeground(QPainter *painter, const QRectF &rect) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QFont labelFont() const;
    void drawLabels(QPainter &painter, const QRectF &area) const;

    std::vector<ChartMark> m_marks;
    double m_span = 120, m_top = 1;
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
