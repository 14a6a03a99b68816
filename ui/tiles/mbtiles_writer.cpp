#include "ui/tiles/mbtiles_writer.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>

#include <sqlite3.h>

#include <cstdio>

namespace skyseal::ui {

namespace {

struct MbtilesWriterText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::MbtilesWriter)
};

} // namespace

void MbtilesWriter::Close::operator()(sqlite3 *database) const
{
    sqlite3_close_v2(database);
}

void MbtilesWriter::Close::operator()(sqlite3_stmt *statement) const
{
    sqlite3_finalize(statement);
}

MbtilesWriter::MbtilesWriter(QString path) : m_path(std::move(path)), m_part(m_path + QStringLiteral(".part")) {}

MbtilesWriter::~MbtilesWriter()
{
    m_insert.reset();
    if (m_database) {
        m_database.reset();
        QFile::remove(m_part);
    }
}

Result<void, QString> MbtilesWriter::run(const char *sql)
{
    if (sqlite3_exec(m_database.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK)
        return {};
    return tl::unexpected(
        MbtilesWriterText::tr("%1 cannot be written: %2").arg(m_path, QString::fromUtf8(sqlite3_errmsg(m_database.get()))));
}

Result<std::unique_ptr<MbtilesWriter>, QString> MbtilesWriter::create(const QString &path)
{
    std::unique_ptr<MbtilesWriter> out(new MbtilesWriter(path));
    if (QFile::exists(out->m_part) && !QFile::remove(out->m_part)) // of a program that ended early
        return tl::unexpected(MbtilesWriterText::tr("%1 cannot be replaced").arg(out->m_part));
    sqlite3 *database = nullptr;
    const int opened = sqlite3_open_v2(QFile::encodeName(out->m_part).constData(), &database,
                                       SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
    out->m_database.reset(database);
    if (opened != SQLITE_OK)
        return tl::unexpected(
            MbtilesWriterText::tr("%1 cannot be written: %2").arg(path, QString::fromUtf8(sqlite3_errmsg(database))));
    // Without a journal: an incomplete file is thrown away in any case.
    if (auto made = out->run("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA cache_size=-2048; BEGIN;"
                             "CREATE TABLE metadata (name TEXT, value TEXT);"
                             "CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB);"
                             "CREATE UNIQUE INDEX tile_index ON tiles (zoom_level, tile_column, tile_row);");
        !made)
        return tl::unexpected(made.error());
    sqlite3_stmt *insert = nullptr;
    sqlite3_prepare_v2(database, "INSERT OR REPLACE INTO tiles VALUES (?1, ?2, ?3, ?4)", -1, &insert, nullptr);
    out->m_insert.reset(insert);
    return out;
}

Result<void, QString> MbtilesWriter::add(const TileId &tile, const QByteArray &bytes)
{
    sqlite3_stmt *insert = m_insert.get();
    sqlite3_bind_int(insert, 1, tile.level);
    sqlite3_bind_int(insert, 2, tile.column);
    sqlite3_bind_int(insert, 3, (1 << tile.level) - 1 - tile.row); // from the south
    sqlite3_bind_blob(insert, 4, bytes.constData(), static_cast<int>(bytes.size()), SQLITE_STATIC);
    const int result = sqlite3_step(insert);
    sqlite3_reset(insert);
    sqlite3_clear_bindings(insert);
    if (result != SQLITE_DONE)
        return tl::unexpected(
            MbtilesWriterText::tr("%1 cannot be written: %2").arg(m_path, QString::fromUtf8(sqlite3_errmsg(m_database.get()))));
    return {};
}

Result<void, QString> MbtilesWriter::finish(const QHash<QString, QString> &metadata)
{
    sqlite3_stmt *made = nullptr;
    sqlite3_prepare_v2(m_database.get(), "INSERT INTO metadata VALUES (?1, ?2)", -1, &made, nullptr);
    const std::unique_ptr<sqlite3_stmt, Close> insert(made);
    for (auto entry = metadata.begin(); entry != metadata.end(); ++entry) {
        const QByteArray name = entry.key().toUtf8(), value = entry.value().toUtf8();
        sqlite3_bind_text(made, 1, name.constData(), -1, SQLITE_STATIC);
        sqlite3_bind_text(made, 2, value.constData(), -1, SQLITE_STATIC);
        sqlite3_step(made);
        sqlite3_reset(made);
    }
    if (auto done = run("COMMIT"); !done)
        return done;
    m_insert.reset();
    const bool renamed = std::rename(QFile::encodeName(m_part).constData(), QFile::encodeName(m_path).constData()) == 0;
    if (!renamed)
        return tl::unexpected(MbtilesWriterText::tr("%1 cannot be written").arg(m_path));
    m_database.reset(); // after the renaming, so that a failure still removes the part
    return {};
}

} // namespace skyseal::ui
