// Which checklist belongs to which vehicle, from one start of the program to the next.
#pragma once

class QSettings;

namespace skyseal::ui {

class Preflight;

/// Gives `preflight` the files that are in `store`, and stores its changes there. `store` must outlive it.
void rememberChecklists(Preflight &preflight, QSettings &store);

} // namespace skyseal::ui
