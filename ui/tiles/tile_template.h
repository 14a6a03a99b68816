// The address of a tile server, "https://tile.example.org/{z}/{x}/{y}.png". {-y} counts rows from the south (TMS).
#pragma once

#include "core/base/result.h"
#include "ui/tiles/tile_id.h"

#include <QtCore/QString>
#include <QtCore/QUrl>

namespace skyseal::ui {

class TileTemplate
{
public:
    /// The error says, for people, what is wrong.
    static Result<TileTemplate, QString> parse(const QString &text);

    QUrl urlOf(const TileId &tile) const;
    QString host() const { return m_host; }
    /// Servers whose rules forbid to fetch tiles for later use: why, for people; empty for others.
    QString offlineForbiddenReason() const;

private:
    QString m_text, m_host;
};

} // namespace skyseal::ui
