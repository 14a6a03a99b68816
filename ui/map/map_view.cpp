#include "ui/map/map_view.h"

#include "ui/theme/grid.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QWheelEvent>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {
constexpr double kNearest = 0.02, kFarthest = 200; ///< metres a pixel
constexpr double kKeyStep = 48;                    ///< pixels
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

QPointF MapView::toPixels(const QPointF &metres) const
{
    const QPointF from = (metres - m_centre) / m_metresPerPixel;
    return {width() / 2.0 + from.x(), height() / 2.0 - from.y()};
}

void MapView::showViewState(const ViewState &view)
{
    if (!view.vehicle)
        return;
    const auto &state = view.vehicle->state;
    if (state.systemId != m_systemId) {
        m_systemId = state.systemId;
        m_track.clear();
        m_frame.reset();
        m_vehicle.reset();
        m_home.reset();
        m_groundDirty = true;
    }
    const vehicle::Position &origin = state.home.known() ? state.home : state.position;
    if (!m_frame && origin.known())
        m_frame = LocalFrame{origin.latitude, origin.longitude};
    if (!m_frame)
        return;

    bool seen = view.stale() != m_stale || state.armed != m_armed;
    m_stale = view.stale();
    m_armed = state.armed;
    m_suite = view.session ? view.session->info.suite : crypto::SuiteId::None;
    if (state.home.known()) {
        const QPointF home = m_frame->toMetres(state.home.latitude, state.home.longitude);
        m_groundDirty |= m_home != home;
        m_home = home;
    }
    if (m_mission != view.vehicle->mission || m_missionCurrent != state.missionCurrent) {
        m_mission = view.vehicle->mission;
        m_missionCurrent = state.missionCurrent;
        m_groundDirty = true;
    }
    if (state.position.known()) {
        const QPointF now = m_frame->toMetres(state.position.latitude, state.position.longitude);
        if (!m_stale)
            m_groundDirty |= m_track.append(now, m_suite);
        const bool moved = !m_vehicle || (now - *m_vehicle).manhattanLength() > m_metresPerPixel * 0.5;
        if (moved) {
            m_vehicle = now;
            seen = true;
            // Follow in steps: the ground is redrawn only when the vehicle leaves the middle of the picture.
            const QPointF off = (now - m_centre) / m_metresPerPixel;
            if (m_follow && !m_dragging && (std::abs(off.x()) > width() / 4.0 || std::abs(off.y()) > height() / 4.0)) {
                m_centre = now;
                m_groundDirty = true;
            }
        }
    }
    const double heading = std::isfinite(state.heading) ? state.heading : m_heading;
    if (std::abs(heading - m_heading) > 0.7) {
        m_heading = heading;
        seen = true;
    }
    if (seen || m_groundDirty)
        update();
}

void MapView::dirty()
{
    m_groundDirty = true;
    update();
}

void MapView::clearTrack()
{
    m_track.clear();
    dirty();
}

void MapView::followVehicle()
{
    m_follow = true;
    if (m_vehicle)
        m_centre = *m_vehicle;
    dirty();
}

void MapView::zoomBy(double factor)
{
    zoomAt(QPointF(width() / 2.0, height() / 2.0), factor);
}

void MapView::zoomAt(const QPointF &pixels, double factor)
{
    const double next = std::clamp(m_metresPerPixel / factor, kNearest, kFarthest);
    const QPointF from(pixels.x() - width() / 2.0, height() / 2.0 - pixels.y());
    m_centre += from * (m_metresPerPixel - next);
    m_metresPerPixel = next;
    dirty();
}

void MapView::pan(const QPointF &pixels)
{
    m_follow = false;
    m_centre += QPointF(-pixels.x(), pixels.y()) * m_metresPerPixel;
    dirty();
}

void MapView::resizeEvent(QResizeEvent *)
{
    dirty();
}

void MapView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        dirty();
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
