#include "ui/values/value_cell.h"

#include "ui/text/figures.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "ui/view_state.h"

#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

constexpr qreal kUnitGap = 3;
constexpr int kSmallestDigits = 9; ///< pixels

} // namespace

ValueCell::ValueCell(const ValueChoice &choice, QWidget *parent)
    : QLabel(parent), m_choice(choice), m_shown(choice.shownUnit()), m_value(dash())
{
    setObjectName(QStringLiteral("value_") + choice.source.id());
    setAccessibleName(choice.shownCaption());
    setToolTip(choice.source.state ? choice.source.title() : choice.source.id());
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored); // the grid places it
}

void ValueCell::showReading(const ValueReading &reading, UnitSystem units)
{
    const Figure figure = m_choice.source.isNumber() && reading.word.isEmpty()
        ? valueFigure(reading.number, m_shown, m_choice.decimals, units)
        : Figure{!reading.word.isEmpty() ? reading.word : number(reading.number, 0), {}};
    const bool stale = reading.isStale();
    const LimitSide limit = m_choice.sideOf(reading.number);
    QString note = limit == LimitSide::Low ? tr("▼ low") : limit == LimitSide::High ? tr("▲ high") : reading.note;
    // The age of the derived quantities is that of the vehicle, which stands below the grid once.
    if (stale && m_choice.source.field)
        note = note.isEmpty() ? durationText(reading.age) : tr("%1, %2").arg(note, durationText(reading.age));
    const QString title = m_choice.source.state ? m_choice.source.title() : m_choice.source.id();
    QString tip = reading.explanation.isEmpty() ? title : title + QLatin1Char('\n') + reading.explanation;
    if (!reading.note.isEmpty())
        tip += QLatin1Char('\n') + reading.note; // which may be elided
    if (toolTip() != tip)
        setToolTip(tip);
    const bool bad = limit != LimitSide::Within || reading.isBad;
    if (figure.value == m_value && figure.unit == m_unit && note == m_note && stale == m_stale && bad == m_bad)
        return;
    m_value = figure.value;
    m_unit = figure.unit;
    m_note = note;
    m_stale = stale;
    m_bad = bad;
    setText(note.isEmpty() ? figure.text() : figure.text() + QStringLiteral(", ") + note);
    update();
}

void ValueCell::addSample(double time, const ValueReading &reading)
{
    if (!m_choice.line)
        return;
    if (m_line.add(time, !reading.isStale() ? reading.number : vehicle::kUnknown))
        update(QRect(0, height() - kLineHeight, width(), kLineHeight));
}

void ValueCell::clearLine()
{
    m_line.clear();
    update();
}

void ValueCell::setRoom(int digits, int line)
{
    if (digits != m_digits || line != m_lineRoom) {
        m_digits = digits;
        m_lineRoom = line;
        update();
    }
}

QFont ValueCell::captionFont() const
{
    QFont small = font();
    small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1));
    return small;
}

int ValueCell::captionHeight() const
{
    return static_cast<int>(std::ceil(QFontMetricsF(captionFont()).height()));
}

QSize ValueCell::minimumSizeHint() const
{
    const QFontMetricsF metrics(font());
    const qreal width = figuresWidth(metrics, QStringLiteral("-88888.8")) + kUnitGap
        + metrics.horizontalAdvance(QLatin1String("ft/min"));
    return {static_cast<int>(std::ceil(width)) + 2 * kGrid,
            captionHeight() + static_cast<int>(std::ceil(metrics.height())) + kHalfGrid};
}

void ValueCell::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const StateColors &colors = stateColors(palette());
    const QColor ink = m_stale ? colors.dim : m_bad ? colors.alarm : palette().color(QPalette::WindowText);
    const QRectF inner(kGrid, 0, width() - 2 * kGrid, height());
    painter.setFont(captionFont());
    const QFontMetricsF small(painter.font());
    // Neither caption nor note takes the room of the other: each has its half, and what the other leaves.
    const qreal both = inner.width() - (m_note.isEmpty() ? 0 : kHalfGrid);
    const qreal captionWidth = small.horizontalAdvance(m_choice.shownCaption());
    const qreal captionRoom = std::min(captionWidth, std::max(both / 2, both - small.horizontalAdvance(m_note)));
    const QString note = small.elidedText(m_note, Qt::ElideRight, both - captionRoom);
    painter.setPen(colors.dim);
    painter.drawText(QPointF(inner.left(), small.ascent()),
                     small.elidedText(m_choice.shownCaption(), Qt::ElideRight, std::ceil(captionRoom)));
    painter.setPen(m_stale || !m_bad ? colors.dim : colors.alarm);
    painter.drawText(QPointF(inner.right() - small.horizontalAdvance(note), small.ascent()), note);

    QFont digits = font();
    const auto widthOf = [&](const QFont &at) {
        const qreal unit = m_unit.isEmpty() ? 0 : kUnitGap + small.horizontalAdvance(m_unit);
        return figuresWidth(QFontMetricsF(at), m_value) + unit;
    };
    int size = std::max(m_digits, kSmallestDigits);
    digits.setPixelSize(size);
    while (size > kSmallestDigits && widthOf(digits) > inner.width())
        digits.setPixelSize(--size);
    const QFontMetricsF metrics(digits);
    const qreal top = captionHeight(), room = height() - top - m_lineRoom;
    const qreal baseline = top + (room + metrics.capHeight()) / 2;
    qreal right = inner.right();
    if (!m_unit.isEmpty()) {
        right -= small.horizontalAdvance(m_unit);
        painter.setPen(colors.dim);
        painter.drawText(QPointF(right, baseline), m_unit);
        right -= kUnitGap;
    }
    painter.setFont(digits);
    painter.setPen(ink);
    const QString shown = widthOf(digits) > inner.width() ? metrics.elidedText(m_value, Qt::ElideRight, right - inner.left())
                                                          : m_value;
    drawFigures(painter, QPointF(std::max(inner.left(), right - figuresWidth(metrics, shown)), baseline), shown);
    if (m_choice.line) {
        painter.setRenderHint(QPainter::Antialiasing);
        const double step = std::pow(10.0, -(m_choice.decimals >= 0 ? m_choice.decimals : m_shown.decimals));
        m_line.paint(painter, QRectF(inner.left(), height() - m_lineRoom + 1, inner.width(), m_lineRoom - 4), ink, 5 * step);
    }
}

} // namespace skyseal::ui

#include "moc_value_cell.cpp"
