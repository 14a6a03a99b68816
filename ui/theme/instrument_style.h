// Fusion with the few parts redrawn that disappear in our palettes: the marks of radio buttons and check boxes. Tool bars
// have no margin: the status strip fills its own.
#pragma once

#include <QtWidgets/QProxyStyle>

namespace skyseal::ui {

class InstrumentStyle : public QProxyStyle
{
    Q_OBJECT

public:
    InstrumentStyle();

    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
};

} // namespace skyseal::ui
