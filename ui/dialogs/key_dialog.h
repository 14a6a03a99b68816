// The station's own public key, as text and as a QR code, to give to an agent; and where the known peers are kept.
#pragma once

#include "core/channel/policy.h"

#include <QtGui/QImage>
#include <QtWidgets/QDialog>

#include <optional>

namespace skyseal::ui {

class KeyDialog : public QDialog
{
    Q_OBJECT

public:
    KeyDialog(const std::optional<channel::PublicKey> &key, const QString &identityFile, const QString &peersFile,
              QWidget *parent = nullptr);
};

/// A QR code of `text`, one pixel a module with the quiet zone; null when it does not fit.
QImage qrImage(const QString &text);

} // namespace skyseal::ui
