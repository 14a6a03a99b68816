// Which keys may be the shortcut of an action of the window: none that a button, a text, a list or the map needs.
#pragma once

#include <QtGui/QKeySequence>

namespace skyseal::ui {

/// Returns a sentence that says why `keys` cannot be a shortcut; empty if they can, and for no keys.
QString shortcutRefusal(const QKeySequence &keys);

} // namespace skyseal::ui
