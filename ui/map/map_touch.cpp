#include "ui/map/map_touch.h"

#include <QtGui/QGuiApplication>
#include <QtGui/QPointingDevice>
#include <QtGui/QStyleHints>
#include <QtGui/QTouchEvent>
#include <QtWidgets/QWidget>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace skyseal::ui {

namespace {
constexpr double kStill = 12; ///< pixels that a finger moves without meaning to
} // namespace

MapTouch::MapTouch(QObject *parent) : QObject(parent)
{
    m_hold.setSingleShot(true);
    connect(&m_hold, &QTimer::timeout, this, [this] {
        const QPointF at = m_last;
        end(false);
        Q_EMIT held(at);
    });
}

bool MapTouch::handle(const QTouchEvent &event, const QWidget &on)
{
    const auto *device = event.pointingDevice();
    if (!device || device->type() != QInputDevice::DeviceType::TouchScreen)
        return false;
    std::vector<QPointF> down;
    for (const QEventPoint &point : event.points())
        if (point.state() != QEventPoint::Released)
            down.push_back(on.mapFromGlobal(point.globalPosition()));
    if (event.type() == QEvent::TouchBegin && down.size() == 1) {
        m_begin = m_last = down.front();
        m_moved = false;
        m_hold.start(QGuiApplication::styleHints()->mousePressAndHoldInterval());
        Q_EMIT pressed(*m_begin);
        return true;
    }
    if (event.type() == QEvent::TouchCancel || down.empty()) {
        m_pair.reset();
        end(event.type() == QEvent::TouchEnd && !m_moved);
        return true;
    }
    if (down.size() >= 2) {
        end(false);
        const QPointF way = down[1] - down[0];
        const Pair now{(down[0] + down[1]) / 2, std::max(1.0, std::hypot(way.x(), way.y()))};
        if (m_pair)
            Q_EMIT pinched(m_pair->middle, now.middle, now.distance / m_pair->distance);
        m_pair = now;
        return true;
    }
    m_pair.reset();
    if (!m_begin)
        return true;
    m_last = down.front();
    if (!m_moved && (m_last - *m_begin).manhattanLength() > kStill) {
        m_moved = true;
        m_hold.stop();
    }
    if (m_moved)
        Q_EMIT dragged(m_last);
    return true;
}

void MapTouch::end(bool tapped)
{
    m_hold.stop();
    if (std::exchange(m_begin, std::nullopt))
        Q_EMIT released(m_last, tapped);
}

} // namespace skyseal::ui

#include "moc_map_touch.cpp"
