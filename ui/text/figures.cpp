#include "ui/text/figures.h"

#include "ui/theme/palettes.h"

#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

constexpr qreal kUnitGap = 4;

qreal widestDigit(const QFontMetricsF &metrics)
{
    qreal widest = 0;
    for (char16_t digit = u'0'; digit <= u'9'; ++digit)
        widest = std::max(widest, metrics.horizontalAdvance(QChar(digit)));
    return widest;
}

/// Whether the digits of a font are of one width. Where they are not, 1 is narrower than 0.
bool digitsAreEven(const QFontMetricsF &metrics)
{
    return std::abs(metrics.horizontalAdvance(u'1') - metrics.horizontalAdvance(u'0')) < 0.01;
}

} // namespace

qreal figuresWidth(const QFontMetricsF &metrics, const QString &text)
{
    if (digitsAreEven(metrics))
        return metrics.horizontalAdvance(text);
    const qreal digit = widestDigit(metrics);
    qreal width = 0;
    for (const QChar c : text)
        width += c.isDigit() ? digit : metrics.horizontalAdvance(c);
    return width;
}

void drawFigures(QPainter &painter, const QPointF &at, const QString &text)
{
    const QFontMetricsF metrics(painter.font());
    if (digitsAreEven(metrics)) {
        painter.drawText(at, text);
        return;
    }
    const qreal digit = widestDigit(metrics);
    qreal x = at.x();
    for (const QChar c : text) {
        const qreal own = metrics.horizontalAdvance(c);
        const qreal cell = c.isDigit() ? digit : own;
        painter.drawText(QPointF(x + (cell - own) / 2, at.y()), QString(c));
        x += cell;
    }
}

FigureLabel::FigureLabel(QWidget *parent) : QLabel(parent)
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
}

void FigureLabel::setSample(const QString &value, const QString &unit)
{
    m_sampleValue = value;
    m_sampleUnit = unit;
    updateGeometry();
}

void FigureLabel::setFigure(const QString &value, const QString &unit)
{
    if (value == m_value && unit == m_unit)
        return;
    const bool wider = widthOf(value, unit) > std::max(widthOf(m_value, m_unit), widthOf(m_sampleValue, m_sampleUnit));
    m_value = value;
    m_unit = unit;
    setText(unit.isEmpty() ? value : value + QLatin1Char(' ') + unit); // what assistive technology reads
    if (wider)
        updateGeometry();
    update();
}

void FigureLabel::setStale(bool stale)
{
    if (stale != m_stale) {
        m_stale = stale;
        update();
    }
}

void FigureLabel::setColor(const QColor &color)
{
    if (color != m_color) {
        m_color = color;
        update();
    }
}

qreal FigureLabel::widthOf(const QString &value, const QString &unit) const
{
    const QFontMetricsF metrics(font());
    return figuresWidth(metrics, value) + (unit.isEmpty() ? 0 : kUnitGap + metrics.horizontalAdvance(unit));
}

QSize FigureLabel::sizeHint() const
{
    const qreal width = std::max(widthOf(m_value, m_unit), widthOf(m_sampleValue, m_sampleUnit));
    return {static_cast<int>(std::ceil(width)) + 1, static_cast<int>(std::ceil(QFontMetricsF(font()).height())) + 2};
}

QSize FigureLabel::minimumSizeHint() const
{
    return sizeHint();
}

void FigureLabel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const QFontMetricsF metrics(font());
    const QColor dim = stateColors(palette()).dim;
    const QColor strong = m_color.isValid() ? m_color : palette().color(QPalette::WindowText);
    const qreal baseline = (height() + metrics.ascent() - metrics.descent()) / 2;
    const qreal unitRoom = std::max(m_unit.isEmpty() ? 0 : metrics.horizontalAdvance(m_unit),
                                    m_sampleUnit.isEmpty() ? 0 : metrics.horizontalAdvance(m_sampleUnit));
    qreal right = width();
    if (!(alignment() & Qt::AlignRight))
        right = std::min<qreal>(right, widthOf(m_value, m_unit));
    if (unitRoom > 0) {
        painter.setPen(dim);
        painter.drawText(QPointF(right - unitRoom, baseline), m_unit);
        right -= unitRoom + kUnitGap;
    }
    painter.setPen(m_stale ? dim : strong);
    drawFigures(painter, QPointF(right - figuresWidth(metrics, m_value), baseline), m_value);
}

} // namespace skyseal::ui

#include "moc_figures.cpp"
