// Tab stops only where something is to be seen. Qt parks the tab bars of docks that it may need again beside the window, where
// they still take the focus, and it does not scroll to a control that the focus comes to from outside of its scroll area.
#pragma once

#include <functional>

class QWidget;

namespace skyseal::ui {

/// True if a part of `widget` lies within all widgets around it, up to its window.
bool isInSight(const QWidget &widget);

/// Calls `step`, which moves the focus of `window` to the next control and returns false if there is none, until that control
/// is in sight, scrolling to it where that is possible. Returns false if the focus has not moved.
bool moveFocusInSight(const QWidget &window, const std::function<bool()> &step);

} // namespace skyseal::ui
