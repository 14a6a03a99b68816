#include "ui/theme/palettes.h"

#include "ui/theme/instrument_style.h"

#include <QtWidgets/QApplication>

namespace skyseal::ui {

namespace {

struct Shades
{
    QRgb window, base, alternate, button, text, dimText, highlight, highlightText, tipBase, light, mid, dark;
};

constexpr Shades kLight{0xfff3f4f6, 0xffffffff, 0xfff7f8fa, 0xfffcfcfd, 0xff1b1f24, 0xff6a737d,
                        0xff2f6fb3, 0xffffffff, 0xffffffff, 0xffffffff, 0xffc9ced6, 0xff9aa2ad};
constexpr Shades kDark{0xff1e2227, 0xff171a1e, 0xff1b1f24, 0xff2a2f36, 0xffe3e6ea, 0xff8d96a1,
                       0xff3d84c6, 0xffffffff, 0xff2a2f36, 0xff3a4149, 0xff3a4149, 0xff0d0f12};
constexpr Shades kContrast{0xff000000, 0xff000000, 0xff0c0c0c, 0xff303030, 0xffffffff, 0xffd6d6d6,
                           0xffffe100, 0xff000000, 0xff000000, 0xffffffff, 0xffffffff, 0xffffffff};

QPalette make(const Shades &s)
{
    QPalette p;
    const auto all = [&](QPalette::ColorRole role, QRgb color) { p.setColor(role, QColor::fromRgb(color)); };
    all(QPalette::Window, s.window);
    all(QPalette::WindowText, s.text);
    all(QPalette::Base, s.base);
    all(QPalette::AlternateBase, s.alternate);
    all(QPalette::Text, s.text);
    all(QPalette::PlaceholderText, s.dimText);
    all(QPalette::Button, s.button);
    all(QPalette::ButtonText, s.text);
    all(QPalette::BrightText, s.text);
    all(QPalette::ToolTipBase, s.tipBase);
    all(QPalette::ToolTipText, s.text);
    all(QPalette::Highlight, s.highlight);
    all(QPalette::HighlightedText, s.highlightText);
    all(QPalette::Link, s.highlight);
    all(QPalette::LinkVisited, s.highlight);
    all(QPalette::Light, s.light);
    all(QPalette::Midlight, s.light);
    all(QPalette::Mid, s.mid);
    all(QPalette::Dark, s.dark);
    all(QPalette::Shadow, s.dark);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, QColor::fromRgb(s.dimText));
    p.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgb(s.mid));
    return p;
}

const StateColors kLightState{QColor(0x1a7f4b), QColor(0x9a5b00), QColor(0xb3261e), QColor(0x6a737d),
                              QColor(0xd5d9df), QColor(0xffffff), QColor(0x5a97c7), QColor(0x94765a),
                              QColor(0x2f6fb3), QColor(0xe3e6ea), QColor(0x737b85)};
const StateColors kDarkState{QColor(0x4cc38a), QColor(0xf0b429), QColor(0xff7b72), QColor(0x8d96a1),
                             QColor(0x343a42), QColor(0x23282e), QColor(0x2f628f), QColor(0x5f4a37),
                             QColor(0x58a6e8), QColor(0x262b31), QColor(0x6f7883)};
const StateColors kContrastState{QColor(0x5cff9d), QColor(0xffe100),  QColor(0xff8a80), QColor(0xd6d6d6),
                                 QColor(0x8a8a8a), QColor(Qt::black), QColor(0x0050a0), QColor(0x5a3c1e),
                                 QColor(0xffe100), QColor(0x3a3a3a),  QColor(0xb4b4b4)};

} // namespace

bool isDark(const QPalette &palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

const StateColors &stateColors(const QPalette &palette)
{
    if (palette.color(QPalette::Window) == QColor(Qt::black))
        return kContrastState;
    return isDark(palette) ? kDarkState : kLightState;
}

QPalette paletteOf(Theme theme)
{
    static const bool desktopIsDark = isDark(QGuiApplication::palette());
    switch (theme) {
    case Theme::Light: return make(kLight);
    case Theme::Dark: return make(kDark);
    case Theme::HighContrast: return make(kContrast);
    case Theme::Desktop: break;
    }
    return make(desktopIsDark ? kDark : kLight);
}

void applyTheme(Theme theme, bool touchSized)
{
    const QPalette palette = paletteOf(theme);
    const auto *style = qobject_cast<InstrumentStyle *>(QApplication::style());
    if (!style || style->isTouchSized() != touchSized)
        QApplication::setStyle(new InstrumentStyle(touchSized));
    QApplication::setPalette(palette);
}

} // namespace skyseal::ui
