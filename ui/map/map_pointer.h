// The pointer over the map: where it is, and what the mouse or a finger does as the map understands it, a drag or a click.
// Lives on the GUI thread.
#pragma once

#include "ui/map/map_touch.h"

#include <QtCore/QObject>
#include <QtCore/QPointF>

#include <optional>

namespace skyseal::ui {

/// Positions in pixels.
class MapPointer : public QObject
{
    Q_OBJECT

public:
    explicit MapPointer(QObject *parent = nullptr);

    /// Of the mouse; nullopt while it is elsewhere.
    const std::optional<QPointF> &position() const { return m_position; }
    bool isDragging() const { return m_drag.has_value(); }

    /// Takes an event of this widget. Returns false for those that are not of a touch screen and are to be handled as usual.
    bool handleTouch(const QTouchEvent &event, const QWidget &on) { return m_touch.handle(event, on); }
    void press(const QPointF &pixel);
    void moveTo(const QPointF &pixel);
    void release(const QPointF &pixel);
    void leave();

Q_SIGNALS:
    void moved();
    void dragBegan();
    void dragged(const QPointF &by);
    void dragEnded();
    /// After dragEnded(), if the pointer stayed where it was.
    void clicked(const QPointF &pixel);
    /// A long press of a finger.
    void held(const QPointF &pixel);
    /// Two fingers: their middle has moved, and their distance has grown by `factor`.
    void pinched(const QPointF &from, const QPointF &to, double factor);

private:
    void drag(const QPointF &pixel);
    void end(const QPointF &pixel, bool isClick);

    struct Drag
    {
        QPointF begin, last;
    };
    MapTouch m_touch;
    std::optional<QPointF> m_position;
    std::optional<Drag> m_drag; ///< while the button or a finger is down
};

} // namespace skyseal::ui
