#include "ui/flight/tape.h"

#include "ui/text/coordinates.h"
#include "ui/text/figures.h"
#include "ui/text/units.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <cmath>

namespace skyseal::ui {

namespace {

QString compassText(int degrees)
{
    switch (degrees) {
    case 0: return compassLetter(Compass::North);
    case 90: return compassLetter(Compass::East);
    case 180: return compassLetter(Compass::South);
    case 270: return compassLetter(Compass::West);
    default: return QString::number(degrees / 10);
    }
}

/// Greater values have no marks: their numbers would not fit the type of a mark.
constexpr double kGreatestShown = 1e7;

qreal crisp(qreal y)
{
    return std::floor(y) + 0.5;
}

} // namespace

void paintVerticalTape(QPainter &painter, const QRectF &area, double value, double step, double pixelsPerUnit, int decimals,
                       bool pointsRight, const TapeStyle &style)
{
    painter.save();
    painter.setClipRect(area);
    painter.fillRect(area, style.back);
    const QFontMetricsF metrics(painter.font());
    const qreal middle = area.center().y();
    const qreal half = std::ceil(metrics.height() / 2) + 1; // of the box with the value
    // A number that is cut off can be misread, so it is omitted.
    const auto fits = [&](qreal y) {
        const qreal reach = metrics.capHeight() / 2 + 2;
        return y - reach >= area.top() && y + reach <= area.bottom() && std::abs(y - middle) >= half + reach - 1;
    };
    const qreal inner = pointsRight ? area.right() : area.left();
    const qreal inward = pointsRight ? -1 : 1;
    if (std::abs(value) <= kGreatestShown) {
        const double reach = area.height() / 2 / pixelsPerUnit;
        const auto first = static_cast<long>(std::ceil((value - reach) / step * 2));
        const auto last = static_cast<long>(std::floor((value + reach) / step * 2));
        for (long i = first; i <= last; ++i) {
            const double at = static_cast<double>(i) * step / 2;
            const qreal y = crisp(middle - (at - value) * pixelsPerUnit);
            const bool major = i % 2 == 0;
            painter.setPen(QPen(style.dim, 1));
            painter.drawLine(QPointF(inner, y), QPointF(inner + inward * (major ? 7 : 4), y));
            if (!major || !fits(y))
                continue;
            painter.setPen(style.ink);
            const QString text = number(at, 0);
            const qreal width = figuresWidth(metrics, text);
            const qreal x = pointsRight ? inner - 10 - width : inner + 10;
            drawFigures(painter, QPointF(x, y + metrics.capHeight() / 2), text);
        }
    }
    QPainterPath box;
    const qreal tip = pointsRight ? area.right() : area.left();
    const qreal shoulder = tip + inward * 6;
    const qreal far = pointsRight ? area.left() + 0.5 : area.right() - 0.5;
    box.moveTo(tip, middle);
    box.lineTo(shoulder, middle - 5);
    box.lineTo(shoulder, middle - half);
    box.lineTo(far, middle - half);
    box.lineTo(far, middle + half);
    box.lineTo(shoulder, middle + half);
    box.lineTo(shoulder, middle + 5);
    box.closeSubpath();
    painter.setPen(QPen(style.ink, 1));
    painter.setBrush(style.box);
    painter.drawPath(box);
    const QString text = number(value, decimals);
    const qreal width = figuresWidth(metrics, text);
    const qreal x = pointsRight ? shoulder - 4 - width : far - 4 - width;
    painter.setPen(style.ink);
    drawFigures(painter, QPointF(x, middle + metrics.capHeight() / 2), text);
    painter.restore();
}

void paintCompassTape(QPainter &painter, const QRectF &area, double heading, const TapeStyle &style)
{
    constexpr double kPixelsPerDegree = 2.4;
    painter.save();
    painter.setClipRect(area);
    painter.fillRect(area, style.back);
    const QFontMetricsF metrics(painter.font());
    const qreal middle = area.center().x();
    if (std::abs(heading) <= kGreatestShown) {
        const double reach = area.width() / 2 / kPixelsPerDegree;
        const auto first = static_cast<long>(std::ceil((heading - reach) / 10));
        const auto last = static_cast<long>(std::floor((heading + reach) / 10));
        for (long i = first; i <= last; ++i) {
            const qreal x = crisp(middle + (static_cast<double>(i) * 10 - heading) * kPixelsPerDegree);
            const int degrees = static_cast<int>(((i % 36) + 36) % 36) * 10;
            const bool major = degrees % 30 == 0;
            painter.setPen(QPen(style.dim, 1));
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.top() + (major ? 6 : 3)));
            if (!major)
                continue;
            const QString text = compassText(degrees);
            const qreal half = metrics.horizontalAdvance(text) / 2;
            if (x - half < area.left() || x + half > area.right())
                continue;
            painter.setPen(degrees % 90 == 0 ? style.ink : style.dim);
            painter.drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, area.bottom() - 4), text);
        }
    }
    QPainterPath mark;
    mark.moveTo(middle, area.top() + 7);
    mark.lineTo(middle - 5, area.top());
    mark.lineTo(middle + 5, area.top());
    mark.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(style.ink);
    painter.drawPath(mark);
    painter.restore();
}

} // namespace skyseal::ui
