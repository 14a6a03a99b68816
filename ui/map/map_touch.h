// Reads the fingers on a touch screen as what the map understands: a tap, a drag, a long press, and two fingers that zoom
// and move. Lives on the GUI thread.
#pragma once

#include <QtCore/QObject>
#include <QtCore/QPointF>
#include <QtCore/QTimer>

#include <optional>

class QTouchEvent;
class QWidget;

namespace skyseal::ui {

/// A finger that has held a place or was joined by a second one starts nothing else until all are up. Positions in pixels.
class MapTouch : public QObject
{
    Q_OBJECT

public:
    explicit MapTouch(QObject *parent = nullptr);

    /// Takes an event of this widget. Returns false for those that are not of a touch screen and are to be handled as usual.
    bool handle(const QTouchEvent &event, const QWidget &on);

Q_SIGNALS:
    void pressed(const QPointF &pixel);
    void dragged(const QPointF &pixel);
    /// The end of what pressed() began; `tapped` if the finger stayed where it was.
    void released(const QPointF &pixel, bool tapped);
    void held(const QPointF &pixel);
    /// Two fingers: their middle has moved, and their distance has grown by `factor`.
    void pinched(const QPointF &from, const QPointF &to, double factor);

private:
    void end(bool tapped);

    struct Pair
    {
        QPointF middle;
        double distance;
    };
    QTimer m_hold;
    std::optional<QPointF> m_begin; ///< of the finger that taps, drags or holds
    QPointF m_last;
    bool m_moved = false;
    std::optional<Pair> m_pair;
};

} // namespace skyseal::ui
