// Decoding of tiles. Their bytes come from servers and files that may be hostile: only three formats are read, and only up to
// these limits.
#pragma once

#include "core/base/result.h"

#include <QtCore/QByteArray>
#include <QtGui/QImage>

namespace skyseal::ui {

inline constexpr qsizetype kLargestTile = 1 << 20; ///< bytes
inline constexpr int kWidestTile = 1024;           ///< pixels, also of the height

enum class TileFormat { Unknown, Png, Jpeg, Webp };

/// By its first bytes.
TileFormat tileFormatOf(const QByteArray &bytes);
/// "png", "jpg" or "webp", as MBTiles names them; empty for an unknown format.
QString formatName(TileFormat format);

/// Decodes into RGB32, or ARGB32_Premultiplied if it has transparent parts. The error says, for people, why not. May be called
/// on any thread.
Result<QImage, QString> decodeTile(const QByteArray &bytes);

} // namespace skyseal::ui
