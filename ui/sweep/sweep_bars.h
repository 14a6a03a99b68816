// One metric of a sweep as bars, in the colours of the suites: mean, 95 % confidence interval, and a dot for each run, or
// ratios. The same chart as the saved figures (experiment::BarChart), painted with the palette of the window.
#pragma once

#include "core/experiment/bar_chart.h"

#include <QtWidgets/QWidget>

namespace skyseal::ui {

class SweepBars : public QWidget
{
    Q_OBJECT

public:
    explicit SweepBars(QWidget *parent = nullptr);

    void showChart(experiment::BarChart chart, QStringList labels);
    const experiment::BarChart &chart() const { return m_chart; }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *) override;

private:
    struct Frame;
    Frame frame() const;
    void drawAxis(QPainter &painter, const Frame &frame) const;
    void drawBar(QPainter &painter, const Frame &frame, std::size_t row) const;

    experiment::BarChart m_chart;
    QStringList m_labels; ///< one per bar
};

} // namespace skyseal::ui
