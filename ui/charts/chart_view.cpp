#include "ui/charts/chart_view.h"

#include "ui/charts/axis_scale.h"
#include "ui/charts/chart_cursor.h"
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

namespace skyseal::ui {

namespace {
constexpr int kBarStep = 10, kBarWidth = 7; ///< pixels
constexpr qreal kDragAtLeast = 6;
} // namespace

ChartView::ChartView(QChart *chart, QWidget *parent) : QChartView(chart, parent), m_cursor(new ChartCursor(viewport()))
{
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing, false);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setFocusPolicy(Qt::NoFocus);
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
    m_frame.marks = content.marks;
    m_frame.bars = content.bars;
    m_frame.time = content.time;
    m_frame.from = content.from;
    m_frame.to = content.to;
    m_frame.top = content.top;
    m_anyRun = anyRun;
    if (m_bars != static_cast<int>(content.bars.size()))
        placePlot();
}

void ChartView::placePlot()
{
    m_bars = static_cast<int>(m_frame.bars.size());
    const QFontMetrics metrics(labelFont());
    const int left = metrics.horizontalAdvance(QStringLiteral("88888")) + kGrid;
    const int right = kGrid + (m_bars > 0 ? m_bars * kBarStep + kGrid : 0);
    chart()->setPlotArea(QRectF(left, metrics.height() / 2.0, width() - left - right, height() - 2.0 * metrics.height() - 2));
}

void ChartView::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    placePlot();
    m_cursor->resize(size());
}

QRectF ChartView::plot() const
{
    return chart()->plotArea();
}

double ChartView::secondsPerPixel() const
{
    return (m_frame.to - m_frame.from) / std::max(1.0, plot().width());
}

double ChartView::timeAt(qreal x) const
{
    const QRectF area = plot();
    return m_frame.from + (std::clamp(x, area.left(), area.right()) - area.left()) * secondsPerPixel();
}

qreal ChartView::placeOf(double time) const
{
    return plot().left() + (time - m_frame.from) / secondsPerPixel();
}

QRectF ChartView::barAt(std::size_t index, const QRectF &area) const
{
    const ChartBar &bar = m_frame.bars[index];
    const qreal high = std::clamp(bar.mean / m_frame.top, 0.0, 1.0) * area.height();
    return {area.right() + kGrid + static_cast<qreal>(index) * kBarStep, area.bottom() - high, kBarWidth, high};
}

QString ChartView::barText(qreal x) const
{
    const QRectF area = plot();
    for (std::size_t i = 0; i < m_frame.bars.size(); ++i) {
        const QRectF place = barAt(i, area);
        const ChartBar &bar = m_frame.bars[i];
        if (x >= place.left() - 1 && x < place.left() + kBarStep - 1)
            return tr("%1: mean %2 %3, from %4 to %5, %6 samples")
                .arg(bar.suite, number(bar.mean, 3), m_unit, number(bar.low, 3), number(bar.high, 3), grouped(bar.samples));
    }
    return {};
}

void ChartView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && plot().contains(event->position()))
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
    if (x >= plot().left() && x <= plot().right() + 2)
        Q_EMIT hovered(timeAt(x));
    else
        Q_EMIT hoverEnded();
}

void ChartView::mouseReleaseEvent(QMouseEvent *event)
{
    const qreal from = std::exchange(m_pressed, -1);
    const qreal to = std::exchange(m_dragged, -1);
    viewport()->update();
    if (event->button() == Qt::LeftButton && from >= 0 && std::abs(to - from) >= kDragAtLeast
        && m_frame.time != ChartTime::InUse)
        Q_EMIT rangeRequested(timeAt(std::min(from, to)), timeAt(std::max(from, to)));
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
