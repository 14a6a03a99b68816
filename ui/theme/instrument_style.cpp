#include "ui/theme/instrument_style.h"

#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtGui/QHelpEvent>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QGraphicsView>
#include <QtWidgets/QScroller>
#include <QtWidgets/QToolTip>

#include <algorithm>

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

/// Fusion shows the focus only after a Tab: not in a dialog that was opened by keys, nor after Alt and a letter.
template<typename Option> Option withFocusShown(const Option &option)
{
    Option out(option);
    if (out.state & QStyle::State_HasFocus)
        out.state |= QStyle::State_KeyboardFocusChange;
    return out;
}

constexpr int kFusionSpinButton = 16; ///< pixels: width of the buttons of a spin box

/// The part of a list or a scrolled panel that a finger moves; null for other widgets, and for charts, which have gestures of
/// their own.
QWidget *scrolledPart(QWidget *widget)
{
    auto *area = qobject_cast<QAbstractScrollArea *>(widget);
    return area && !qobject_cast<QGraphicsView *>(widget) ? area->viewport() : nullptr;
}

} // namespace

InstrumentStyle::InstrumentStyle(bool touchSized) : QProxyStyle(QStringLiteral("Fusion")), m_touchSized(touchSized) {}

int leastTarget(const QWidget &widget)
{
    const auto *style = qobject_cast<const InstrumentStyle *>(widget.style());
    return style && style->isTouchSized() ? kTouchTarget : 0;
}

void InstrumentStyle::polish(QWidget *widget)
{
    QProxyStyle::polish(widget);
    if (QWidget *part = m_touchSized ? scrolledPart(widget) : nullptr)
        QScroller::grabGesture(part, QScroller::TouchGesture);
    if (qobject_cast<QComboBox *>(widget))
        widget->installEventFilter(this);
}

void InstrumentStyle::unpolish(QWidget *widget)
{
    if (QWidget *part = m_touchSized ? scrolledPart(widget) : nullptr)
        QScroller::ungrabGesture(part);
    if (qobject_cast<QComboBox *>(widget))
        widget->removeEventFilter(this);
    QProxyStyle::unpolish(widget);
}

QSize InstrumentStyle::sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &size,
                                        const QWidget *widget) const
{
    const QSize out = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (!m_touchSized)
        return out;
    switch (type) {
    case CT_PushButton:
    case CT_ToolButton:
    case CT_TabBarTab:
    case CT_MenuBarItem: return out.expandedTo({kTouchTarget, kTouchTarget});
    case CT_CheckBox:
    case CT_RadioButton:
    case CT_ComboBox:
    case CT_LineEdit:
    case CT_ItemViewItem:
    case CT_HeaderSection: return out.expandedTo({0, kTouchTarget});
    case CT_SpinBox: return out.expandedTo({out.width() + kTouchTarget - kFusionSpinButton, kTouchTarget});
    case CT_MenuItem: {
        const auto *item = qstyleoption_cast<const QStyleOptionMenuItem *>(option);
        const bool isLine = item && item->menuItemType == QStyleOptionMenuItem::Separator && item->text.isEmpty();
        return isLine ? out : out.expandedTo({0, kTouchTarget});
    }
    default: return out;
    }
}

/// The buttons of a field with a number are as wide as a finger, and share its height.
QRect InstrumentStyle::subControlRect(ComplexControl control, const QStyleOptionComplex *option, SubControl part,
                                      const QWidget *widget) const
{
    QRect place = QProxyStyle::subControlRect(control, option, part, widget);
    const auto *spin = qstyleoption_cast<const QStyleOptionSpinBox *>(option);
    if (!m_touchSized || control != CC_SpinBox || !spin || spin->buttonSymbols == QAbstractSpinBox::NoButtons)
        return place;
    const int wider = kTouchTarget - kFusionSpinButton;
    const bool isButton = part == SC_SpinBoxUp || part == SC_SpinBoxDown;
    if (part != SC_SpinBoxEditField && !isButton)
        return place;
    if (option->direction == Qt::RightToLeft)
        return isButton ? place.adjusted(0, 0, wider, 0) : place.adjusted(wider, 0, 0, 0);
    return isButton ? place.adjusted(-wider, 0, 0, 0) : place.adjusted(0, 0, -wider, 0);
}

int InstrumentStyle::pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const
{
    if (metric == PM_ToolBarItemMargin || metric == PM_ToolBarFrameWidth)
        return 0;
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    if (!m_touchSized)
        return usual;
    switch (metric) {
    case PM_HeaderDefaultSectionSizeVertical:
    case PM_ScrollBarSliderMin:
    case PM_SliderThickness:
    case PM_SliderControlThickness:
    case PM_SliderLength: return std::max(usual, kTouchTarget);
    // A finger moves the list itself, and what stands between docks is moved now and then: these would take the room of what is
    // read.
    case PM_ScrollBarExtent:
    case PM_SplitterWidth:
    case PM_DockWidgetSeparatorExtent: return std::max(usual, kTouchTarget / 2);
    case PM_DockWidgetTitleBarButtonMargin:
        return (kTouchTarget + 1 - QProxyStyle::pixelMetric(PM_TitleBarButtonIconSize, option, widget)) / 2;
    default: return usual;
    }
}

int InstrumentStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                               QStyleHintReturn *result) const
{
    if (hint == SH_ItemView_ScrollMode && m_touchSized)
        return QAbstractItemView::ScrollPerPixel;
    return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0 : QProxyStyle::styleHint(hint, option, widget, result);
}

int InstrumentStyle::roomOfText(const QStyleOptionComboBox &box, const QWidget *widget) const
{
    constexpr int kTextMargin = 2, kIconGap = 4; // of Fusion
    const int room = proxy()->subControlRect(CC_ComboBox, &box, SC_ComboBoxEditField, widget).width() - kTextMargin;
    return box.currentIcon.isNull() ? room : room - box.iconSize.width() - kIconGap;
}

bool InstrumentStyle::eventFilter(QObject *watched, QEvent *event)
{
    const auto *box = event->type() == QEvent::ToolTip ? qobject_cast<QComboBox *>(watched) : nullptr;
    if (!box || box->isEditable())
        return QProxyStyle::eventFilter(watched, event);
    QStyleOptionComboBox option;
    option.initFrom(box);
    option.subControls = SC_All;
    option.frame = box->hasFrame();
    option.iconSize = box->iconSize();
    option.currentIcon = box->itemIcon(box->currentIndex());
    if (box->fontMetrics().horizontalAdvance(box->currentText()) <= roomOfText(option, box))
        return QProxyStyle::eventFilter(watched, event);
    QString tip = box->currentText().toHtmlEscaped();
    if (!box->toolTip().isEmpty())
        tip += QStringLiteral("<br>") + box->toolTip().toHtmlEscaped();
    QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), QStringLiteral("<span>%1</span>").arg(tip),
                       static_cast<QWidget *>(watched));
    return true;
}

void InstrumentStyle::drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                                  const QWidget *widget) const
{
    const auto *combo = qstyleoption_cast<const QStyleOptionComboBox *>(option);
    if (element != CE_ComboBoxLabel || !combo || combo->editable)
        return QProxyStyle::drawControl(element, option, painter, widget);
    QStyleOptionComboBox ours(*combo);
    ours.currentText = combo->fontMetrics.elidedText(combo->currentText, Qt::ElideRight, roomOfText(*combo, widget));
    QProxyStyle::drawControl(element, &ours, painter, widget);
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
    } else if (const auto *focus = qstyleoption_cast<const QStyleOptionFocusRect *>(option);
               focus && element == PE_FrameFocusRect) {
        const auto ours = withFocusShown(*focus);
        QProxyStyle::drawPrimitive(element, &ours, painter, widget);
    } else if (const auto *button = qstyleoption_cast<const QStyleOptionButton *>(option);
               button && element == PE_PanelButtonCommand) {
        const auto ours = withFocusShown(*button);
        QProxyStyle::drawPrimitive(element, &ours, painter, widget);
    } else
        QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void InstrumentStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                                         const QWidget *widget) const
{
    if (const auto *spin = qstyleoption_cast<const QStyleOptionSpinBox *>(option); spin && control == CC_SpinBox) {
        QStyleOptionSpinBox ours = withFocusShown(*spin);
        ours.palette = edged(*spin);
        QProxyStyle::drawComplexControl(control, &ours, painter, widget);
    } else if (const auto *combo = qstyleoption_cast<const QStyleOptionComboBox *>(option); combo && control == CC_ComboBox) {
        QStyleOptionComboBox ours = withFocusShown(*combo);
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

#include "moc_instrument_style.cpp"
