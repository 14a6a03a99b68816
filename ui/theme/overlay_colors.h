// The colours of the files that are drawn over the map, which the operator chooses by their words.
#pragma once

#include <QtGui/QColor>
#include <QtGui/QPalette>

namespace skyseal::ui {

enum class OverlayColor : int { Blue, Orange, Red, Green, Purple, Grey };
inline constexpr int kOverlayColors = 6;

/// As fits the theme.
QColor overlayColor(OverlayColor color, const QPalette &palette);
/// "Blue", "Orange", …
QString overlayColorText(OverlayColor color);

} // namespace skyseal::ui
