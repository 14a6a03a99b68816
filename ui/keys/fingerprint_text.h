// Fingerprints and public keys as text: complete, in groups, in a fixed-width font.
#pragma once

#include "core/channel/policy.h"

#include <QtCore/QString>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// All 16 groups, in lines of eight or fewer.
QString fingerprintLines(const channel::PublicKey &key, int groupsInALine = 8);

/// A label for such a text, selectable by mouse and keyboard.
QLabel *fixedWidthLabel(const QString &text, const char *objectName, const QString &accessibleName, QWidget *parent);

} // namespace skyseal::ui
