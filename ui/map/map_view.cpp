#include "ui/map/map_view.h"

#include "ui/map/map_painter.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QWheelEvent>

#include <cmath>

namespace skyseal::ui {

namespace {
constexpr double kKeyStep = 48; ///< pixels
} // namespace

MapView::MapView(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("map"));
    setAccessibleName(tr("Map"));
    setAccessibleDescription(tr("Arrow keys move it, plus and minus zoom, Home follows the vehicle"));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MapView::showViewState(const ViewState &view)
{
    const MapContent::Changes changes = m_content.show(view, m_viewport.metresPerPixel());
    m_groundDirty |= changes.ground;
    if (changes.moved && m_follow && !m_dragging) {
        // Follow in steps: the ground is redrawn only when the vehicle leaves the middle of the picture.
        const QPointF off = (*m_content.vehicle() - m_viewport.centre()) / m_viewport.metresPerPixel();
        if (std::abs(off.x()) > width() / 4.0 || std::abs(off.y()) > height() / 4.0) {
            m_viewport.setCentre(*m_content.vehicle());
            m_groundDirty = true;
        }
    }
    if (changes.vehicle || m_groundDirty)
        update();
}

void MapView::markGroundDirty()
{
    m_groundDirty = true;
    update();
}

void MapView::clearTrack()
{
    m_content.clearTrack();
    markGroundDirty();
}

void MapView::startOver()
{
    m_content = MapContent();
    m_follow = true;
    markGroundDirty();
}

void MapView::setUnits(UnitSystem units)
{
    if (m_units == units)
        return;
    m_units = units;
    markGroundDirty();
}

void MapView::followVehicle()
{
    m_follow = true;
    if (m_content.vehicle())
        m_viewport.setCentre(*m_content.vehicle());
    markGroundDirty();
}

void MapView::zoomBy(double factor)
{
    zoomAt(QPointF(width() / 2.0, height() / 2.0), factor);
}

void MapView::zoomAt(const QPointF &pixel, double factor)
{
    m_viewport.zoomAt(pixel, factor);
    markGroundDirty();
}

void MapView::pan(const QPointF &pixels)
{
    m_follow = false;
    m_viewport.pan(pixels);
    markGroundDirty();
}

void MapView::paintEvent(QPaintEvent *)
{
    if (m_groundDirty)
        paintGround();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_ground);
    painter.setRenderHint(QPainter::Antialiasing);
    MapPainter(painter, m_content, m_viewport, palette()).paintVehicle();
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void MapView::paintGround()
{
    const qreal ratio = devicePixelRatioF();
    const QSize wanted = size() * ratio;
    if (m_ground.size() != wanted) {
        m_ground = QPixmap(wanted);
        m_ground.setDevicePixelRatio(ratio);
    }
    m_groundDirty = false;
    m_ground.fill(palette().color(QPalette::Base));
    QPainter painter(&m_ground);
    MapPainter(painter, m_content, m_viewport, palette()).paintGround(m_units);
}

void MapView::resizeEvent(QResizeEvent *)
{
    m_viewport.setSize(size());
    markGroundDirty();
}

void MapView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        markGroundDirty();
    QWidget::changeEvent(event);
}

void MapView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton) {
        m_dragFrom = event->position();
        m_dragging = true;
        setCursor(Qt::ClosedHandCursor);
    }
}

void MapView::mouseMoveEvent(QMouseEvent *event)
{
    if (m_dragging) {
        pan(event->position() - m_dragFrom);
        m_dragFrom = event->position();
    }
}

void MapView::mouseReleaseEvent(QMouseEvent *)
{
    m_dragging = false;
    unsetCursor();
}

void MapView::mouseDoubleClickEvent(QMouseEvent *event)
{
    zoomAt(event->position(), 2);
}

void MapView::wheelEvent(QWheelEvent *event)
{
    zoomAt(event->position(), std::pow(1.0015, event->angleDelta().y()));
    event->accept();
}

void MapView::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left: pan({kKeyStep, 0}); break;
    case Qt::Key_Right: pan({-kKeyStep, 0}); break;
    case Qt::Key_Up: pan({0, kKeyStep}); break;
    case Qt::Key_Down: pan({0, -kKeyStep}); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomBy(1.5); break;
    case Qt::Key_Minus: zoomBy(1 / 1.5); break;
    case Qt::Key_Home: followVehicle(); break;
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace skyseal::ui
