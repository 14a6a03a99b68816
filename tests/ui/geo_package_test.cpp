// Map tiles in GeoPackage files: of the whole world or of an area, in the map's projection and grid, and refused in others.
#include "sqlite_file.h"
#include "tests/support/test_runner.h"
#include "ui/tiles/mercator.h"
#include "ui/tiles/tile_file.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <memory>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// The north-western corner of the world, in metres of the projection.
constexpr const char *kWorld = "-20037508.3427892, 20037508.3427892";

} // namespace

class GeoPackageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    /// As GDAL and QGIS write them: levels as the map counts them, and tiles from the corner of the world.
    void filesOfTheWorldAreRead()
    {
        auto file = TileFile::open(geoPackage(kWorld, 1.0, "3, 8, 8, 256, 256"));
        QVERIFY2(file.has_value(), file ? "" : qPrintable(file.error()));
        QCOMPARE(file->facts().name, QStringLiteral("Fields"));
        QCOMPARE(file->facts().deepest, 3);
        QCOMPARE(**file->tile({3, 5, 2}), QByteArray("tile"));
        QVERIFY(!*file->tile({3, 5, 3}) && !*file->tile({2, 5, 2}) && !*file->tile({3, 2, 5}));
    }

    /// Other programs count the levels from 0 and the tiles from the corner of their area.
    void fileOfAnAreaIsRead()
    {
        // Level 3 of the map, from the tile in column 4 and row 1.
        const QByteArray corner = QByteArray::number(0.0, 'f', 4) + ", "
            + QByteArray::number(0.75 * mercator::kHalfWorld, 'f', 4);
        auto file = TileFile::open(geoPackage(corner, 1.0, "0, 2, 2, 256, 256", "0, 1, 1"));
        QVERIFY2(file.has_value(), file ? "" : qPrintable(file.error()));
        QCOMPARE(file->facts().deepest, 3);
        QCOMPARE(**file->tile({3, 5, 2}), QByteArray("tile"));
        QVERIFY(!*file->tile({3, 4, 1}) && !*file->tile({3, 0, 0}) && !*file->tile({0, 0, 0}));
    }

    void otherGridsAreRefused_data()
    {
        QTest::addColumn<QByteArray>("corner");
        QTest::addColumn<double>("scale");
        QTest::addColumn<QByteArray>("matrix");
        QTest::addColumn<int>("system");
        const QByteArray usual = "3, 8, 8, 256, 256";
        QTest::newRow("another projection") << QByteArray(kWorld) << 1.0 << usual << 4326;
        QTest::newRow("tiles of 512 pixels") << QByteArray(kWorld) << 1.0 << QByteArray("3, 8, 8, 512, 512") << 3857;
        QTest::newRow("between two levels") << QByteArray(kWorld) << 1.3 << usual << 3857;
        QTest::newRow("400 m off in the far east") << QByteArray(kWorld) << 1.00001 << usual << 3857;
        QTest::newRow("half a tile to the east") << QByteArray("-17532819.8, 20037508.34") << 1.0 << usual << 3857;
        QTest::newRow("no size") << QByteArray(kWorld) << 0.0 << usual << 3857;
    }
    void otherGridsAreRefused()
    {
        QFETCH(QByteArray, corner);
        QFETCH(double, scale);
        QFETCH(QByteArray, matrix);
        QFETCH(int, system);
        const auto file = TileFile::open(geoPackage(corner, scale, matrix, "3, 5, 2", system));
        QVERIFY(!file.has_value());
        QVERIFY2(file.error().contains(QStringLiteral("cannot be shown")), qPrintable(file.error()));
    }

    /// The name of the table is part of a statement.
    void hostileNameOfATableIsANameOnly()
    {
        auto file = TileFile::open(geoPackage(kWorld, 1.0, "3, 8, 8, 256, 256", "3, 5, 2", 3857, "a\"b'; DROP TABLE x; --"));
        QVERIFY2(file.has_value(), file ? "" : qPrintable(file.error()));
        QCOMPARE(**file->tile({3, 5, 2}), QByteArray("tile"));
    }

private:
    /// A file with shapes and one table of tiles, which has the tile `tile` (level, column and row) and one level: `matrix` are
    /// its number, columns, rows and the sides of a tile. Its pixels are those of level 3 of the map, times `scale`.
    QString geoPackage(const QByteArray &corner, double scale, const QByteArray &matrix, const QByteArray &tile = "3, 5, 2",
                       int system = 3857, const QByteArray &name = "fields") const
    {
        const auto quoted = [](QByteArray text, char mark) { return mark + text.replace(mark, QByteArray(2, mark)) + mark; };
        const QByteArray value = quoted(name, '\''), table = quoted(name, '"');
        const QByteArray pixel = QByteArray::number(2 * mercator::kHalfWorld / 256 / 8 * scale, 'g', 17);
        return sqliteFile(
            m_folder->filePath(QStringLiteral("a.gpkg")),
            "CREATE TABLE gpkg_spatial_ref_sys (srs_id, organization_coordsys_id);"
            "INSERT INTO gpkg_spatial_ref_sys VALUES (1, "
                + QByteArray::number(system)
                + ");"
                  "CREATE TABLE gpkg_contents (table_name, data_type, identifier);"
                  "INSERT INTO gpkg_contents VALUES ('a', 'features', 'Shapes'), ("
                + value
                + ", 'tiles', 'Fields');"
                  "CREATE TABLE gpkg_tile_matrix_set (table_name, srs_id, min_x, max_y);"
                  "INSERT INTO gpkg_tile_matrix_set VALUES ("
                + value + ", 1, " + corner
                + ");"
                  "CREATE TABLE gpkg_tile_matrix (table_name, zoom_level, matrix_width, matrix_height, tile_width, "
                  "tile_height, pixel_x_size);"
                  "INSERT INTO gpkg_tile_matrix VALUES ("
                + value + ", " + matrix + ", " + pixel + "); CREATE TABLE " + table
                + " (zoom_level, tile_column, tile_row, tile_data); INSERT INTO " + table + " VALUES (" + tile + ", 'tile')");
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

SKYSEAL_TEST_APPLESS(GeoPackageTest)
#include "geo_package_test.moc"
