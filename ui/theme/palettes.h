// The three palettes of the windows and the colours of state that go with each. Colour never stands alone: a word or a
// shape says the same.
#pragma once

#include <QtGui/QColor>
#include <QtGui/QPalette>

namespace skyseal::ui {

enum class Theme : int { Desktop, Light, Dark, HighContrast };

/// Colours that Qt's palette has no role for.
struct StateColors
{
    QColor good, warning, alarm, dim, line, panel, sky, ground, accent, grid;
    QColor edge; ///< of what can be filled in: at least 3 to 1 against the window and the field (WCAG 2.1, 1.4.11)
};

/// The palette of a theme; `Desktop` gives light or dark after the desktop's own palette.
QPalette paletteOf(Theme theme);

/// The colours that fit `palette`, whichever theme made it.
const StateColors &stateColors(const QPalette &palette);

/// Fusion style, the theme's palette and the application's font settings. Remembers the desktop's palette when called
/// for the first time, so that "Desktop" can be chosen again. `touchSized`: controls are large enough for fingers.
void applyTheme(Theme theme, bool touchSized = false);

bool isDark(const QPalette &palette);

} // namespace skyseal::ui
