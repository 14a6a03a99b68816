#include "ui/tiles/tile_file.h"

#include "ui/tiles/mercator.h"
#include "ui/tiles/tile_image.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QRegularExpression>

#include <sqlite3.h>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

struct TileFileText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::TileFile)
};

/// Instructions of SQLite's virtual machine per query; an indexed look-up takes about 30, a small file without an
/// index some for each of its tiles.
constexpr int kMostInstructions = 20'000'000;
constexpr int kLongestText = 200; ///< characters that are shown
constexpr int kTilePixels = 256;  ///< of each side
constexpr int kMostMatrices = 64;

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

QString textAt(sqlite3_stmt *statement, int column)
{
    const auto *text = reinterpret_cast<const char *>(sqlite3_column_text(statement, column));
    return text ? QString::fromUtf8(text) : QString();
}

/// The whole number that `value` is, but for `rounding`.
std::optional<int> wholeNumber(double value, double rounding)
{
    const double whole = std::round(value);
    const bool fits = std::isfinite(value) && std::abs(whole) < 1 << 30 && std::abs(value - whole) < rounding;
    return fits ? std::optional(static_cast<int>(whole)) : std::nullopt;
}

} // namespace

void TileFile::Close::operator()(sqlite3 *database) const
{
    sqlite3_close_v2(database);
}

void TileFile::Close::operator()(sqlite3_stmt *statement) const
{
    sqlite3_finalize(statement);
}

Result<TileFile, QString> TileFile::open(const QString &path)
{
    TileFile out;
    sqlite3 *database = nullptr;
    const int opened = sqlite3_open_v2(QFile::encodeName(path).constData(), &database,
                                       SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE, nullptr);
    out.m_database.reset(database);
    if (opened != SQLITE_OK)
        return tl::unexpected(TileFileText::tr("%1 cannot be opened: %2").arg(path, out.problem()));
    protect(database);
    const bool isGeoPackage = out.prepare("SELECT 1 FROM gpkg_contents") != nullptr;
    if (auto read = isGeoPackage ? out.readGeoPackage() : out.readMbtiles(); !read)
        return tl::unexpected(TileFileText::tr("%1 cannot be shown: %2").arg(path, read.error()));
    return out;
}

TileFile::Statement TileFile::prepare(const char *sql) const
{
    sqlite3_stmt *statement = nullptr;
    sqlite3_prepare_v2(m_database.get(), sql, -1, &statement, nullptr);
    return Statement(statement);
}

QString TileFile::problem() const
{
    return m_database ? QString::fromUtf8(sqlite3_errmsg(m_database.get())) : TileFileText::tr("out of memory");
}

Result<void, QString> TileFile::readMbtiles()
{
    m_select = prepare("SELECT tile_data FROM tiles WHERE zoom_level=?1 AND tile_column=?2 AND tile_row=?3 LIMIT 1");
    if (!m_select)
        return tl::unexpected(TileFileText::tr("it is neither an MBTiles nor a GeoPackage file (%1)").arg(problem()));
    const QString format = metadata("format").toLower();
    if (format == QStringLiteral("pbf"))
        return tl::unexpected(TileFileText::tr("it has vector tiles; only images (PNG, JPEG, WebP) can be shown"));
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

QString TileFile::metadata(const char *name)
{
    const Statement select = prepare("SELECT value FROM metadata WHERE name=?1");
    if (!select)
        return {};
    sqlite3_bind_text(select.get(), 1, name, -1, SQLITE_STATIC);
    if (step(m_database.get(), select.get()) != SQLITE_ROW)
        return {};
    return textAt(select.get(), 0);
}

/// Takes the first table of tiles in the projection of the map.
Result<void, QString> TileFile::readGeoPackage()
{
    const Statement contents = prepare("SELECT c.table_name, c.identifier, s.min_x, s.max_y FROM gpkg_contents c "
                                       "JOIN gpkg_tile_matrix_set s ON s.table_name=c.table_name "
                                       "JOIN gpkg_spatial_ref_sys r ON r.srs_id=s.srs_id "
                                       "WHERE c.data_type='tiles' AND r.organization_coordsys_id=3857 "
                                       "ORDER BY c.table_name LIMIT 1");
    if (!contents)
        return tl::unexpected(TileFileText::tr("it has no map tiles (%1)").arg(problem()));
    if (step(m_database.get(), contents.get()) != SQLITE_ROW)
        return tl::unexpected(TileFileText::tr("it has no map tiles in Web Mercator (EPSG:3857)"));
    const QByteArray table = textAt(contents.get(), 0).toUtf8();
    m_facts.name = plainText(textAt(contents.get(), 1));
    readMatrices(table.constData(), sqlite3_column_double(contents.get(), 2), sqlite3_column_double(contents.get(), 3));
    if (m_matrices.empty())
        return tl::unexpected(TileFileText::tr("its tiles are not those of the usual grid, %1 pixels wide").arg(kTilePixels));
    m_facts.deepest = std::ranges::max(m_matrices, {}, &Matrix::level).level;
    const std::unique_ptr<char, void (*)(void *)> sql(
        sqlite3_mprintf("SELECT tile_data FROM \"%w\" WHERE zoom_level=?1 AND tile_column=?2 AND tile_row=?3 LIMIT 1",
                        table.constData()),
        sqlite3_free);
    if (sql)
        m_select = prepare(sql.get());
    if (!m_select)
        return tl::unexpected(problem());
    return {};
}

/// The levels of a table whose tiles are those of the map: as wide, and beginning where one of the map's begins.
void TileFile::readMatrices(const char *table, double west, double north)
{
    const Statement levels = prepare("SELECT zoom_level, pixel_x_size FROM gpkg_tile_matrix "
                                     "WHERE table_name=?1 AND tile_width=?2 AND tile_height=?2");
    if (!levels)
        return;
    sqlite3_bind_text(levels.get(), 1, table, -1, SQLITE_TRANSIENT);
    sqlite3_bind_int(levels.get(), 2, kTilePixels);
    constexpr double kOnePixel = 1.0 / kTilePixels, kSmallest = 1e-6; // the latter: 30 m around the globe
    for (int i = 0; i < kMostMatrices && step(m_database.get(), levels.get()) == SQLITE_ROW; ++i) {
        const double side = kTilePixels * sqlite3_column_double(levels.get(), 1);
        const auto level = wholeNumber(std::log2(2 * mercator::kHalfWorld / side), kSmallest);
        const auto column = wholeNumber((west + mercator::kHalfWorld) / side, kOnePixel);
        const auto row = wholeNumber((mercator::kHalfWorld - north) / side, kOnePixel);
        if (level && column && row && *level >= 0 && *level <= TileId::kDeepest)
            m_matrices.push_back({*level, sqlite3_column_int(levels.get(), 0), {*level, *column, *row}});
    }
}

std::optional<TileId> TileFile::storedAs(const TileId &tile) const
{
    if (m_matrices.empty()) // from the south
        return TileId{tile.level, tile.column, (1 << tile.level) - 1 - tile.row};
    const auto found = std::ranges::find(m_matrices, tile.level, &Matrix::level);
    if (found == m_matrices.end())
        return std::nullopt;
    return TileId{found->stored, tile.column - found->first.column, tile.row - found->first.row};
}

Result<std::optional<QByteArray>, QString> TileFile::tile(const TileId &tile)
{
    const auto stored = storedAs(tile);
    if (!stored)
        return std::optional<QByteArray>();
    sqlite3_reset(m_select.get());
    sqlite3_bind_int(m_select.get(), 1, stored->level);
    sqlite3_bind_int(m_select.get(), 2, stored->column);
    sqlite3_bind_int(m_select.get(), 3, stored->row);
    std::optional<QByteArray> out;
    const int result = step(m_database.get(), m_select.get());
    if (result == SQLITE_ROW) {
        const auto *data = static_cast<const char *>(sqlite3_column_blob(m_select.get(), 0));
        const int size = sqlite3_column_bytes(m_select.get(), 0);
        if (size > kLargestTile)
            return tl::unexpected(TileFileText::tr("a tile is larger than %1 kB").arg(kLargestTile / 1024));
        out = QByteArray(data, size);
    } else if (result != SQLITE_DONE) {
        return tl::unexpected(result == SQLITE_INTERRUPT ? TileFileText::tr("the file takes too long to search") : problem());
    }
    sqlite3_reset(m_select.get());
    return out;
}

} // namespace skyseal::ui
