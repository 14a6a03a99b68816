// Writes the shown charts and samples to files.
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include <vector>

class QWidget;

namespace skyseal::ui {

/// Writes the widgets, one below the other, as a picture: SVG or the image format of the file's suffix, at twice the resolution
/// of the screen. Returns the error text; empty on success.
QString writePicture(const QString &file, const std::vector<QWidget *> &parts);

/// Writes the whole content or nothing. Returns the error text; empty on success.
QString writeWhole(const QString &file, const QByteArray &content);

} // namespace skyseal::ui
