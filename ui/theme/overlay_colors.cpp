#include "ui/theme/overlay_colors.h"

#include "ui/theme/palettes.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct OverlayColorsText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::OverlayColor)
};

} // namespace

QColor overlayColor(OverlayColor color, const QPalette &palette)
{
    const bool dark = isDark(palette);
    switch (color) {
    case OverlayColor::Blue: return dark ? 0x7ab4ff : 0x1a56c4;
    case OverlayColor::Orange: return dark ? 0xffb454 : 0xb85c00;
    case OverlayColor::Red: return dark ? 0xff7b72 : 0xb3202a;
    case OverlayColor::Green: return dark ? 0x6fd08c : 0x1d7a3a;
    case OverlayColor::Purple: return dark ? 0xd2a8ff : 0x7a3db8;
    case OverlayColor::Grey: break;
    }
    return dark ? 0xc4c9d0 : 0x565c64;
}

QString overlayColorText(OverlayColor color)
{
    switch (color) {
    case OverlayColor::Blue: return OverlayColorsText::tr("Blue");
    case OverlayColor::Orange: return OverlayColorsText::tr("Orange");
    case OverlayColor::Red: return OverlayColorsText::tr("Red");
    case OverlayColor::Green: return OverlayColorsText::tr("Green");
    case OverlayColor::Purple: return OverlayColorsText::tr("Purple");
    case OverlayColor::Grey: break;
    }
    return OverlayColorsText::tr("Grey");
}

} // namespace skyseal::ui
