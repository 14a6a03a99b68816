#include "ui/tiles/tile_image.h"

#include <QtCore/QBuffer>
#include <QtCore/QCoreApplication>
#include <QtGui/QImageReader>

namespace skyseal::ui {

namespace {

struct TileImageText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::TileImage)
};

/// The names of Qt's readers.
const char *readerOf(TileFormat format)
{
    switch (format) {
    case TileFormat::Png: return "png";
    case TileFormat::Jpeg: return "jpeg";
    case TileFormat::Webp: return "webp";
    case TileFormat::Unknown: break;
    }
    return "";
}

} // namespace

TileFormat tileFormatOf(const QByteArray &bytes)
{
    if (bytes.startsWith(QByteArrayLiteral("\x89PNG\r\n\x1a\n")))
        return TileFormat::Png;
    if (bytes.startsWith(QByteArrayLiteral("\xff\xd8\xff")))
        return TileFormat::Jpeg;
    if (bytes.startsWith(QByteArrayLiteral("RIFF")) && bytes.mid(8, 4) == QByteArrayLiteral("WEBP"))
        return TileFormat::Webp;
    return TileFormat::Unknown;
}

QString formatName(TileFormat format)
{
    return format == TileFormat::Jpeg ? QStringLiteral("jpg") : QLatin1String(readerOf(format));
}

Result<QImage, QString> decodeTile(const QByteArray &bytes)
{
    if (bytes.size() > kLargestTile)
        return tl::unexpected(TileImageText::tr("a tile is larger than %1 kB").arg(kLargestTile / 1024));
    const TileFormat format = tileFormatOf(bytes);
    if (format == TileFormat::Unknown)
        return tl::unexpected(TileImageText::tr("a tile is neither PNG, JPEG nor WebP"));
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer, readerOf(format)); // no other plug-in of Qt sees the bytes
    reader.setAutoDetectImageFormat(false);
    const QSize size = reader.size(); // from the header, before anything is allocated
    if (size.isEmpty())
        return tl::unexpected(TileImageText::tr("a tile cannot be read as %1").arg(formatName(format)));
    if (size.width() > kWidestTile || size.height() > kWidestTile)
        return tl::unexpected(
            TileImageText::tr("a tile has %1×%2 pixels, more than %3").arg(size.width()).arg(size.height()).arg(kWidestTile));
    QImage image = reader.read();
    if (image.isNull() || image.size() != size)
        return tl::unexpected(TileImageText::tr("a tile cannot be read as %1").arg(formatName(format)));
    image.convertTo(image.hasAlphaChannel() ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
    return image;
}

} // namespace skyseal::ui
