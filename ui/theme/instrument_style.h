// Fusion with the few parts redrawn that disappear in our palettes: the marks of radio buttons and check boxes, and the edges
// of fields, which Fusion makes darker than the window, however dark that is. Tool bars have no margin: the status strip
// fills its own. Answers have no pictures: a green mark would recommend what may be the dangerous one.
#pragma once

#include <QtCore/QHash>
#include <QtGui/QPalette>
#include <QtWidgets/QProxyStyle>

namespace skyseal::ui {

class InstrumentStyle : public QProxyStyle
{
    Q_OBJECT

public:
    InstrumentStyle();

    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override;
    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget, QStyleHintReturn *result) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                            const QWidget *widget) const override;

private:
    /// The palette of a field from which Fusion makes the edge that we want. Kept, since Fusion caches what it drew by palette.
    const QPalette &edged(const QStyleOption &option) const;

    mutable QHash<qint64, QPalette> m_edged, m_edgedDisabled; ///< by the palette that it was made of
};

} // namespace skyseal::ui
