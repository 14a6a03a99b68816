#include "ui/charts/chart_view.h"

#include "ui/charts/chart_cursor.h"
#include "ui/charts/chart_painter.h"
#include "ui/text/units.h"
#include "ui/theme/grid.h"

#include <QtCharts/QChart>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace skyseal::ui {

namespace {
constexpr qreal kDragAtLeast = 6; ///< pixels
} // namespace

ChartView::ChartView(QChart *chart, QWidget *parent) : QChartView(chart, parent), m_cursor(new ChartCursor(viewport()))
{
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing, false);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setFocusPolicy(Qt::NoFocus);
    viewport()->setFocusPolicy(Qt::NoFocus); // QGraphicsView gave it one; the panel takes the keys
    setMouseTracking(true);
}

QFont ChartView::labelFont() const
{
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1.5));
    return small;
}

void ChartView::setFrame(const ChartContent &content, bool anyRun)
{
    ChartContent &shown = m_plot.content;
    shown.marks = content.marks;
    shown.bars = content.bars;
    shown.time = content.time;
    shown.from = content.from;
    shown.to = content.to;
    shown.top = content.top;
    m_anyRun = anyRun;
    if (m_bars != static_cast<int>(content.bars.size()))
        placePlot();
}

void ChartView::placePlot()
{
    m_bars = static_cast<int>(m_plot.content.bars.size());
    const QFontMetrics metrics(labelFont());
    const int left = metrics.horizontalAdvance(QStringLiteral("88888")) + kGrid;
    const int right = kGrid + (m_bars > 0 ? m_bars * ChartPlot::kBarStep + kGrid : 0);
    m_plot.area = QRectF(left, metrics.height() / 2.0, width() - left - right, height() - 2.0 * metrics.height() - 2);
    chart()->setPlotArea(m_plot.area);
}

void ChartView::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    placePlot();
    m_cursor->resize(size());
}

void ChartView::drawBackground(QPainter *painter, const QRectF &rect)
{
    QChartView::drawBackground(painter, rect);
    ChartPainter(*painter, m_plot, palette()).paintGrid();
}

void ChartView::drawForeground(QPainter *painter, const QRectF &)
{
    ChartPainter around(*painter, m_plot, palette());
    around.paintAround(labelFont());
    if (!m_anyRun)
        around.paintEmpty(m_emptyText);
    if (m_pressed >= 0 && m_plot.content.time != ChartTime::InUse)
        around.paintSelection(m_pressed, m_dragged);
}

QString ChartView::barText(qreal x) const
{
    const auto index = m_plot.barIndexAt(x);
    if (!index)
        return {};
    const ChartBar &bar = m_plot.content.bars[*index];
    return tr("%1: mean %2 %3, from %4 to %5, %6 samples")
        .arg(bar.suite, number(bar.mean, 3), m_unit, number(bar.low, 3), number(bar.high, 3), grouped(bar.samples));
}

void ChartView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && m_plot.area.contains(event->position()))
        m_pressed = m_dragged = event->position().x();
}

void ChartView::mouseMoveEvent(QMouseEvent *event)
{
    const qreal x = event->position().x();
    if (m_pressed >= 0) {
        m_dragged = x;
        viewport()->update();
    }
    const QString bar = m_pressed < 0 ? barText(x) : QString();
    if (!bar.isEmpty()) {
        Q_EMIT hoverEnded();
        QToolTip::showText(event->globalPosition().toPoint(), bar, this);
        return;
    }
    QToolTip::hideText();
    if (x >= m_plot.area.left() && x <= m_plot.area.right() + 2)
        Q_EMIT hovered(m_plot.timeAt(x));
    else
        Q_EMIT hoverEnded();
}

void ChartView::mouseReleaseEvent(QMouseEvent *event)
{
    const qreal from = std::exchange(m_pressed, -1);
    const qreal to = std::exchange(m_dragged, -1);
    viewport()->update();
    if (event->button() == Qt::LeftButton && from >= 0 && std::abs(to - from) >= kDragAtLeast
        && m_plot.content.time != ChartTime::InUse)
        Q_EMIT rangeRequested(m_plot.timeAt(std::min(from, to)), m_plot.timeAt(std::max(from, to)));
}

void ChartView::mouseDoubleClickEvent(QMouseEvent *)
{
    Q_EMIT liveRequested();
}

void ChartView::leaveEvent(QEvent *event)
{
    QChartView::leaveEvent(event);
    Q_EMIT hoverEnded();
}

void ChartView::wheelEvent(QWheelEvent *event)
{
    // If the charts do not fit, the wheel scrolls them; it zooms with Ctrl.
    for (QWidget *around = parentWidget(); around; around = around->parentWidget()) {
        const auto *scrolls = qobject_cast<const QScrollArea *>(around);
        if (scrolls && scrolls->verticalScrollBar()->maximum() > 0 && !(event->modifiers() & Qt::ControlModifier)) {
            event->ignore();
            return;
        }
    }
    // 120 units are one click of a common wheel.
    const int steps = event->angleDelta().y() / 120;
    if (steps != 0)
        Q_EMIT zoomRequested(steps);
    event->accept();
}

} // namespace skyseal::ui

#include "moc_chart_view.cpp"
