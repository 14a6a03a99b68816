// A QR code as a picture, by libqrencode.
#pragma once

#include <QtCore/QString>
#include <QtGui/QImage>

namespace skyseal::ui {

/// A QR code of `text`, one pixel a module with the quiet zone; null when it does not fit.
QImage qrImage(const QString &text);

} // namespace skyseal::ui
