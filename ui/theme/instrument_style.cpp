#include "ui/theme/instrument_style.h"

#include "ui/theme/palettes.h"

#include <QtGui/QPainter>
#include <QtGui/QPainterPath>
#include <QtWidgets/QStyleOption>

namespace skyseal::ui {

namespace {

void drawMark(bool round, const QStyleOption &option, QPainter &painter)
{
    const StateColors &colors = stateColors(option.palette);
    const bool enabled = option.state & QStyle::State_Enabled;
    const bool on = option.state & QStyle::State_On;
    const QPointF middle = QRectF(option.rect).center();
    const QRectF box(middle - QPointF(6.5, 6.5), QSizeF(13, 13));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool focused = option.state & QStyle::State_HasFocus;
    painter.setPen(QPen(focused ? colors.accent : enabled ? colors.dim : colors.line, focused ? 1.6 : 1.2));
    painter.setBrush(option.palette.color(QPalette::Base));
    if (round)
        painter.drawEllipse(box);
    else
        painter.drawRoundedRect(box, 2, 2);
    if (on) {
        const QColor ink = option.palette.color(enabled ? QPalette::Active : QPalette::Disabled, QPalette::WindowText);
        if (round) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(ink);
            painter.drawEllipse(middle, 3.5, 3.5);
        } else {
            QPainterPath tick;
            tick.moveTo(middle + QPointF(-3.5, 0));
            tick.lineTo(middle + QPointF(-1, 3));
            tick.lineTo(middle + QPointF(4, -3));
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(ink, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.drawPath(tick);
        }
    }
    painter.restore();
}

} // namespace

InstrumentStyle::InstrumentStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

int InstrumentStyle::pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const
{
    if (metric == PM_ToolBarItemMargin || metric == PM_ToolBarFrameWidth)
        return 0;
    return QProxyStyle::pixelMetric(metric, option, widget);
}

int InstrumentStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                               QStyleHintReturn *result) const
{
    return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0 : QProxyStyle::styleHint(hint, option, widget, result);
}

void InstrumentStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                                    const QWidget *widget) const
{
    if (element == PE_IndicatorRadioButton || element == PE_IndicatorCheckBox)
        drawMark(element == PE_IndicatorRadioButton, *option, *painter);
    else if (const auto *frame = qstyleoption_cast<const QStyleOptionFrame *>(option);
             frame && (element == PE_FrameLineEdit || element == PE_Frame)) {
        QStyleOptionFrame ours(*frame);
        ours.palette = edged(*frame);
        QProxyStyle::drawPrimitive(element, &ours, painter, widget);
    } else
        QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void InstrumentStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                                         const QWidget *widget) const
{
    if (const auto *spin = qstyleoption_cast<const QStyleOptionSpinBox *>(option); spin && control == CC_SpinBox) {
        QStyleOptionSpinBox ours(*spin);
        ours.palette = edged(*spin);
        QProxyStyle::drawComplexControl(control, &ours, painter, widget);
    } else if (const auto *combo = qstyleoption_cast<const QStyleOptionComboBox *>(option); combo && control == CC_ComboBox) {
        QStyleOptionComboBox ours(*combo);
        ours.palette = edged(*combo);
        QProxyStyle::drawComplexControl(control, &ours, painter, widget);
    } else {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
    }
}

const QPalette &InstrumentStyle::edged(const QStyleOption &option) const
{
    constexpr int kFusionDarkens = 140, kMany = 64;
    const bool enabled = option.state & State_Enabled;
    auto &made = enabled ? m_edged : m_edgedDisabled;
    if (made.size() > kMany)
        made.clear();
    const auto found = made.constFind(option.palette.cacheKey());
    if (found != made.constEnd())
        return *found;
    const StateColors &colors = stateColors(option.palette);
    QPalette palette = option.palette;
    palette.setColor(QPalette::Window, (enabled ? colors.edge : colors.line).lighter(kFusionDarkens));
    palette.setColor(QPalette::Highlight, colors.accent);
    return *made.insert(option.palette.cacheKey(), palette);
}

} // namespace skyseal::ui
