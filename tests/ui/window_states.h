// The states that the window can be in, by name, for tests that look at each.
#pragma once

#include "fake_station.h"
#include "ui/window/main_window.h"

namespace skyseal::ui {

/// One row for each state, which enterState() knows.
void addWindowStates();
void enterState(const QString &state, MainWindow &window, FakeStation &station);

} // namespace skyseal::ui
