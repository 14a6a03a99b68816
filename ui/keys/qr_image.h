// A QR code as a picture, by libqrencode.
#pragma once

#include <QtCore/QString>
#include <QtGui/QImage>

namespace skyseal::ui {

/// Returns a QR code of `text` with its quiet zone, one pixel per module; null if the text is too long.
QImage qrImage(const QString &text);

} // namespace skyseal::ui
