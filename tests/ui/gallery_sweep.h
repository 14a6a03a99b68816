// A sweep of the gallery: finished, and with each kind of note.
#pragma once

#include "ui/window/main_window.h"

namespace skyseal::ui {

/// Shows its results in the window's diagnostics.
void showGallerySweep(MainWindow &window);

} // namespace skyseal::ui
