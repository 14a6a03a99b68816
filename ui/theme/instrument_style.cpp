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

void InstrumentStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                                    const QWidget *widget) const
{
    if (element == PE_IndicatorRadioButton || element == PE_IndicatorCheckBox)
        drawMark(element == PE_IndicatorRadioButton, *option, *painter);
    else
        QProxyStyle::drawPrimitive(element, option, painter, widget);
}

} // namespace skyseal::ui
