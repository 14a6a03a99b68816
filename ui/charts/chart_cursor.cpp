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

void ChartCursor::showAt(qreal x, const QRectF &plot, const QStringList &words)
{
    if (x == m_x && words == m_words && plot == m_plot && isVisible())
        return;
    m_x = x;
    m_plot = plot;
    m_words = words;
    show();
    update();
}

void ChartCursor::clear()
{
    m_words.clear();
    hide();
}

QRectF ChartCursor::box() const
{
    const QFontMetricsF metrics(font());
    qreal wide = 0;
    for (const QString &line : m_words)
        wide = std::max(wide, metrics.horizontalAdvance(line));
    const QSizeF size(wide + 2 * kHalfGrid + 4, metrics.height() * static_cast<qreal>(m_words.size()) + kHalfGrid);
    const bool right = m_x + kGrid + size.width() <= m_plot.right();
    const qreal left = right ? m_x + kGrid : std::max(m_plot.left(), m_x - kGrid - size.width());
    return {QPointF(left, m_plot.top()), size};
}

void ChartCursor::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const StateColors &colors = stateColors(palette());
    painter.setPen(QPen(colors.dim, 1));
    painter.drawLine(QPointF(m_x, m_plot.top()), QPointF(m_x, m_plot.bottom()));
    if (m_words.isEmpty())
        return;
    const QRectF frame = box();
    QColor back = palette().color(QPalette::ToolTipBase);
    back.setAlpha(235);
    painter.setBrush(back);
    painter.setPen(colors.line);
    painter.drawRect(frame);
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(frame.adjusted(kHalfGrid + 2, 2, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                     m_words.join(QLatin1Char('\n')));
}

} // namespace skyseal::ui
