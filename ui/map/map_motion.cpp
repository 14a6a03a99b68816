#include "ui/map/map_motion.h"

#include "ui/map/map_viewport.h"

namespace skyseal::ui {

MapMotion::MapMotion(MapViewport &viewport, QObject *parent) : QObject(parent), m_viewport(viewport)
{
    m_ticker.setInterval(kFrameMs);
    m_ticker.setTimerType(Qt::PreciseTimer);
    connect(&m_ticker, &QTimer::timeout, this, &MapMotion::tick);
}

void MapMotion::zoom(const QPointF &pixel, double factor)
{
    m_anchor = pixel;
    m_zoomLeft += std::log2(factor);
    start();
}

void MapMotion::pan(const QPointF &pixels)
{
    m_panLeft += pixels;
    start();
}

void MapMotion::turn(const QPointF &pixel, double heading)
{
    m_pivot = pixel;
    m_heading = heading;
    start();
}

void MapMotion::stop()
{
    m_heading.reset();
    m_zoomLeft = 0;
    m_panLeft = {};
    if (!isMoving())
        return;
    m_ticker.stop();
    Q_EMIT settled();
}

void MapMotion::start()
{
    if (!m_animated) {
        advance(1);
        Q_EMIT moved();
        Q_EMIT settled();
    } else if (!isMoving()) {
        m_since.start();
        m_ticker.start();
    }
}

void MapMotion::tick()
{
    const double passed = static_cast<double>(m_since.restart());
    const double turn = m_heading ? MapViewport::turnBetween(m_viewport.heading(), *m_heading) : 0;
    const bool last = std::abs(m_zoomLeft) < 0.005 && m_panLeft.manhattanLength() < 0.5 && std::abs(turn) < 0.2;
    advance(last ? 1 : 1 - std::exp2(-passed / kHalfLifeMs));
    Q_EMIT moved();
    if (last)
        stop();
}

void MapMotion::advance(double fraction)
{
    const double zoom = m_zoomLeft * fraction;
    const QPointF pan = m_panLeft * fraction;
    m_zoomLeft -= zoom;
    m_panLeft -= pan;
    if (zoom != 0)
        m_viewport.zoomAt(m_anchor, std::exp2(zoom));
    m_viewport.pan(pan);
    if (!m_heading)
        return;
    if (fraction < 1) {
        const double turn = MapViewport::turnBetween(m_viewport.heading(), *m_heading);
        m_viewport.turnAt(m_pivot, m_viewport.heading() + turn * fraction);
    } else {
        m_viewport.turnAt(m_pivot, *m_heading); // exactly
        m_heading.reset();
    }
}

} // namespace skyseal::ui

#include "moc_map_motion.cpp"
