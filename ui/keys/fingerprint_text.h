// Fingerprints and public keys as the key windows show them: whole, in groups, in figures of one width.
#pragma once

#include "core/channel/policy.h"

#include <QtCore/QString>
#include <QtWidgets/QLabel>

namespace skyseal::ui {

/// All 16 groups, in lines of eight or fewer.
QString fingerprintLines(const channel::PublicKey &key, int groupsInALine = 8);

/// A label for such a text, which can be marked and copied by mouse and keyboard.
QLabel *fixedWidthLabel(const QString &text, const char *objectName, const QString &accessibleName, QWidget *parent);

} // namespace skyseal::ui
