// The course of a value over the last minute as a small line. Room for it is taken once: a new sample allocates nothing.
#pragma once

#include <QtCore/QRectF>

#include <array>
#include <cstdint>

class QColor;
class QPainter;

namespace skyseal::ui {

class Sparkline
{
public:
    static constexpr double kSeconds = 60;
    static constexpr int kSlots = 240; ///< one for each quarter of a second

    Sparkline() { clear(); }

    /// `time` in seconds of the picture. NaN makes a gap, as times without samples do; a time that goes back begins anew.
    /// Returns true if the sample has a slot of its own, not that of the sample before: something new is to be seen.
    bool add(double time, double value);
    void clear();
    bool isEmpty() const;
    /// The least of the minute; NaN if there is none.
    double lowest() const;
    /// Newest at the right. The line fills the height of `area`, unless the values differ by less than `leastSpan`.
    void paint(QPainter &painter, const QRectF &area, const QColor &color, double leastSpan) const;
    /// The same with a fixed scale: `bottom` and `top` are the values at the edges of `area`.
    void paintWithin(QPainter &painter, const QRectF &area, const QColor &color, double bottom, double top) const;

private:
    std::array<float, kSlots> m_values; ///< a ring: the value of a slot stands at its number modulo kSlots
    std::int64_t m_newest = -1;         ///< number of the newest slot; -1: none
};

} // namespace skyseal::ui
