// Reader of raster map tiles in an MBTiles file, an SQLite database. The file may come from anywhere, and its "tiles" may be a
// view with any SQL in it: it is opened read-only, with SQLite's protections against hostile schemas and a limit on the work of
// each query. https://github.com/mapbox/mbtiles-spec/blob/master/1.3/spec.md
#pragma once

#include "core/base/result.h"
#include "ui/tiles/tile_id.h"

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include <memory>
#include <optional>

struct sqlite3;
struct sqlite3_stmt;

namespace skyseal::ui {

/// To be used in one thread at a time.
class MbtilesFile
{
public:
    /// Metadata of the file.
    struct Facts
    {
        QString name, attribution; ///< plain text
        int deepest = TileId::kDeepest;
    };

    /// The error says, for people, why the file cannot be shown.
    static Result<MbtilesFile, QString> open(const QString &path);

    const Facts &facts() const { return m_facts; }
    /// Returns nullopt if the file has no such tile; the error says why it could not be read.
    Result<std::optional<QByteArray>, QString> tile(const TileId &tile);

private:
    struct Close
    {
        void operator()(sqlite3 *database) const;
        void operator()(sqlite3_stmt *statement) const;
    };
    using Database = std::unique_ptr<sqlite3, Close>;
    using Statement = std::unique_ptr<sqlite3_stmt, Close>;

    Result<void, QString> readFacts();
    QString metadata(const char *name);
    Statement prepare(const char *sql);
    QString problem() const;

    Database m_database;
    Statement m_select;
    Facts m_facts;
};

} // namespace skyseal::ui
