// GeoJSON: its shapes, what is left out of them, and what is refused with its path.
#include "core/overlay/geojson_reader.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::overlay;

class GeoJsonReaderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void shapesAndTheirNames()
    {
        const auto read = readGeoJson(R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"Field"},"geometry":{"type":"Polygon","coordinates":
 [[[1,0,99],[9,0],[9,5],[1,0,99]],[[3,1],[4,1],[4,2],[3,1]]]}},
{"type":"Feature","properties":{"title":"Both"},"geometry":{"type":"GeometryCollection","geometries":[
 {"type":"MultiPoint","coordinates":[[8.5,47.25],[1,2]]},{"type":"LineString","coordinates":[[179,-1],[-179,1]]}]}},
{"type":"Feature","properties":null,"geometry":{"type":"MultiPolygon","coordinates":
 [[[[0,0],[1,0],[1,1]]],[[[5,0],[6,0],[6,1]]]]}},
{"type":"Feature","properties":{},"geometry":{"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[2,2],[3,3],[4,4]]]}}]})");
        QVERIFY(read);
        const auto &shapes = read->shapes;
        QCOMPARE(shapes.size(), std::size_t(8));
        QCOMPARE(shapes[0].kind, ShapeKind::Polygon);
        QCOMPARE(shapes[0].name, QStringLiteral("Field"));
        QVERIFY(shapes[0].lines[0] == (OverlayLine{{0, 1}, {0, 9}, {5, 9}})); // the first point is not repeated
        QVERIFY(shapes[0].lines[1] == (OverlayLine{{1, 3}, {1, 4}, {2, 4}}));
        QCOMPARE(shapes[1].kind, ShapeKind::Point);
        QVERIFY(shapes[1].lines[0] == (OverlayLine{{47.25, 8.5}}));
        QCOMPARE(shapes[3].kind, ShapeKind::Line);
        QCOMPARE(shapes[3].name, QStringLiteral("Both"));
        QCOMPARE(shapes[5].kind, ShapeKind::Polygon);
        QCOMPARE(shapes[7].lines[0].size(), std::size_t(3));
        QCOMPARE(read->leftOut, std::size_t(0));
    }

    void oneGeometryIsEnough()
    {
        const auto read = readGeoJson(R"({"type":"Point","coordinates":[8.5,47.25]})");
        QVERIFY(read);
        QVERIFY(read->shapes[0].lines[0] == (OverlayLine{{47.25, 8.5}}));
    }

    void whatCannotBeDrawnIsCounted()
    {
        const auto read = readGeoJson(R"({"type":"FeatureCollection","features":[
{"type":"Feature","geometry":null},{"type":"Point","coordinates":[]},{"type":"LineString","coordinates":[[1,2]]},
{"type":"Polygon","coordinates":[[[1,1],[2,2],[1,1]],[[1,1],[2,2],[3,1]]]}]})");
        QVERIFY(read);
        QVERIFY(read->shapes.empty());
        QCOMPARE(read->leftOut, std::size_t(4));
    }

    void errorsNameTheirPlace_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("message");
        QTest::addColumn<int>("line");
        QTest::newRow("latitude") << QByteArray(R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":
{"type":"Polygon","coordinates":[[[1,0],[9,0],[9,95]]]}}]})")
                                  << QStringLiteral(
                                         "features[0].geometry.coordinates[0][2]: the latitude 95 is not within -90 and 90")
                                  << 2;
        QTest::newRow("longitude") << QByteArray(R"({"type":"MultiPolygon","coordinates":[[[[1,0],[-181,0],[9,9]]]]})")
                                   << QStringLiteral("coordinates[0][0][1]: the longitude -181 is not within") << 1;
        QTest::newRow("words") << QByteArray(R"({"type":"LineString","coordinates":[[1,2],["1","2"]]})")
                               << QStringLiteral("coordinates[1]: this is not a position") << 1;
        QTest::newRow("type") << QByteArray(R"({"type":"Feature","geometry":{"type":"Circle"}})")
                              << QStringLiteral("geometry.type: \"Circle\" is not a type of GeoJSON") << 1;
        QTest::newRow("no features") << QByteArray(R"({"type":"FeatureCollection"})")
                                     << QStringLiteral("features: this is not an array") << 1;
        QTest::newRow("geometry") << QByteArray(R"({"type":"Feature","geometry":7})")
                                  << QStringLiteral("geometry: this is not an object") << 1;
        QTest::newRow("system") << QByteArray(R"({"type":"Point","coordinates":[1,2],"crs":{"type":"name","properties":
{"name":"urn:ogc:def:crs:EPSG::3857"}}})")
                                << QStringLiteral("crs: the coordinates are not in WGS84") << 1;
        // Texts with brackets, quotation marks and names of members lie before the position.
        const QByteArray four = "{'type': 'FeatureCollection', 'note': '~]}, coordinates',\n"
                                "'features': [\n"
                                "{'type': 'Feature', 'properties': {'geometry': [{}]}, 'geometry': null},\n"
                                "{'type': 'Feature', 'geometry': { 'type' : 'LineString', 'coordinates' :\n"
                                "[ [1, 2, 3],\n"
                                "[8, 54, 47, 39] ] } } ] }";
        QTest::newRow("four numbers") << QByteArray(four).replace('\'', '"').replace("~", QByteArray(1, '\\') + '"')
                                      << QStringLiteral(
                                             "features[1].geometry.coordinates[1]: a position has two or three numbers, not 4")
                                      << 6;
        QTest::newRow("cut") << QByteArray("{\n\"type\":\n\"Poi") << QStringLiteral("this is not JSON: ") << 3;
        QTest::newRow("array") << QByteArray("[1]") << QStringLiteral("no JSON object") << 0;
        QTest::newRow("too deep") << QByteArray(R"({"type":"GeometryCollection","geometries":[)").repeated(70)
                + QByteArray("]}").repeated(70)
                                  << QStringLiteral("more than 64 objects") << 1;
    }

    void errorsNameTheirPlace()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, message);
        QFETCH(int, line);
        const auto read = readGeoJson(content);
        QVERIFY(!read);
        const QString text = QString::fromStdString(read.error().message.text());
        QVERIFY2(!text.isEmpty() && text.contains(message), qPrintable(text));
        QCOMPARE(read.error().line, std::size_t(line));
    }

    void pointsAndValuesAreBounded()
    {
        const QByteArray most = QByteArray("[1,2],").repeated(kMostPoints - 1);
        const auto line = [](const QByteArray &positions) {
            return readGeoJson(R"({"type":"LineString","coordinates":[)" + positions + "]}");
        };
        const auto fits = line(most + "[3,4]");
        QVERIFY(fits);
        QCOMPARE(fits->shapes[0].lines[0].size(), kMostPoints);
        const auto over = line(most + "[3,4],[5,6]");
        QVERIFY(!over);
        QCOMPARE(QString::fromStdString(over.error().message.text()),
                 QStringLiteral("coordinates[200000]: the file has more than 200000 positions"));
        const auto many = line(QByteArray("[],").repeated(2'100'000) + "[]");
        QVERIFY(!many);
        QVERIFY(QString::fromStdString(many.error().message.text()).contains(QStringLiteral("values")));
    }
};

SKYSEAL_TEST(GeoJsonReaderTest)
#include "geojson_reader_test.moc"
