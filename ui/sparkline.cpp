#include "ui/sparkline.h"

#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyseal::ui {

namespace {

constexpr float kGap = std::numeric_limits<float>::quiet_NaN();

std::size_t placeOf(std::int64_t slot)
{
    return static_cast<std::size_t>(slot % Sparkline::kSlots);
}

} // namespace

bool Sparkline::add(double time, double value)
{
    if (!(time >= 0 && time < 1e12))
        return false;
    const auto slot = static_cast<std::int64_t>(time * kSlots / kSeconds);
    if (slot < m_newest)
        clear();
    if (m_newest >= 0) {
        const std::int64_t from = std::max(m_newest + 1, slot - kSlots + 1);
        for (std::int64_t passed = from; passed < slot; ++passed)
            m_values[placeOf(passed)] = kGap;
    }
    const bool isNew = slot != m_newest;
    m_newest = slot;
    m_values[placeOf(slot)] = static_cast<float>(value);
    return isNew;
}

void Sparkline::clear()
{
    m_values.fill(kGap);
    m_newest = -1;
}

bool Sparkline::isEmpty() const
{
    return std::ranges::none_of(m_values, [](float value) { return std::isfinite(value); });
}

double Sparkline::lowest() const
{
    double out = kGap;
    for (const float value : m_values)
        out = std::fmin(out, value); // which prefers a number to NaN
    return out;
}

void Sparkline::paint(QPainter &painter, const QRectF &area, const QColor &color, double leastSpan) const
{
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const float value : m_values) {
        if (std::isfinite(value)) {
            lowest = std::min<double>(lowest, value);
            highest = std::max<double>(highest, value);
        }
    }
    if (lowest > highest)
        return;
    const double span = std::max(highest - lowest, leastSpan);
    const double bottom = (lowest + highest - span) / 2;
    paintWithin(painter, area, color, bottom, bottom + span);
}

void Sparkline::paintWithin(QPainter &painter, const QRectF &area, const QColor &color, double bottom, double top) const
{
    const double span = top - bottom;
    std::array<QPointF, kSlots> run;
    int points = 0;
    const auto drawRun = [&] {
        if (points == 1)
            painter.drawPoint(run[0]);
        else if (points > 1)
            painter.drawPolyline(run.data(), points);
        points = 0;
    };
    painter.setPen(QPen(color, 1.2));
    for (int i = 0; i < kSlots; ++i) {
        const std::int64_t slot = m_newest - kSlots + 1 + i;
        const float value = slot < 0 ? kGap : m_values[placeOf(slot)];
        if (!std::isfinite(value)) {
            drawRun();
            continue;
        }
        const double up = span > 0 ? (value - bottom) / span : 0.5;
        run[static_cast<std::size_t>(points++)] = {area.left() + area.width() * (i + 0.5) / kSlots,
                                                   area.bottom() - up * area.height()};
    }
    drawRun();
}

} // namespace skyseal::ui
