#include "ui/flight/horizon.h"

#include "ui/flight/tape.h"
#include "ui/text/figures.h"
#include "ui/theme/palettes.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

constexpr int kTape = 52;
constexpr int kCompass = 24;
constexpr double kDegreesShown = 50; ///< over the height of the picture
constexpr double kTallest = 1.2;     ///< height by width from which a taller picture shows more degrees instead

double rollRadius(const QRectF &area)
{
    return std::min(area.width(), area.height()) / 2 - 6;
}

bool differs(double a, double b, double by)
{
    return std::isfinite(a) != std::isfinite(b) || (std::isfinite(a) && std::abs(a - b) >= by);
}

} // namespace

Horizon::Horizon(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Artificial horizon"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void Horizon::showValues(const HorizonValues &values)
{
    const HorizonValues &old = m_values;
    const bool seen = values.stale != old.stale || differs(values.roll, old.roll, 0.15)
        || differs(values.pitch, old.pitch, 0.15) || differs(values.heading, old.heading, 0.3)
        || differs(values.speed, old.speed, 0.05) || differs(values.altitude, old.altitude, 0.05);
    if (!seen)
        return;
    m_values = values;
    setAccessibleDescription(
        tr("roll %1°, pitch %2°, heading %3°").arg(number(values.roll, 0), number(values.pitch, 0), number(values.heading, 0)));
    update();
}

void Horizon::setUnits(UnitSystem units)
{
    m_units = units;
    update();
}

void Horizon::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const StateColors &colors = stateColors(palette());
    QFont small = font();
    small.setPointSizeF(std::max(7.0, font().pointSizeF() - 1));
    painter.setFont(small);

    const QRectF world(kTape, 0, width() - 2 * kTape, height() - kCompass);
    paintWorld(painter, world);
    paintNumbers(painter, world);

    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = m_values.stale ? colors.dim : palette().color(QPalette::WindowText);
    const TapeStyle style{colors.panel, ink, colors.dim, palette().color(QPalette::Base)};
    const QRectF left(0, 0, kTape, height() - kCompass);
    const QRectF right(width() - kTape, 0, kTape, height() - kCompass);
    const UnitScale altitudes = altitudeScale(m_units);
    const double altitudeStep = m_units == UnitSystem::Metric ? 5 : 20;
    paintVerticalTape(painter, left, m_values.speed, 2, 11, 1, true, style);
    paintVerticalTape(painter, right, m_values.altitude, altitudeStep, 22.0 / altitudeStep, altitudes.decimals, false, style);
    painter.fillRect(QRectF(0, height() - kCompass, width(), kCompass), colors.panel);
    paintCompassTape(painter, QRectF(kTape, height() - kCompass, width() - 2 * kTape, kCompass), m_values.heading, style);

    painter.setPen(colors.dim);
    painter.drawText(QRectF(0, height() - kCompass, kTape, kCompass), Qt::AlignCenter, QLatin1String(speedScale(m_units).name));
    painter.drawText(QRectF(width() - kTape, height() - kCompass, kTape, kCompass), Qt::AlignCenter,
                     QLatin1String(altitudes.name));
    painter.setPen(colors.line);
    painter.drawLine(QPointF(0, height() - kCompass + 0.5), QPointF(width(), height() - kCompass + 0.5));
}

void Horizon::paintWorld(QPainter &painter, const QRectF &area) const
{
    const StateColors &colors = stateColors(palette());
    painter.save();
    painter.setClipRect(area);
    if (!std::isfinite(m_values.roll) || !std::isfinite(m_values.pitch)) {
        painter.fillRect(area, colors.panel);
        painter.setPen(colors.dim);
        painter.drawText(area, Qt::AlignCenter, tr("no attitude"));
        painter.restore();
        return;
    }
    const double pixelsPerDegree = std::min(area.height(), kTallest * area.width()) / kDegreesShown;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(area.center());
    painter.rotate(-m_values.roll);
    const double horizon = m_values.pitch * pixelsPerDegree;
    const double far = area.width() + area.height() + 90 * pixelsPerDegree;
    const auto shade = [&](QColor color) { return m_values.stale ? QColor::fromHsl(0, 0, color.lightness()) : color; };
    painter.fillRect(QRectF(-far, horizon - 2 * far, 2 * far, 2 * far), shade(colors.sky));
    painter.fillRect(QRectF(-far, horizon, 2 * far, 2 * far), shade(colors.ground));
    painter.setPen(QPen(Qt::white, 1.5));
    painter.drawLine(QPointF(-far, horizon), QPointF(far, horizon));
    paintLadder(painter, pixelsPerDegree, rollRadius(area) - 22);
    painter.restore();

    painter.save();
    painter.setClipRect(area);
    painter.setRenderHint(QPainter::Antialiasing);
    paintRollScale(painter, area);
    paintAircraft(painter, area);
    painter.restore();
}

void Horizon::paintLadder(QPainter &painter, double pixelsPerDegree, double reach) const
{
    const QFontMetricsF metrics(painter.font());
    painter.setPen(QPen(QColor(255, 255, 255, 210), 1));
    const int middle = static_cast<int>(std::lround(m_values.pitch / 5));
    for (int i = middle - 4; i <= middle + 4; ++i) {
        const int degrees = i * 5;
        if (degrees == 0 || std::abs(degrees) > 90)
            continue;
        const double y = (m_values.pitch - degrees) * pixelsPerDegree;
        if (std::abs(y) > reach)
            continue; // keeps clear of the roll scale
        const double half = degrees % 10 == 0 ? 22 : 10;
        painter.drawLine(QPointF(-half, y), QPointF(half, y));
        if (degrees % 10 != 0)
            continue;
        const QString text = QString::number(std::abs(degrees));
        painter.drawText(QPointF(half + 4, y + metrics.capHeight() / 2), text);
        painter.drawText(QPointF(-half - 4 - metrics.horizontalAdvance(text), y + metrics.capHeight() / 2), text);
    }
}

void Horizon::paintRollScale(QPainter &painter, const QRectF &area) const
{
    const double radius = rollRadius(area);
    painter.translate(area.center());
    painter.setPen(QPen(QColor(255, 255, 255, 210), 1.2));
    for (const int degrees : {-60, -45, -30, -20, -10, 0, 10, 20, 30, 45, 60}) {
        painter.save();
        painter.rotate(degrees);
        const double length = degrees % 30 == 0 ? 8 : 5;
        painter.drawLine(QPointF(0, -radius), QPointF(0, -radius + length));
        painter.restore();
    }
    painter.save();
    painter.rotate(-m_values.roll);
    QPainterPath pointer;
    pointer.moveTo(0, -radius + 9);
    pointer.lineTo(-5, -radius + 17);
    pointer.lineTo(5, -radius + 17);
    pointer.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawPath(pointer);
    painter.restore();
    painter.translate(-area.center());
}

void Horizon::paintAircraft(QPainter &painter, const QRectF &area) const
{
    painter.translate(area.center());
    QPainterPath wings;
    for (const int side : {-1, 1}) {
        wings.moveTo(side * 44, 0);
        wings.lineTo(side * 18, 0);
        wings.lineTo(side * 18, 7);
    }
    for (const auto &[color, width] : {std::pair{QColor(0, 0, 0, 150), 5.0}, std::pair{QColor(0xffd23f), 3.0}}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(wings);
        painter.drawPoint(QPointF(0, 0));
    }
    painter.translate(-area.center());
}

/// Roll, heading and pitch, as captions above figures, on a dark band that every sky and ground leaves legible.
void Horizon::paintNumbers(QPainter &painter, const QRectF &area) const
{
    const QFontMetricsF metrics(painter.font());
    const double height = 2 * metrics.height() + 2;
    const QRectF band(area.left(), area.bottom() - height, area.width(), height);
    painter.fillRect(band, QColor(0, 0, 0, 150));
    const QString degree = QStringLiteral("°");
    const std::pair<QString, QString> columns[] = {
        {tr("roll"), number(m_values.roll, 0) + degree},
        {tr("hdg"), headingFigure(m_values.heading).value + degree},
        {tr("pitch"), number(m_values.pitch, 0) + degree},
    };
    const double width = band.width() / static_cast<double>(std::size(columns));
    double left = band.left();
    for (const auto &[caption, figure] : columns) {
        const double middle = left + width / 2;
        painter.setPen(QColor(255, 255, 255, 200));
        painter.drawText(QPointF(middle - metrics.horizontalAdvance(caption) / 2, band.top() + 1 + metrics.ascent()), caption);
        painter.setPen(m_values.stale ? QColor(190, 190, 190) : QColor(Qt::white));
        drawFigures(painter, QPointF(middle - figuresWidth(metrics, figure) / 2, band.bottom() - 1 - metrics.descent()),
                    figure);
        left += width;
    }
}

} // namespace skyseal::ui

#include "moc_horizon.cpp"
