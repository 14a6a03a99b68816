// KML: its shapes, what is left out of them, and what is refused with its line.
#include "core/overlay/kml_reader.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::overlay;

namespace {

QByteArray placemark(const QByteArray &content)
{
    return "<kml>\n<Placemark>\n" + content + "</Placemark></kml>";
}

} // namespace

class KmlReaderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void shapesAndTheirNames()
    {
        const auto read = readKml(R"(<?xml version="1.0"?>
<k:kml xmlns:k="urn:kml"><k:Document><k:name>Not of a shape</k:name><k:Folder>
<k:Placemark><k:name> Field
 7 </k:name><k:Polygon>
<k:innerBoundaryIs><k:LinearRing><k:coordinates>3,1 4,1 4,2</k:coordinates></k:LinearRing></k:innerBoundaryIs>
<k:outerBoundaryIs><k:LinearRing><k:coordinates>1,0,99 9,0,99
 9,5 1,0,99</k:coordinates></k:LinearRing></k:outerBoundaryIs>
</k:Polygon></k:Placemark>
<k:Placemark><k:MultiGeometry><k:Point><k:coordinates> 8.5,47.25 </k:coordinates></k:Point>
<k:LineString><k:coordinates>179,-1 -179,1</k:coordinates></k:LineString></k:MultiGeometry><k:name>Both</k:name></k:Placemark>
<k:Placemark><k:LinearRing><k:coordinates>1,1 2,2</k:coordinates></k:LinearRing></k:Placemark>
</k:Folder></k:Document></k:kml>)");
        QVERIFY(read);
        const auto &shapes = read->shapes;
        QCOMPARE(shapes.size(), std::size_t(4));
        QCOMPARE(shapes[0].kind, ShapeKind::Polygon);
        QCOMPARE(shapes[0].name, QStringLiteral("Field 7"));
        QVERIFY(shapes[0].lines[0] == (OverlayLine{{0, 1}, {0, 9}, {5, 9}})); // the first point is not repeated
        QVERIFY(shapes[0].lines[1] == (OverlayLine{{1, 3}, {1, 4}, {2, 4}}));
        QCOMPARE(shapes[1].kind, ShapeKind::Point);
        QCOMPARE(shapes[1].name, QStringLiteral("Both"));
        QVERIFY(shapes[1].lines[0] == (OverlayLine{{47.25, 8.5}}));
        QCOMPARE(shapes[2].kind, ShapeKind::Line);
        QCOMPARE(shapes[2].name, QStringLiteral("Both"));
        QVERIFY(shapes[3].name.isEmpty());
        QCOMPARE(read->leftOut, std::size_t(0));
    }

    void whatCannotBeDrawnIsCounted()
    {
        const auto read = readKml(
            placemark("<MultiGeometry><Point><coordinates/></Point><LineString><coordinates>1,2</coordinates>"
                      "</LineString><Polygon><outerBoundaryIs><LinearRing><coordinates>1,1 2,2 1,1"
                      "</coordinates></LinearRing></outerBoundaryIs></Polygon></MultiGeometry>"
                      "<gx:Track/><Model/>"));
        QVERIFY(read);
        QVERIFY(read->shapes.empty());
        QCOMPARE(read->leftOut, std::size_t(5));
    }

    void namesAreCutAndShowNoInvisibleCharacters()
    {
        const auto read = readKml(placemark("<name>a\xe2\x80\xae"
                                            "b"
                                            + QByteArray(500, 'x') + "</name><Point><coordinates>1,2</coordinates></Point>"));
        QVERIFY(read);
        QVERIFY(read->shapes[0].name.startsWith(QStringLiteral("a?b")));
        QCOMPARE(read->shapes[0].name.size(), qsizetype(100));
    }

    void errorsNameTheirLine_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("message");
        const auto line = [](const QByteArray &coordinates) {
            return placemark("<LineString><coordinates>" + coordinates + "</coordinates></LineString>");
        };
        QTest::newRow("latitude") << line("1,2\n3,95\n5,6") << 4 << QStringLiteral("the latitude 95 is not within -90 and 90");
        QTest::newRow("longitude") << line("1,2 -181,3") << 3
                                   << QStringLiteral("the longitude -181 is not within -180 and 180");
        QTest::newRow("no number") << line("1,2\n\nnan,1") << 5 << QStringLiteral("the longitude nan is not");
        QTest::newRow("words") << line("north,2") << 3 << QStringLiteral("\"north,2\" is not a position");
        QTest::newRow("one number") << line("1") << 3 << QStringLiteral("\"1\" is not a position");
        QTest::newRow("space in a tuple") << line("1, 2") << 3 << QStringLiteral("\"1,\" is not a position");
        QTest::newRow("decimal commas") << line("8.5,47.3\n8,54,47,39") << 4
                                        << QStringLiteral("\"8,54,47,39\" has 4 numbers; a position has two or three");
        QTest::newRow("decimal commas with heights") << line("-10,5,45,25,174,0") << 3 << QStringLiteral("has 6 numbers");
        QTest::newRow("two coordinates") << placemark("<Point><coordinates>1,2 3,4</coordinates></Point>") << 3
                                         << QStringLiteral("more coordinates");
        QTest::newRow("nested") << placemark("<Polygon>\n<Point/></Polygon>") << 4 << QStringLiteral("within another");
        QTest::newRow("not closed") << QByteArray("<kml>\n<Document>\n</kml>") << 3 << QStringLiteral("this is not XML: ");
        QTest::newRow("another root") << QByteArray("<gpx/>") << 1 << QStringLiteral("begins with the element \"gpx\"");
        QTest::newRow("entities") << QByteArray("<!DOCTYPE kml [<!ENTITY a \"b\">]>\n<kml>&a;</kml>") << 1
                                  << QStringLiteral("document type");
        QTest::newRow("nothing") << QByteArray() << 1 << QString();
        QTest::newRow("too deep") << QByteArray("<kml>\n" + QByteArray("<Folder>").repeated(kDeepest)) << 2
                                  << QStringLiteral("more than 64 elements");
    }

    void errorsNameTheirLine()
    {
        QFETCH(QByteArray, content);
        QFETCH(int, line);
        QFETCH(QString, message);
        const auto read = readKml(content);
        QVERIFY(!read);
        const QString text = QString::fromStdString(read.error().message.text());
        QVERIFY2(!text.isEmpty() && text.contains(message), qPrintable(text));
        QCOMPARE(read.error().line, std::size_t(line));
    }

    void pointsAreBounded()
    {
        const QByteArray most = QByteArray("1,2 ").repeated(kMostPoints);
        const auto fits = readKml(placemark("<LineString><coordinates>" + most + "</coordinates></LineString>"));
        QVERIFY(fits);
        QCOMPARE(fits->shapes[0].lines[0].size(), kMostPoints);
        const auto over = readKml(placemark("<LineString><coordinates>" + most + "3,4</coordinates></LineString>"));
        QVERIFY(!over);
        QVERIFY(QString::fromStdString(over.error().message.text()).contains(QStringLiteral("more than 200000 positions")));
    }
};

SKYSEAL_TEST(KmlReaderTest)
#include "kml_reader_test.moc"
