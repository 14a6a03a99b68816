// Fusion with the few parts redrawn that disappear in our palettes: the marks of radio buttons and check boxes, and the edges
// of fields, which Fusion makes darker than the window, however dark that is. Tool bars have no margin: the status strip
// fills its own. Answers have no pictures: a green mark would recommend what may be the dangerous one. Touch-sized, everything
// that is pressed is large enough for a finger, and lists scroll under it. A control that has the focus always shows it,
// however it got it. A choice that is longer than its box ends with an ellipsis, and its tool tip has all of it.
#pragma once

#include <QtCore/QHash>
#include <QtGui/QPalette>
#include <QtWidgets/QProxyStyle>
#include <QtWidgets/QStyleOption>

namespace skyseal::ui {

class InstrumentStyle : public QProxyStyle
{
    Q_OBJECT

public:
    explicit InstrumentStyle(bool touchSized = false);

    bool isTouchSized() const { return m_touchSized; }
    using QProxyStyle::polish;
    using QProxyStyle::unpolish;
    void polish(QWidget *widget) override;
    void unpolish(QWidget *widget) override;
    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                           const QWidget *widget) const override;
    QRect subControlRect(ComplexControl control, const QStyleOptionComplex *option, SubControl part,
                         const QWidget *widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override;
    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget, QStyleHintReturn *result) const override;
    void drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                            const QWidget *widget) const override;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Width of the text in a box of choices, pixels.
    int roomOfText(const QStyleOptionComboBox &box, const QWidget *widget) const;
    /// The palette of a field from which Fusion makes the edge that we want. Kept, since Fusion caches what it drew by palette.
    const QPalette &edged(const QStyleOption &option) const;

    const bool m_touchSized;
    mutable QHash<qint64, QPalette> m_edged, m_edgedDisabled; ///< by the palette that it was made of
};

/// Least side in pixels of what is pressed in this widget, if it sizes that itself: kTouchTarget, or 0 if the mouse presses it.
int leastTarget(const QWidget &widget);

} // namespace skyseal::ui
