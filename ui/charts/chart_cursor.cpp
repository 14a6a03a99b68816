#include "ui/charts/chart_cursor.h"

#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>

#include <algorithm>

namespace skyseal::ui {

ChartCursor::ChartCursor(QWidget *chart) : QWidget(chart)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void ChartCursor::showAt(qreal x, const QRectF &plot, const QStringList &lines, const std::vector<QPointF> &curves)
{
    m_x = x;
    m_plot = plot;
    m_lines = lines;
    placeBox(curves);
    show();
    update();
}

void ChartCursor::clear()
{
    m_lines.clear();
    m_place = 0;
    hide();
}

QSizeF ChartCursor::textSize() const
{
    const QFontMetricsF metrics(font());
    qreal wide = 0;
    for (const QString &line : m_lines)
        wide = std::max(wide, metrics.horizontalAdvance(line));
    return {wide + 2 * kHalfGrid + 4, metrics.height() * static_cast<qreal>(m_lines.size()) + kHalfGrid};
}

/// Chooses the place that covers the fewest points of the curves: beside the line or at an end of the plot, above or below. The
/// box keeps its place until another one is clearly better, so that it does not jump.
void ChartCursor::placeBox(const std::vector<QPointF> &curves)
{
    constexpr std::ptrdiff_t kOutsideThePlot = 10'000, kOverTheLine = 1'000'000, kClearly = 4;
    const QSizeF size = textSize();
    const qreal tops[] = {m_plot.top(), m_plot.bottom() - size.height()};
    const qreal lefts[] = {std::min(m_x + kGrid, width() - size.width()), std::max(0.0, m_x - kGrid - size.width()),
                           m_plot.right() - size.width(), m_plot.left()};
    std::vector<QRectF> places;
    std::vector<std::ptrdiff_t> costs;
    for (const qreal left : lefts) {
        for (const qreal top : tops) {
            const QRectF place(QPointF(left, top), size);
            const bool inside = left >= m_plot.left() && place.right() <= m_plot.right();
            const bool overTheLine = left <= m_x && place.right() >= m_x;
            places.push_back(place);
            costs.push_back(std::ranges::count_if(curves, [&](const QPointF &point) { return place.contains(point); })
                            + (inside ? 0 : kOutsideThePlot) + (overTheLine ? kOverTheLine : 0));
        }
    }
    const auto best = std::ranges::min_element(costs);
    if (costs[m_place] / 2 > *best + kClearly)
        m_place = static_cast<std::size_t>(best - costs.begin());
    m_box = places[m_place];
}

void ChartCursor::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const StateColors &colors = stateColors(palette());
    painter.setPen(QPen(colors.dim, 1));
    painter.drawLine(QPointF(m_x, m_plot.top()), QPointF(m_x, m_plot.bottom()));
    if (m_lines.isEmpty())
        return;
    const QRectF &frame = m_box;
    QColor back = palette().color(QPalette::ToolTipBase);
    back.setAlpha(215); // covered curves remain visible
    painter.setBrush(back);
    painter.setPen(colors.line);
    painter.drawRect(frame);
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(frame.adjusted(kHalfGrid + 2, 2, 0, 0), Qt::AlignLeft | Qt::AlignTop, m_lines.join(QLatin1Char('\n')));
}

} // namespace skyseal::ui

#include "moc_chart_cursor.cpp"
