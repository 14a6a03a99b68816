// Writes the shown charts and samples to files. An existing file is replaced when all is written, and stays otherwise.
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include <vector>

class QImage;
class QWidget;

namespace skyseal::ui {

/// Writes the widgets, one below the other, as a picture: SVG or the image format of the file's suffix, at twice the resolution
/// of the screen. Returns the error text with the name of the file; empty on success.
QString writePicture(const QString &file, const std::vector<QWidget *> &parts);
/// Writes in the image format of the file's suffix. Returns as above.
QString writeImage(const QString &file, const QImage &image);
/// Returns as above.
QString writeWhole(const QString &file, const QByteArray &content);

} // namespace skyseal::ui
