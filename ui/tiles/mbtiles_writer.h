// Writer of an MBTiles file. The file appears under its name only when it is complete.
// https://github.com/mapbox/mbtiles-spec/blob/master/1.3/spec.md
#pragma once

#include "core/base/result.h"
#include "ui/tiles/tile_id.h"

#include <QtCore/QByteArray>
#include <QtCore/QHash>
#include <QtCore/QString>

#include <memory>

struct sqlite3;
struct sqlite3_stmt;

namespace skyseal::ui {

/// To be used in one thread at a time. Removes what it has written unless finish() succeeds.
class MbtilesWriter
{
public:
    /// The error says, for people, why nothing can be written there.
    static Result<std::unique_ptr<MbtilesWriter>, QString> create(const QString &path);
    ~MbtilesWriter();

    Result<void, QString> add(const TileId &tile, const QByteArray &bytes);
    /// Adds the metadata and gives the file its name.
    Result<void, QString> finish(const QHash<QString, QString> &metadata);

private:
    explicit MbtilesWriter(QString path);
    Result<void, QString> run(const char *sql);

    struct Close
    {
        void operator()(sqlite3 *database) const;
        void operator()(sqlite3_stmt *statement) const;
    };

    QString m_path, m_part; ///< its name, and that until it is complete
    std::unique_ptr<sqlite3, Close> m_database;
    std::unique_ptr<sqlite3_stmt, Close> m_insert;
};

} // namespace skyseal::ui
