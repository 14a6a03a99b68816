// The part of ChartView that paints around Qt Charts' lines.
#include "ui/charts/chart_view.h"

#include "ui/charts/axis_scale.h"
#include "ui/charts/chart_text.h"
#include "ui/text/figures.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

/// Returns the number of parts that end at whole seconds.
int timeParts(double span)
{
    for (const int parts : {4, 3, 5})
        if (decimalsOf(span / parts) == 0)
            return parts;
    return 4;
}

qreal crisp(qreal at)
{
    return std::floor(at) + 0.5;
}

} // namespace

void ChartView::drawBackground(QPainter *painter, const QRectF &rect)
{
    QChartView::drawBackground(painter, rect);
    const QRectF area = plot();
    const StateColors &colors = stateColors(palette());
    painter->setPen(QPen(colors.line, 1));
    const int parts = axisParts(m_frame.top, area.height());
    for (int i = 0; i <= parts; ++i) {
        const qreal y = crisp(area.bottom() - area.height() * i / parts);
        const qreal right = m_frame.bars.empty() ? area.right() : barAt(m_frame.bars.size() - 1, area).right() + 2;
        painter->drawLine(QPointF(area.left(), y), QPointF(right, y));
    }
    const int spans = timeParts(m_frame.to - m_frame.from);
    for (int i = 0; i <= spans; ++i) {
        const qreal x = crisp(area.left() + area.width() * i / spans);
        painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
}

void ChartView::drawForeground(QPainter *painter, const QRectF &)
{
    const QRectF area = plot();
    painter->setFont(labelFont());
    drawValueLabels(*painter, area);
    drawTimeLabels(*painter, area);
    drawBars(*painter, area);
    drawMarks(*painter, area);
    if (!m_anyRun) {
        const QString &text = m_emptyText;
        const QRectF place = painter->boundingRect(area, Qt::AlignCenter, text);
        painter->fillRect(place.adjusted(-kHalfGrid, 0, kHalfGrid, 0), palette().color(QPalette::Window));
        painter->setPen(stateColors(palette()).dim);
        painter->drawText(place, Qt::AlignCenter, text);
    }
    if (m_pressed >= 0 && m_frame.time != ChartTime::InUse) {
        QColor wash = palette().color(QPalette::Highlight);
        wash.setAlphaF(0.25f);
        const qreal a = std::clamp(m_pressed, area.left(), area.right());
        const qreal b = std::clamp(m_dragged, area.left(), area.right());
        painter->fillRect(QRectF(QPointF(std::min(a, b), area.top()), QPointF(std::max(a, b), area.bottom())), wash);
    }
}

void ChartView::drawValueLabels(QPainter &painter, const QRectF &area) const
{
    painter.setPen(stateColors(palette()).dim);
    const QFontMetricsF metrics(labelFont());
    const int parts = axisParts(m_frame.top, area.height());
    const int decimals = decimalsOf(m_frame.top / parts);
    for (int i = 0; i <= parts; ++i) {
        const QString text = number(m_frame.top * i / parts, decimals);
        const qreal y = area.bottom() - area.height() * i / parts;
        drawFigures(painter, QPointF(area.left() - kHalfGrid - figuresWidth(metrics, text), y + metrics.capHeight() / 2), text);
    }
}

void ChartView::drawTimeLabels(QPainter &painter, const QRectF &area) const
{
    const QFontMetricsF metrics(labelFont());
    const int parts = timeParts(m_frame.to - m_frame.from);
    const double step = (m_frame.to - m_frame.from) / parts;
    const int decimals = std::min(1, decimalsOf(step));
    qreal free = area.left() - 1; // labels that would touch are omitted
    for (int i = 0; i <= parts; ++i) {
        const double time = m_frame.from + step * i;
        const QString text = chartTimeText(time, m_frame.time, decimals);
        const qreal wide = figuresWidth(metrics, text);
        const qreal middle = area.left() + area.width() * i / parts;
        const qreal last = area.right() - wide;
        const qreal left = i == 0 ? middle : i == parts ? last : middle - wide / 2;
        if (left < free || (i < parts && i > 0 && left + wide + kGrid > last))
            continue;
        drawFigures(painter, QPointF(left, area.bottom() + metrics.height() + 2), text);
        free = left + wide + kGrid;
    }
}

void ChartView::drawBars(QPainter &painter, const QRectF &area) const
{
    for (std::size_t i = 0; i < m_frame.bars.size(); ++i) {
        const ChartBar &bar = m_frame.bars[i];
        const QRectF place = barAt(i, area);
        painter.fillRect(place, bar.color);
        const auto y = [&](double value) { return area.bottom() - std::clamp(value / m_frame.top, 0.0, 1.0) * area.height(); };
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
        const qreal x = crisp(place.center().x());
        painter.drawLine(QPointF(x, y(bar.low)), QPointF(x, y(bar.high))); // range of the samples
    }
}

void ChartView::drawMarks(QPainter &painter, const QRectF &area) const
{
    for (const ChartMark &mark : m_frame.marks) {
        const qreal x = placeOf(mark.x);
        if (x < area.left() || x > area.right())
            continue;
        painter.setPen(QPen(mark.color, 1, mark.incident ? Qt::DotLine : Qt::DashLine));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(mark.color);
        const qreal top = area.top();
        if (mark.incident) {
            const QPointF diamond[] = {{x, top - 4}, {x + 5, top + 1}, {x, top + 6}, {x - 5, top + 1}};
            painter.drawPolygon(diamond, 4);
        } else {
            const QPointF tip[] = {{x - 4, top}, {x + 4, top}, {x, top + 6}};
            painter.drawPolygon(tip, 3);
        }
    }
}

} // namespace skyseal::ui
