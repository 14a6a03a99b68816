// Map tiles from servers and files: who is asked for what, what is kept, and that hostile answers and files stay within limits.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "sqlite_file.h"
#include "tile_server.h"
#include "ui/tiles/mbtiles_writer.h"
#include "ui/tiles/tile_file.h"
#include "ui/tiles/tile_image.h"
#include "ui/tiles/tile_loader.h"
#include "ui/tiles/tile_template.h"

#include <QtCore/QDir>
#include <QtCore/QTemporaryDir>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

MapSource serverAt(const QString &address)
{
    MapSource out;
    out.kind = MapSource::Kind::Server;
    out.url = address;
    out.attribution = QStringLiteral("© nobody");
    return out;
}

/// Without a cache on the disk.
TileConfig configOf(const char *userAgent, int pauseMs = 2000)
{
    TileConfig out;
    out.userAgent = QLatin1String(userAgent);
    out.pauseMs = pauseMs;
    return out;
}

/// What a loader reports.
class Listener
{
public:
    explicit Listener(TileLoader &loader)
    {
        QObject::connect(&loader, &TileLoader::loaded, &loader, [this](const TileId &tile, const QImage &image) {
            loaded << tile;
            last = image;
        });
        QObject::connect(&loader, &TileLoader::missing, &loader, [this](const TileId &tile) { missing << tile; });
        QObject::connect(&loader, &TileLoader::problem, &loader, [this](const QString &text) { problems << text; });
        QObject::connect(&loader, &TileLoader::regionEnded, &loader, [this](const RegionEnd &end) { ends << end; });
    }

    QList<TileId> loaded, missing;
    QImage last;
    QStringList problems;
    QList<RegionEnd> ends;
};

/// PNG of this size by its header alone; nothing follows.
QByteArray headerOf(quint32 width, quint32 height)
{
    QByteArray out = tileBytes();
    for (int i = 0; i < 4; ++i) {
        out[16 + i] = static_cast<char>(width >> (24 - 8 * i));
        out[20 + i] = static_cast<char>(height >> (24 - 8 * i));
    }
    quint32 crc = 0xffffffff; // of the chunk
    for (int i = 12; i < 29; ++i) {
        crc ^= static_cast<quint8>(out[i]);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
    }
    crc = ~crc;
    for (int i = 0; i < 4; ++i)
        out[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
    return out;
}

} // namespace

class TilesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void addressesAreChecked_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("host"); // empty: refused
        QTest::newRow("usual") << "https://tile.example.org/{z}/{x}/{y}.png"
                               << "tile.example.org";
        QTest::newRow("rows from the south") << "http://127.0.0.1:8080/{z}/{x}/{-y}"
                                             << "127.0.0.1";
        QTest::newRow("a key") << "https://a.example/{z}/{x}/{y}@2x.jpg?key=1"
                               << "a.example";
        QTest::newRow("empty") << ""
                               << "";
        QTest::newRow("no level") << "https://a.example/{x}/{y}.png"
                                  << "";
        QTest::newRow("no row") << "https://a.example/{z}/{x}.png"
                                << "";
        QTest::newRow("subdomains") << "https://{s}.a.example/{z}/{x}/{y}.png"
                                    << "";
        QTest::newRow("a server of its own for each level") << "https://t{z}.example/{z}/{x}/{y}.png"
                                                            << "";
        QTest::newRow("file") << "file:///{z}/{x}/{y}.png"
                              << "";
        QTest::newRow("no host") << "https:///{z}/{x}/{y}.png"
                                 << "";
    }
    void addressesAreChecked()
    {
        QFETCH(QString, text);
        QFETCH(QString, host);
        const auto parsed = TileTemplate::parse(text);
        QCOMPARE(parsed.has_value(), !host.isEmpty());
        if (parsed)
            QCOMPARE(parsed->host(), host);
        else
            QVERIFY(!parsed.error().isEmpty());
    }

    void tilesHaveTheirNumbersInTheAddress()
    {
        const auto south = TileTemplate::parse(QStringLiteral("http://h/{z}/{x}/{-y}"));
        QCOMPARE(south->urlOf({3, 5, 1}).toString(), QStringLiteral("http://h/3/5/6"));
        const auto north = TileTemplate::parse(QStringLiteral("http://h/{z}/{x}/{y}"));
        QCOMPARE(north->urlOf({3, 5, 1}).toString(), QStringLiteral("http://h/3/5/1"));
    }

    void onlySmallPicturesOfThreeFormatsAreDecoded_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<bool>("good");
        QTest::newRow("png") << tileBytes() << true;
        QTest::newRow("jpeg") << tileBytes(Qt::red, "jpg") << true;
        QTest::newRow("512 pixels") << tileBytes(Qt::red, "png", {512, 512}) << true;
        QTest::newRow("too wide") << tileBytes(Qt::red, "png", {1025, 4}) << false;
        QTest::newRow("a header that asks for gigabytes") << headerOf(60'000, 60'000) << false;
        QTest::newRow("too many bytes") << tileBytes() + QByteArray(kLargestTile, 'x') << false;
        QTest::newRow("another format of Qt") << tileBytes(Qt::red, "bmp") << false;
        QTest::newRow("cut") << tileBytes().left(60) << false;
        QTest::newRow("text") << QByteArray("<svg xmlns='http://www.w3.org/2000/svg'/>") << false;
        QTest::newRow("nothing") << QByteArray() << false;
    }
    void onlySmallPicturesOfThreeFormatsAreDecoded()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(bool, good);
        const auto image = decodeTile(bytes);
        QVERIFY2(image.has_value() == good, image ? "" : qPrintable(image.error()));
    }

    void mbtilesAreRead()
    {
        const QString path = m_folder->filePath(QStringLiteral("a.mbtiles"));
        {
            auto writer = MbtilesWriter::create(path);
            QVERIFY((*writer)->add({2, 1, 0}, tileBytes(Qt::blue)));
            QVERIFY(!QFile::exists(path));
            QVERIFY((*writer)->finish({{QStringLiteral("attribution"), QStringLiteral("<a href='x'>&copy; us</a>")},
                                       {QStringLiteral("maxzoom"), QStringLiteral("2")}}));
        }
        auto file = TileFile::open(path);
        QVERIFY2(file.has_value(), file ? "" : qPrintable(file.error()));
        QCOMPARE(file->facts().attribution, QStringLiteral("© us"));
        QCOMPARE(file->facts().deepest, 2);
        QCOMPARE(**file->tile({2, 1, 0}), tileBytes(Qt::blue));
        QVERIFY(!*file->tile({2, 1, 1}));
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList{QStringLiteral("a.mbtiles")});
    }

    void wrongFilesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("sql");
        QTest::newRow("no tiles") << QByteArray("CREATE TABLE other (a)");
        QTest::newRow("GeoPackage of shapes") << QByteArray("CREATE TABLE gpkg_contents (table_name, data_type, identifier)");
        QTest::newRow("vector tiles") << QByteArray("CREATE TABLE tiles (zoom_level, tile_column, tile_row, tile_data);"
                                                    "CREATE TABLE metadata (name, value);"
                                                    "INSERT INTO metadata VALUES ('format', 'pbf')");
    }
    void wrongFilesAreRefused()
    {
        QFETCH(QByteArray, sql);
        const auto file = TileFile::open(sqliteFile(m_folder->filePath(QStringLiteral("b.mbtiles")), sql));
        QVERIFY(!file.has_value() && !file.error().isEmpty());
        QVERIFY(!TileFile::open(m_folder->filePath(QStringLiteral("none.mbtiles"))).has_value());
        QFile text(m_folder->filePath(QStringLiteral("text.mbtiles")));
        QVERIFY(text.open(QIODevice::WriteOnly) && text.write(QByteArray(5000, 'a')) == 5000);
        text.close();
        QVERIFY(!TileFile::open(text.fileName()).has_value());
    }

    /// "tiles" may be a view, and so a program.
    void hostileFilesStayWithinLimits_data()
    {
        QTest::addColumn<QByteArray>("tiles");
        QTest::newRow("for ever") << QByteArray(
            "WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i+1 FROM n)"
            "SELECT 0 zoom_level, 0 tile_column, 0 tile_row, 'x' tile_data FROM n WHERE i<0");
        QTest::newRow("gigabytes") << QByteArray("SELECT 0 zoom_level, 0 tile_column, 0 tile_row, "
                                                 "zeroblob(2000000000) tile_data");
        QTest::newRow("above the limit") << QByteArray("SELECT 0 zoom_level, 0 tile_column, 0 tile_row, "
                                                       "zeroblob(1100000) tile_data");
        QTest::newRow("files") << QByteArray("SELECT 0 zoom_level, 0 tile_column, 0 tile_row, "
                                             "load_extension('x') tile_data");
    }
    void hostileFilesStayWithinLimits()
    {
        QFETCH(QByteArray, tiles);
        auto file = TileFile::open(
            sqliteFile(m_folder->filePath(QStringLiteral("c.mbtiles")), "CREATE VIEW tiles AS " + tiles));
        if (!file)
            return; // refused at once
        QVERIFY(!file->tile({0, 0, 0}).has_value());
    }

    void nothingIsRequestedOfAServerThatWasNotChosen()
    {
        TileServer server, chosen;
        TileLoader loader(configOf("Skyseal/1"));
        Listener heard(loader);
        MapSource source = serverAt(server.address());
        source.kind = MapSource::Kind::None;
        loader.setSource(source);
        loader.request({{0, 0, 0}});
        loader.setSource(serverAt(chosen.address()));
        loader.request({{0, 0, 0}});
        EVENTUALLY_EQUAL(heard.loaded.size(), 1);
        QCOMPARE(server.mostOpen, 0);
    }

    void atMostTwoConnectionsUnderItsName()
    {
        TileServer server;
        TileLoader loader(configOf("Skyseal/1.2.3"));
        Listener heard(loader);
        loader.setSource(serverAt(server.address()));
        QList<TileId> tiles;
        for (int i = 0; i < 64; ++i)
            tiles << TileId{6, i, 7};
        loader.request(tiles);
        EVENTUALLY_EQUAL(heard.loaded.size(), 64);
        QCOMPARE(heard.last.pixelColor(5, 5), QColor(Qt::red));
        QCOMPARE(server.paths.first(), QStringLiteral("/6/0/7.png")); // the most wanted one first
        QVERIFY2(server.mostOpen <= 2, qPrintable(QString::number(server.mostOpen)));
        QCOMPARE(QSet<QString>(server.agents.cbegin(), server.agents.cend()), QSet<QString>{QStringLiteral("Skyseal/1.2.3")});
    }

    void newWishesReplaceThoseThatWait()
    {
        TileServer server;
        TileLoader loader(configOf("Skyseal/1"));
        Listener heard(loader);
        loader.setSource(serverAt(server.address()));
        QList<TileId> many;
        for (int i = 0; i < 500; ++i)
            many << TileId{10, i, 0};
        loader.request(many);
        EVENTUALLY(!server.paths.isEmpty());
        loader.request({{10, 900, 0}});
        EVENTUALLY(heard.loaded.contains(TileId{10, 900, 0}));
        QVERIFY2(server.paths.size() < 250, qPrintable(QString::number(server.paths.size())));
    }

    void absentAndBadTilesAreNotAskedForAgain_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("body");
        QTest::newRow("not found") << 404 << QByteArray();
        QTest::newRow("no picture") << 200 << QByteArray("<html>");
        QTest::newRow("oversized") << 200 << QByteArray(3 * kLargestTile, 'x');
    }
    void absentAndBadTilesAreNotAskedForAgain()
    {
        QFETCH(int, status);
        QFETCH(QByteArray, body);
        TileServer server;
        server.answer = [&](const QString &path) {
            return path.startsWith(QStringLiteral("/3/")) ? TileServer::Answer{status, body}
                                                          : TileServer::Answer{200, tileBytes()};
        };
        TileLoader loader(configOf("Skyseal/1"));
        Listener heard(loader);
        loader.setSource(serverAt(server.address()));
        loader.request({{3, 0, 0}, {4, 0, 0}});
        EVENTUALLY_EQUAL(heard.loaded.size(), 1);
        EVENTUALLY_EQUAL(heard.missing, QList<TileId>({{3, 0, 0}}));
        QCOMPARE(server.paths.count(QStringLiteral("/3/0/0.png")), 1);
        QCOMPARE(heard.problems.isEmpty(), status == 404);
    }

    void failuresAreReportedAndTriedAgainLater()
    {
        TileServer server;
        int failures = 2;
        server.answer = [&](const QString &) {
            return failures-- > 0 ? TileServer::Answer{503} : TileServer::Answer{200, tileBytes()};
        };
        TileLoader loader(configOf("Skyseal/1", 20));
        Listener heard(loader);
        loader.setSource(serverAt(server.address()));
        loader.request({{3, 0, 0}});
        EVENTUALLY_EQUAL(heard.loaded.size(), 1);
        QVERIFY(heard.problems.size() >= 2 && !heard.problems.first().isEmpty() && heard.problems.last().isEmpty());
    }

    void redirectionsToOthersAreNotFollowed()
    {
        TileServer other, server;
        server.answer = [&](const QString &) {
            return TileServer::Answer{
                302, {}, "Location: http://127.0.0.1:" + QByteArray::number(other.serverPort()) + "/x\r\n"};
        };
        TileLoader loader(configOf("Skyseal/1", 20));
        Listener heard(loader);
        loader.setSource(serverAt(server.address()));
        loader.request({{3, 0, 0}});
        EVENTUALLY(server.paths.size() >= 2); // tried again
        QCOMPARE(other.mostOpen, 0);
    }

    void keptTilesStandInForASilentServer()
    {
        TileConfig config{QStringLiteral("Skyseal/1"), m_folder->filePath(QStringLiteral("cache"))};
        config.pauseMs = 20;
        auto server = std::make_unique<TileServer>();
        server->answer = [](const QString &) {
            return TileServer::Answer{200, tileBytes(Qt::green), "Cache-Control: max-age=0\r\n"};
        };
        const QString address = server->address();
        {
            TileLoader loader(config);
            Listener heard(loader);
            loader.setSource(serverAt(address));
            loader.request({{3, 1, 2}});
            EVENTUALLY_EQUAL(heard.loaded.size(), 1);
        }
        server.reset();
        TileLoader loader(config);
        Listener heard(loader);
        loader.setSource(serverAt(address));
        loader.request({{3, 1, 2}});
        EVENTUALLY_EQUAL(heard.loaded.size(), 1);
        QCOMPARE(heard.last.pixelColor(0, 0), QColor(Qt::green));
    }

    void regionIsFetchedIntoAFile()
    {
        TileServer server;
        server.answer = [](const QString &path) {
            return path == QStringLiteral("/2/0/0.png") ? TileServer::Answer{404}
                                                        : TileServer::Answer{200, tileBytes(Qt::cyan)};
        };
        TileLoader loader(configOf("Skyseal/1"));
        Listener heard(loader);
        loader.setSource(serverAt(server.address()));
        const double world = 2 * mercator::kHalfWorld - 2;
        const TileRegion region{QRectF(-world / 2, -world / 2, world, world), 0, 2};
        QCOMPARE(region.count(), qint64(21));
        const QString path = m_folder->filePath(QStringLiteral("area.mbtiles"));
        loader.fetchRegion(region, path);
        EVENTUALLY_EQUAL(heard.ends.size(), 1);
        QCOMPARE(heard.ends[0].problem, QString());
        QCOMPARE(heard.ends[0].file, path);
        QCOMPARE(heard.ends[0].progress.done, qint64(21));
        QCOMPARE(QSet<QString>(server.paths.cbegin(), server.paths.cend()).size(), 21);
        QVERIFY(server.mostOpen <= 2);
        auto file = TileFile::open(path);
        QVERIFY(file.has_value());
        QCOMPARE(file->facts().attribution, QStringLiteral("© nobody"));
        QCOMPARE(**file->tile({2, 3, 1}), tileBytes(Qt::cyan));
        QVERIFY(!*file->tile({2, 0, 0}));
    }

    void regionThatIsCancelledOrFailsLeavesNoFile_data()
    {
        QTest::addColumn<int>("status");
        QTest::newRow("cancelled") << 200;
        QTest::newRow("refused by the server") << 403;
        QTest::newRow("nothing there") << 404;
    }
    void regionThatIsCancelledOrFailsLeavesNoFile()
    {
        QFETCH(int, status);
        TileServer server;
        server.answer = [&](const QString &) { return TileServer::Answer{status, status == 200 ? tileBytes() : QByteArray()}; };
        TileLoader loader(configOf("Skyseal/1", 1));
        Listener heard(loader);
        loader.setSource(serverAt(server.address()));
        const TileRegion region{QRectF(-1e7, -1e7, 2e7, 2e7), 0, status == 200 ? 6 : 3};
        loader.fetchRegion(region, m_folder->filePath(QStringLiteral("area.mbtiles")));
        EVENTUALLY(server.paths.size() > 5 || !heard.ends.isEmpty());
        if (status == 200)
            loader.cancelRegion();
        EVENTUALLY_EQUAL(heard.ends.size(), 1);
        QVERIFY(heard.ends[0].file.isEmpty());
        QCOMPARE(heard.ends[0].problem.isEmpty(), status == 200);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList{});
    }

    void serversThatForbidItAreNotFetchedFrom()
    {
        TileLoader loader(configOf("Skyseal/1"));
        Listener heard(loader);
        loader.setSource(serverAt(QStringLiteral("https://tile.openstreetmap.org/{z}/{x}/{y}.png")));
        loader.fetchRegion({QRectF(0, 0, 10, 10), 0, 2}, m_folder->filePath(QStringLiteral("area.mbtiles")));
        EVENTUALLY_EQUAL(heard.ends.size(), 1);
        QVERIFY(heard.ends[0].problem.contains(QStringLiteral("openstreetmap.org")));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

SKYSEAL_TEST_WIDGETS(TilesTest)
#include "tiles_test.moc"
