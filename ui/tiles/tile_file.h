// Reader of raster map tiles in an MBTiles or a GeoPackage file, both SQLite databases. The file may come from anywhere, and a
// table in it may be a view with any SQL: it is opened read-only, with SQLite's protections against hostile schemas and a limit
// on the work of each query. https://github.com/mapbox/mbtiles-spec/blob/master/1.3/spec.md,
// https://www.geopackage.org/spec131/#tiles
#pragma once

#include "core/base/result.h"
#include "ui/tiles/tile_id.h"

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include <memory>
#include <optional>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace skyseal::ui {

/// To be used in one thread at a time.
class TileFile
{
public:
    /// Metadata of the file.
    struct Facts
    {
        QString name, attribution; ///< plain text
        int deepest = TileId::kDeepest;
    };

    /// The error says, for people, why the file cannot be shown.
    static Result<TileFile, QString> open(const QString &path);

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

    /// A level of tiles in a GeoPackage, which numbers levels as it likes, and tiles from the corner of its area.
    struct Matrix
    {
        int level;    ///< of TileId
        int stored;   ///< its number in the file
        TileId first; ///< the tile in the corner
    };

    Result<void, QString> readMbtiles();
    Result<void, QString> readGeoPackage();
    void readMatrices(const char *table, double west, double north);
    QString metadata(const char *name);
    Statement prepare(const char *sql) const;
    QString problem() const;
    /// The number of a tile in the file; nullopt if it has no such level.
    std::optional<TileId> storedAs(const TileId &tile) const;

    Database m_database;
    Statement m_select;
    std::vector<Matrix> m_matrices; ///< empty for MBTiles
    Facts m_facts;
};

} // namespace skyseal::ui
