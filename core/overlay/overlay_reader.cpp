#include "core/overlay/overlay_reader.h"

#include "core/overlay/geojson_reader.h"
#include "core/overlay/kml_reader.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

namespace skyseal::overlay {

namespace {

Result<Overlay, InputError> readContent(const QString &suffix, const QByteArray &content)
{
    if (suffix == QLatin1String("kml"))
        return readKml(content);
    if (suffix == QLatin1String("geojson") || suffix == QLatin1String("json"))
        return readGeoJson(content);
    const Sentence problem = suffix == QLatin1String("kmz")
        ? sentence("Reason", "a .kmz is a zip file; unpack it, and add the .kml that is in it")
        : sentence("Reason", "the name ends neither in .kml nor in .geojson or .json");
    return tl::unexpected(InputError{problem, {}, 0, 0});
}

Result<QByteArray, InputError> contentOf(const QString &path)
{
    const auto failed = [](Reason message) { return tl::unexpected(InputError{std::move(message), {}, 0, 0}); };
    QFile file(path);
    if (QFileInfo info(path); info.exists() && !info.isFile()) // a pipe would never end
        return failed(sentence("Reason", "this is not a file"));
    if (!file.open(QIODevice::ReadOnly))
        return failed(sentence("Reason", "cannot be read: %1")(file.errorString().toStdString()));
    QByteArray content = file.read(kMostBytes + 1);
    if (file.error() != QFileDevice::NoError)
        return failed(sentence("Reason", "cannot be read: %1")(file.errorString().toStdString()));
    if (content.size() > kMostBytes)
        return failed(sentence("Reason", "the file is larger than %1 MB")(kMostBytes / 1024 / 1024));
    return content;
}

} // namespace

Result<ReadOverlay, InputError> readOverlay(const QString &path)
{
    const QFileInfo info(path);
    return contentOf(path)
        .and_then([&](const QByteArray &content) -> Result<ReadOverlay, InputError> {
            auto overlay = readContent(info.suffix().toLower(), content);
            if (!overlay)
                return tl::unexpected(std::move(overlay.error()));
            return ReadOverlay{std::move(*overlay), QCryptographicHash::hash(content, QCryptographicHash::Sha256)};
        })
        .map_error([&](InputError error) {
            error.source = info.fileName().toStdString();
            return error;
        });
}

} // namespace skyseal::overlay
