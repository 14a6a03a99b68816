#include "ui/sweep/sweep_bars.h"

#include "ui/sweep/sweep_labels.h"
#include "ui/text/figures.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

constexpr int kLeastRow = 18, kMostRow = 30;

QString valueText(const experiment::Bar &bar)
{
    return bar.text.empty() ? localNumber(experiment::readable(bar.mean, bar.low, bar.high)) : fromStd(bar.text);
}

double highestOf(const experiment::BarChart &chart)
{
    double out = 0;
    for (const experiment::Bar &bar : chart.bars) {
        for (const double value : {bar.mean, bar.high})
            out = std::isfinite(value) ? std::max(out, value) : out;
        for (const double value : bar.samples)
            out = std::isfinite(value) ? std::max(out, value) : out;
    }
    return out;
}

} // namespace

struct SweepBars::Frame
{
    QRectF area; ///< of the bars without labels
    qreal row = 0;
    double step = 1, end = 1;

    qreal x(double value) const { return area.left() + area.width() * std::clamp(value / end, 0.0, 1.0); }
    qreal middle(std::size_t index) const { return area.top() + row * (static_cast<qreal>(index) + 0.5); }
};

SweepBars::SweepBars(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("sweepBars"));
    setMinimumWidth(44 * kGrid);
}

void SweepBars::showChart(experiment::BarChart chart, QStringList labels)
{
    m_chart = std::move(chart);
    m_labels = std::move(labels);
    QStringList lines{fromStd(m_chart.axis)};
    for (std::size_t i = 0; i < m_chart.bars.size(); ++i)
        lines << m_labels.at(static_cast<qsizetype>(i)) + QStringLiteral(": ")
                + (std::isfinite(m_chart.bars[i].mean) ? valueText(m_chart.bars[i]) : fromStd(m_chart.bars[i].missing));
    setAccessibleName(lines.first());
    setAccessibleDescription(lines.join(QStringLiteral("; ")));
    setMinimumHeight(sizeHint().height());
    update();
}

QSize SweepBars::sizeHint() const
{
    const int line = fontMetrics().height();
    return {60 * kGrid, 2 * line + 2 * kGrid + kLeastRow * static_cast<int>(m_chart.bars.size())};
}

SweepBars::Frame SweepBars::frame() const
{
    const QFontMetricsF metrics(font());
    qreal left = 0, right = 0;
    for (std::size_t i = 0; i < m_chart.bars.size(); ++i) {
        left = std::max(left, metrics.horizontalAdvance(m_labels.at(static_cast<qsizetype>(i))));
        right = std::max(right, figuresWidth(metrics, valueText(m_chart.bars[i])));
    }
    const qreal top = metrics.height() + kGrid, bottom = metrics.height() + kHalfGrid;
    Frame out;
    const auto rows = static_cast<qreal>(std::max<std::size_t>(1, m_chart.bars.size()));
    out.row = std::clamp((height() - top - bottom) / rows, static_cast<qreal>(kLeastRow), static_cast<qreal>(kMostRow));
    out.area = QRectF(left + 2 * kGrid, top, std::max(40.0, width() - left - right - 5.0 * kGrid), out.row * rows);
    out.step = experiment::axisStep(highestOf(m_chart));
    out.end = out.step * std::max(1.0, std::ceil(highestOf(m_chart) / out.step - 1e-9));
    return out;
}

void SweepBars::paintEvent(QPaintEvent *)
{
    if (m_chart.bars.empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Frame place = frame();
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QPointF(kGrid, fontMetrics().ascent() + 2), fromStd(m_chart.axis));
    drawAxis(painter, place);
    for (std::size_t row = 0; row < m_chart.bars.size(); ++row)
        drawBar(painter, place, row);
}

void SweepBars::drawAxis(QPainter &painter, const Frame &frame) const
{
    const StateColors &colors = stateColors(palette());
    const QFontMetricsF metrics(font());
    qreal free = 0; // labels that would touch are omitted
    for (int i = 0; i * frame.step <= frame.end * 1.0001; ++i) {
        const qreal x = std::floor(frame.x(i * frame.step)) + 0.5;
        painter.setPen(QPen(i == 0 ? colors.dim : colors.line, 1));
        painter.drawLine(QPointF(x, frame.area.top() - 2), QPointF(x, frame.area.bottom()));
        const QString text = localNumber(experiment::readable(i * frame.step));
        const qreal wide = figuresWidth(metrics, text), left = x - wide / 2;
        if (left < free)
            continue;
        painter.setPen(colors.dim);
        drawFigures(painter, QPointF(left, frame.area.bottom() + metrics.ascent() + 2), text);
        free = left + wide + kGrid;
    }
}

void SweepBars::drawBar(QPainter &painter, const Frame &frame, std::size_t row) const
{
    const experiment::Bar &bar = m_chart.bars[row];
    const StateColors &colors = stateColors(palette());
    const QFontMetricsF metrics(font());
    const qreal middle = frame.middle(row), base = middle + metrics.capHeight() / 2;
    const QString label = m_labels.at(static_cast<qsizetype>(row));
    const QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(ink);
    painter.drawText(QPointF(frame.area.left() - kGrid - metrics.horizontalAdvance(label), base), label);
    if (!std::isfinite(bar.mean)) {
        painter.setPen(colors.dim);
        painter.drawText(QPointF(frame.area.left() + kGrid, base), fromStd(bar.missing));
        return;
    }
    const qreal thick = frame.row * 0.6;
    const QRectF body(frame.area.left(), middle - thick / 2, frame.x(bar.mean) - frame.area.left(), thick);
    painter.fillRect(body, suiteColor(bar.suite));
    if (bar.insecure)
        painter.fillRect(body, QBrush(palette().color(QPalette::Window), Qt::BDiagPattern));
    painter.setPen(QPen(ink, 1.4));
    if (std::isfinite(bar.low) && std::isfinite(bar.high)) {
        const qreal low = frame.x(bar.low), high = frame.x(bar.high);
        painter.drawLine(QPointF(low, middle), QPointF(high, middle));
        for (const qreal end : {low, high})
            painter.drawLine(QPointF(end, middle - 4), QPointF(end, middle + 4));
    }
    for (std::size_t i = 0; i < bar.samples.size(); ++i) {
        if (!std::isfinite(bar.samples[i]))
            continue;
        painter.setPen(QPen(palette().color(QPalette::Window), 1));
        painter.setBrush(bar.outlier[i] ? colors.alarm : ink);
        painter.drawEllipse(QPointF(frame.x(bar.samples[i]), middle), 2.8, 2.8);
    }
    painter.setPen(ink);
    drawFigures(painter, QPointF(frame.area.right() + kGrid, base), valueText(bar));
}

} // namespace skyseal::ui

#include "moc_sweep_bars.cpp"
