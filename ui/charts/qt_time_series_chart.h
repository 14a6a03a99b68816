// The time series chart drawn by Qt Charts. The x axis is fixed ("120 s ago … now") and the data move, because moving the axis
// costs half of a redraw; series are refilled, not replaced.
#pragma once

#include "ui/charts/chart.h"

#include <QtCharts/QChart>

class QLabel;
class QLineSeries;
class QValueAxis;

namespace skyseal::ui {

class ChartView;

class QtTimeSeriesChart : public TimeSeriesChart
{
    Q_OBJECT

public:
    QtTimeSeriesChart(const ChartTitle &title, QWidget *parent);

    void showContent(const ChartContent &content) override;
    ChartContent plotted() const override;
    void showCursor(std::optional<double> x) override;
    QStringList cursorText() const override;

    QSize minimumSizeHint() const override { return {176, 112}; }

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QLineSeries *series(std::size_t index);
    void applyColors();

    QChart *m_chart;
    ChartView *m_view;
    QValueAxis *m_time, *m_value;
    QLabel *m_title;
    QString m_titleText;
    std::vector<QLineSeries *> m_series;
    std::vector<std::pair<QString, QString>> m_names; ///< line and suite of each series in use
    std::size_t m_used = 0;
    std::optional<double> m_cursor;
};

} // namespace skyseal::ui
