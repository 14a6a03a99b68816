#include "ui/status/strip_item.h"

#include "ui/text/figures.h"
#include "ui/theme/grid.h"
#include "ui/theme/icons.h"
#include "ui/theme/instrument_style.h"
#include "ui/theme/palettes.h"

#include <QtGui/QKeyEvent>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {
constexpr int kIcon = 16;
constexpr int kIconGap = 6;
constexpr int kLine = 6 * kGrid;
constexpr double kWhole = 100; ///< percent
} // namespace

bool TextWidths::setTexts(const QStringList &texts)
{
    if (texts == m_texts)
        return false;
    m_texts = texts;
    forget();
    return true;
}

qreal TextWidths::widthOf(int index, const QFont &font) const
{
    if (index < 0 || index >= m_texts.size())
        return 0;
    qreal &width = m_widths[static_cast<std::size_t>(index)];
    if (width < 0)
        width = figuresWidth(QFontMetricsF(font), m_texts[index]);
    return width;
}

void TextWidths::forget()
{
    m_widths.assign(static_cast<std::size_t>(m_texts.size()), -1);
}

StripItem::StripItem(const QString &accessibleName, QWidget *parent) : QAbstractButton(parent)
{
    setAccessibleName(accessibleName);
    setClickable(false);
}

void StripItem::setContent(const QStringList &variants, const QString &iconName)
{
    if (variants == m_variants.texts() && iconName == m_icon)
        return;
    const int before = variantCount() ? widthOf(m_variant) : 0;
    m_variants.setTexts(variants);
    m_icon = iconName;
    m_variant = std::min(m_variant, std::max(0, variantCount() - 1));
    setText(variants.value(0)); // assistive technology reads the whole text
    update();
    if (widthOf(m_variant) != before)
        Q_EMIT widthChanged();
}

void StripItem::setSamples(const QStringList &samples)
{
    const int before = widthOf(m_variant);
    if (m_samples.setTexts(samples) && widthOf(m_variant) != before)
        Q_EMIT widthChanged();
}

void StripItem::setIconColor(const QColor &color)
{
    if (color != m_iconColor) {
        m_iconColor = color;
        update();
    }
}

void StripItem::setTextColor(const QColor &color)
{
    if (color != m_textColor) {
        m_textColor = color;
        update();
    }
}

void StripItem::setStrong(bool strong)
{
    if (strong != m_strong) {
        m_strong = strong;
        forgetWidths();
        update();
        Q_EMIT widthChanged();
    }
}

void StripItem::setClickable(bool clickable)
{
    m_clickable = clickable;
    setFocusPolicy(clickable ? Qt::TabFocus : Qt::NoFocus);
    setCursor(clickable ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void StripItem::setLine(bool on)
{
    m_hasLine = on;
    Q_EMIT widthChanged();
}

void StripItem::addSample(double time, double percent)
{
    if (m_line.add(time, percent) && lineRoom(m_variant) > 0)
        update();
}

void StripItem::clearLine()
{
    m_line.clear();
    update();
}

int StripItem::lineRoom(int variant) const
{
    return m_hasLine && variant + 1 < variantCount() ? kLine + kIconGap : 0;
}

void StripItem::forgetWidths()
{
    m_variants.forget();
    m_samples.forget();
}

void StripItem::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        forgetWidths();
    QAbstractButton::changeEvent(event);
}

/// Like the space bar, which is the key of buttons.
void StripItem::keyPressEvent(QKeyEvent *event)
{
    if (m_clickable && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

QFont StripItem::textFont() const
{
    QFont font = this->font();
    if (m_strong)
        font.setWeight(QFont::DemiBold);
    return font;
}

int StripItem::widthOf(int variant) const
{
    const QFont font = textFont();
    const qreal text = std::max(m_variants.widthOf(variant, font), m_samples.widthOf(variant, font));
    const int iconRoom = m_icon.isEmpty() ? 0 : kIcon + kIconGap;
    return static_cast<int>(std::ceil(text)) + 1 + iconRoom + lineRoom(variant) + 2 * kGrid;
}

void StripItem::setVariant(int variant)
{
    if (variant != m_variant) {
        m_variant = variant;
        update();
    }
}

QSize StripItem::sizeHint() const
{
    return {widthOf(m_variant), std::max(4 * kGrid, leastTarget(*this))};
}

void StripItem::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_clickable && (underMouse() || hasFocus())) {
        QColor wash = palette().color(QPalette::WindowText);
        wash.setAlphaF(0.07f);
        painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight), 1.5) : Qt::NoPen);
        painter.setBrush(wash);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 3, -1, -3), 4, 4);
    }
    const QColor text = m_textColor.isValid() ? m_textColor : palette().color(QPalette::WindowText);
    qreal x = kGrid;
    if (!m_icon.isEmpty()) {
        const QColor color = m_iconColor.isValid() ? m_iconColor : text;
        painter.drawPixmap(QPointF(x, (height() - kIcon) / 2.0), iconPixmap(m_icon, kIcon, color, devicePixelRatioF()));
        x += kIcon + kIconGap;
    }
    if (const int room = lineRoom(m_variant); room > 0) {
        const QRectF area(x, height() / 4.0, kLine, height() / 2.0);
        painter.setPen(stateColors(palette()).dim);
        painter.drawLine(area.bottomLeft(), area.bottomRight()); // 0 %
        m_line.paintWithin(painter, area, text, 0, kWhole);
        x += room;
    }
    painter.setFont(textFont());
    painter.setPen(text);
    const QFontMetricsF metrics(textFont());
    drawFigures(painter, QPointF(x, (height() + metrics.ascent() - metrics.descent()) / 2),
                m_variants.texts().value(m_variant));
}

} // namespace skyseal::ui

#include "moc_strip_item.cpp"
