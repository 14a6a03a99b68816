// The dialogs of the gallery, each filled as an operator would see it.
#pragma once

#include "fake_keyring.h"
#include "fake_pairing.h"
#include "ui/window/main_window.h"

namespace skyseal::ui {

/// Names of all of them.
QStringList dialogStates();

/// Keys and peers of a station that has been used for a while.
void fillKeyring(FakeKeyring &keyring);

/// Opens the dialog by its name, as a child of the window; null for an unknown name.
QWidget *openDialog(const QString &state, MainWindow &window, FakeKeyring &keyring, FakePairing &pairing);

} // namespace skyseal::ui
