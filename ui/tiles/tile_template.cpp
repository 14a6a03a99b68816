#include "ui/tiles/tile_template.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct TileTemplateText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::TileTemplate)
};

QString filled(QString text, const TileId &tile)
{
    text.replace(QStringLiteral("{z}"), QString::number(tile.level));
    text.replace(QStringLiteral("{x}"), QString::number(tile.column));
    text.replace(QStringLiteral("{y}"), QString::number(tile.row));
    text.replace(QStringLiteral("{-y}"), QString::number((1 << tile.level) - 1 - tile.row));
    return text;
}

} // namespace

Result<TileTemplate, QString> TileTemplate::parse(const QString &text)
{
    TileTemplate out;
    out.m_text = text.trimmed();
    const bool rows = out.m_text.contains(QStringLiteral("{y}")) != out.m_text.contains(QStringLiteral("{-y}"));
    if (!out.m_text.contains(QStringLiteral("{z}")) || !out.m_text.contains(QStringLiteral("{x}")) || !rows)
        return tl::unexpected(
            TileTemplateText::tr("The address must contain {z}, {x} and {y}, where the server expects zoom level, "
                                 "column and row"));
    const QString example = filled(out.m_text, {});
    if (example.contains(QLatin1Char('{')) || example.contains(QLatin1Char('}')))
        return tl::unexpected(TileTemplateText::tr("Only the placeholders {z}, {x} and {y} (or {-y}) are supported"));
    const QUrl url(example, QUrl::StrictMode);
    if (!url.isValid() || url.host().isEmpty()
        || (url.scheme() != QStringLiteral("https") && url.scheme() != QStringLiteral("http")))
        return tl::unexpected(TileTemplateText::tr("The address must begin with https:// or http:// and name a server"));
    // The server's name stays the same for all tiles, so that the operator knows whom the map asks.
    out.m_host = url.host();
    if (QUrl(filled(out.m_text, {1, 1, 0})).host() != out.m_host)
        return tl::unexpected(TileTemplateText::tr("The server name must not contain placeholders"));
    return out;
}

QUrl TileTemplate::urlOf(const TileId &tile) const
{
    return QUrl(filled(m_text, tile), QUrl::StrictMode);
}

QString TileTemplate::offlineForbiddenReason() const
{
    if (m_host == QStringLiteral("openstreetmap.org") || m_host.endsWith(QStringLiteral(".openstreetmap.org")))
        return TileTemplateText::tr(
            "openstreetmap.org does not permit fetching areas for later use; choose a server that does");
    return {};
}

} // namespace skyseal::ui
