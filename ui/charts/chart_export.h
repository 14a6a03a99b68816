// Writes what the diagnostics show into files.
#pragma once

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include <vector>

class QWidget;

namespace skyseal::ui {

/// The widgets below one another as a picture: SVG where the name ends so, otherwise whatever image format the name asks
/// for, at twice the screen's resolution. What went wrong, in words; empty when it was written.
QString writePicture(const QString &file, const std::vector<QWidget *> &parts);

/// What went wrong; empty when all of it was written.
QString writeWhole(const QString &file, const QByteArray &content);

} // namespace skyseal::ui
