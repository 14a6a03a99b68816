#include "ui/charts/chart_painter.h"

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

ChartPainter::ChartPainter(QPainter &painter, const ChartPlot &plot, const QPalette &palette)
    : m_painter(painter), m_plot(plot), m_palette(palette)
{}

void ChartPainter::paintGrid()
{
    const ChartContent &content = m_plot.content;
    const QRectF &area = m_plot.area;
    m_painter.setPen(QPen(stateColors(m_palette).line, 1));
    const int parts = axisParts(content.top, area.height());
    for (int i = 0; i <= parts; ++i) {
        const qreal y = crisp(area.bottom() - area.height() * i / parts);
        const qreal right = content.bars.empty() ? area.right() : m_plot.barAt(content.bars.size() - 1).right() + 2;
        m_painter.drawLine(QPointF(area.left(), y), QPointF(right, y));
    }
    const int spans = timeParts(content.to - content.from);
    for (int i = 0; i <= spans; ++i) {
        const qreal x = crisp(area.left() + area.width() * i / spans);
        m_painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
}

void ChartPainter::paintAround(const QFont &font)
{
    m_painter.setFont(font);
    paintValueLabels();
    paintTimeLabels();
    paintBars();
    paintMarks();
}

void ChartPainter::paintEmpty(const QString &text)
{
    const QRectF place = m_painter.boundingRect(m_plot.area, Qt::AlignCenter, text);
    m_painter.fillRect(place.adjusted(-kHalfGrid, 0, kHalfGrid, 0), m_palette.color(QPalette::Window));
    m_painter.setPen(stateColors(m_palette).dim);
    m_painter.drawText(place, Qt::AlignCenter, text);
}

void ChartPainter::paintSelection(qreal from, qreal to)
{
    const QRectF &area = m_plot.area;
    QColor wash = m_palette.color(QPalette::Highlight);
    wash.setAlphaF(0.25f);
    const qreal a = std::clamp(from, area.left(), area.right());
    const qreal b = std::clamp(to, area.left(), area.right());
    m_painter.fillRect(QRectF(QPointF(std::min(a, b), area.top()), QPointF(std::max(a, b), area.bottom())), wash);
}

void ChartPainter::paintValueLabels()
{
    const QRectF &area = m_plot.area;
    const double top = m_plot.content.top;
    m_painter.setPen(stateColors(m_palette).dim);
    const QFontMetricsF metrics(m_painter.font());
    const int parts = axisParts(top, area.height());
    const int decimals = decimalsOf(top / parts);
    for (int i = 0; i <= parts; ++i) {
        const QString text = number(top * i / parts, decimals);
        const qreal y = area.bottom() - area.height() * i / parts;
        drawFigures(m_painter, QPointF(area.left() - kHalfGrid - figuresWidth(metrics, text), y + metrics.capHeight() / 2),
                    text);
    }
}

void ChartPainter::paintTimeLabels()
{
    const ChartContent &content = m_plot.content;
    const QRectF &area = m_plot.area;
    const QFontMetricsF metrics(m_painter.font());
    const int parts = timeParts(content.to - content.from);
    const double step = (content.to - content.from) / parts;
    const int decimals = std::min(1, decimalsOf(step));
    qreal free = area.left() - 1; // labels that would touch are omitted
    for (int i = 0; i <= parts; ++i) {
        const double time = content.from + step * i;
        const QString text = chartTimeText(time, content.time, decimals);
        const qreal wide = figuresWidth(metrics, text);
        const qreal middle = area.left() + area.width() * i / parts;
        const qreal last = area.right() - wide;
        const qreal left = i == 0 ? middle : i == parts ? last : middle - wide / 2;
        if (left < free || (i < parts && i > 0 && left + wide + kGrid > last))
            continue;
        drawFigures(m_painter, QPointF(left, area.bottom() + metrics.height() + 2), text);
        free = left + wide + kGrid;
    }
}

void ChartPainter::paintBars()
{
    for (std::size_t i = 0; i < m_plot.content.bars.size(); ++i) {
        const ChartBar &bar = m_plot.content.bars[i];
        const QRectF place = m_plot.barAt(i);
        m_painter.fillRect(place, bar.color);
        m_painter.setPen(QPen(m_palette.color(QPalette::WindowText), 1));
        const qreal x = crisp(place.center().x());
        m_painter.drawLine(QPointF(x, m_plot.yOf(bar.low)), QPointF(x, m_plot.yOf(bar.high))); // range of the samples
    }
}

void ChartPainter::paintMarks()
{
    const QRectF &area = m_plot.area;
    for (const ChartMark &mark : m_plot.content.marks) {
        const qreal x = m_plot.xOf(mark.x);
        if (x < area.left() || x > area.right())
            continue;
        m_painter.setPen(QPen(mark.color, 1, mark.incident ? Qt::DotLine : Qt::DashLine));
        m_painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(mark.color);
        const qreal top = area.top();
        if (mark.incident) {
            const QPointF diamond[] = {{x, top - 4}, {x + 5, top + 1}, {x, top + 6}, {x - 5, top + 1}};
            m_painter.drawPolygon(diamond, 4);
        } else {
            const QPointF tip[] = {{x - 4, top}, {x + 4, top}, {x, top + 6}};
            m_painter.drawPolygon(tip, 3);
        }
    }
}

} // namespace skyseal::ui
