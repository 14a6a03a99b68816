#include "ui/tiles/mbtiles_file.h"

#include "ui/tiles/tile_image.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>

#include <sqlite3.h>

#include <algorithm>

namespace skyseal::ui {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::MbtilesFile)
};

/// Instructions of SQLite's virtual machine per query; an indexed look-up takes about 30, a small file without an
/// index some for each of its tiles.
constexpr int kMostInstructions = 20'000'000;
constexpr int kLongestText = 200; ///< characters that are shown

/// Attributions contain HTML in many files.
QString plainText(QString text)
{
    static const QRegularExpression kTag(QStringLiteral("<[^>]*>"));
    text.remove(kTag);
    text.replace(QStringLiteral("&copy;"), QStringLiteral("©"));
    text.replace(QStringLiteral("&amp;"), QStringLiteral("&"));
    return text.simplified().left(kLongestText);
}

void protect(sqlite3 *database)
{
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_limit(database, SQLITE_LIMIT_LENGTH, 2 * kLargestTile);
    sqlite3_limit(database, SQLITE_LIMIT_SQL_LENGTH, 10'000);
    sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_limit(database, SQLITE_LIMIT_EXPR_DEPTH, 50);
    sqlite3_exec(database, "PRAGMA cell_size_check=ON; PRAGMA cache_size=-2048; PRAGMA mmap_size=0", nullptr, nullptr, nullptr);
}

int interrupt(void *)
{
    return 1;
}

/// Ends a query that takes too many instructions.
int step(sqlite3 *database, sqlite3_stmt *statement)
{
    sqlite3_progress_handler(database, kMostInstructions, interrupt, nullptr);
    const int result = sqlite3_step(statement);
    sqlite3_progress_handler(database, 0, nullptr, nullptr);
    return result;
}

} // namespace

void MbtilesFile::Close::operator()(sqlite3 *database) const
{
    sqlite3_close_v2(database);
}

void MbtilesFile::Close::operator()(sqlite3_stmt *statement) const
{
    sqlite3_finalize(statement);
}

Result<MbtilesFile, QString> MbtilesFile::open(const QString &path)
{
    MbtilesFile out;
    sqlite3 *database = nullptr;
    const int opened = sqlite3_open_v2(QFile::encodeName(path).constData(), &database,
                                       SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE, nullptr);
    out.m_database.reset(database);
    if (opened != SQLITE_OK)
        return tl::unexpected(Text::tr("%1 cannot be opened: %2").arg(path, out.problem()));
    protect(database);
    if (auto read = out.readFacts(); !read)
        return tl::unexpected(Text::tr("%1 cannot be shown: %2").arg(path, read.error()));
    return out;
}

MbtilesFile::Statement MbtilesFile::prepare(const char *sql)
{
    sqlite3_stmt *statement = nullptr;
    sqlite3_prepare_v2(m_database.get(), sql, -1, &statement, nullptr);
    return Statement(statement);
}

QString MbtilesFile::problem() const
{
    return m_database ? QString::fromUtf8(sqlite3_errmsg(m_database.get())) : Text::tr("out of memory");
}

Result<void, QString> MbtilesFile::readFacts()
{
    m_select = prepare("SELECT tile_data FROM tiles WHERE zoom_level=?1 AND tile_column=?2 AND tile_row=?3 LIMIT 1");
    if (!m_select)
        return tl::unexpected(Text::tr("it is not an MBTiles file (%1)").arg(problem()));
    const QString format = metadata("format").toLower();
    if (format == QStringLiteral("pbf"))
        return tl::unexpected(Text::tr("it has vector tiles; only images (PNG, JPEG, WebP) can be shown"));
    m_facts.name = plainText(metadata("name"));
    m_facts.attribution = plainText(metadata("attribution"));
    bool ok = false;
    const int deepest = metadata("maxzoom").toInt(&ok);
    if (ok && deepest >= 0 && deepest <= TileId::kDeepest) {
        m_facts.deepest = deepest;
    } else if (const Statement last = prepare("SELECT max(zoom_level) FROM tiles")) {
        if (step(m_database.get(), last.get()) == SQLITE_ROW)
            m_facts.deepest = std::clamp(sqlite3_column_int(last.get(), 0), 0, TileId::kDeepest);
    }
    return {};
}

QString MbtilesFile::metadata(const char *name)
{
    const Statement select = prepare("SELECT value FROM metadata WHERE name=?1");
    if (!select)
        return {};
    sqlite3_bind_text(select.get(), 1, name, -1, SQLITE_STATIC);
    if (step(m_database.get(), select.get()) != SQLITE_ROW)
        return {};
    const auto *text = reinterpret_cast<const char *>(sqlite3_column_text(select.get(), 0));
    return text ? QString::fromUtf8(text) : QString();
}

Result<std::optional<QByteArray>, QString> MbtilesFile::tile(const TileId &tile)
{
    sqlite3_reset(m_select.get());
    sqlite3_bind_int(m_select.get(), 1, tile.level);
    sqlite3_bind_int(m_select.get(), 2, tile.column);
    sqlite3_bind_int(m_select.get(), 3, (1 << tile.level) - 1 - tile.row); // from the south
    std::optional<QByteArray> out;
    const int result = step(m_database.get(), m_select.get());
    if (result == SQLITE_ROW) {
        const auto *data = static_cast<const char *>(sqlite3_column_blob(m_select.get(), 0));
        const int size = sqlite3_column_bytes(m_select.get(), 0);
        if (size > kLargestTile)
            return tl::unexpected(Text::tr("a tile is larger than %1 kB").arg(kLargestTile / 1024));
        out = QByteArray(data, size);
    } else if (result != SQLITE_DONE) {
        return tl::unexpected(result == SQLITE_INTERRUPT ? Text::tr("the file takes too long to search") : problem());
    }
    sqlite3_reset(m_select.get());
    return out;
}

} // namespace skyseal::ui
