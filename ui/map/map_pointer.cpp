#include "ui/map/map_pointer.h"

#include <QtWidgets/QApplication>

#include <utility>

namespace skyseal::ui {

MapPointer::MapPointer(QObject *parent) : QObject(parent)
{
    connect(&m_touch, &MapTouch::pressed, this, &MapPointer::press);
    connect(&m_touch, &MapTouch::dragged, this, &MapPointer::drag);
    connect(&m_touch, &MapTouch::released, this, &MapPointer::end);
    connect(&m_touch, &MapTouch::held, this, &MapPointer::held);
    connect(&m_touch, &MapTouch::pinched, this, &MapPointer::pinched);
}

void MapPointer::press(const QPointF &pixel)
{
    m_drag = Drag{pixel, pixel};
    Q_EMIT dragBegan();
}

void MapPointer::moveTo(const QPointF &pixel)
{
    m_position = pixel;
    Q_EMIT moved();
    drag(pixel);
}

void MapPointer::drag(const QPointF &pixel)
{
    if (m_drag)
        Q_EMIT dragged(pixel - std::exchange(m_drag->last, pixel));
}

void MapPointer::release(const QPointF &pixel)
{
    end(pixel, m_drag && (pixel - m_drag->begin).manhattanLength() < QApplication::startDragDistance());
}

void MapPointer::end(const QPointF &pixel, bool isClick)
{
    const bool wasDown = std::exchange(m_drag, std::nullopt).has_value();
    Q_EMIT dragEnded();
    if (wasDown && isClick)
        Q_EMIT clicked(pixel);
}

void MapPointer::leave()
{
    m_position.reset();
    Q_EMIT moved();
}

} // namespace skyseal::ui

#include "moc_map_pointer.cpp"
