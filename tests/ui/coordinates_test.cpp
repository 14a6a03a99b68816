// Places as texts. The UTM and UPS values are those of PROJ 9.1.1 (`proj +proj=utm +zone=… +ellps=WGS84`), the MGRS references
// those of two programs that agree: the npm packages mgrs 2.2.0 and @ngageoint/mgrs-js 1.0.0 (NGA). Neither contains
// GeographicLib. The first place is the example of GeographicLib's man page GeoConvert(1).
#include "tests/support/test_runner.h"
#include "ui/settings.h"
#include "ui/text/coordinates.h"
#include "ui/text/units.h"

#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>
#include <limits>

using namespace skyseal;
using namespace skyseal::ui;

class CoordinatesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gridOfKnownPlaces_data()
    {
        QTest::addColumn<double>("latitude");
        QTest::addColumn<double>("longitude");
        QTest::addColumn<QString>("utm");
        QTest::addColumn<QString>("mgrs");
        const auto row = [](const char *name, double latitude, double longitude, const char *utm, const char *mgrs) {
            QTest::newRow(name) << latitude << longitude << QString::fromLatin1(utm) << QString::fromLatin1(mgrs);
        };
        row("Baghdad", 33.3, 44.4, "38 north 444141 mE 3684706 mN", "38S MB 44140 84706");
        row("Canberra", -35.363261, 149.165230, "55 south 696719 mE 6084520 mN", "55H FA 96719 84519");
        row("band S in the north", 33, 9, "32 north 500000 mE 3651287 mN", "32S NB 00000 51286");
        row("equator", 0, 0, "31 north 166021 mE 0 mN", "31N AA 66021 00000");
        row("just south of it", -0.00001, 3, "31 south 500000 mE 9999999 mN", "31M EV 00000 99998");
        row("Bergen: zone 32 is wide", 60.39299, 5.32415, "32 north 297477 mE 6700830 mN", "32V KN 97477 00830");
        row("its corner", 56, 3, "32 north 126050 mE 6222336 mN", "32V JH 26049 22336");
        row("south of it", 55.9999, 3, "31 north 500000 mE 6206068 mN", "31U EC 00000 06068");
        row("Svalbard: no zone 32", 79, 8.5, "31 north 616989 mE 8775490 mN", "31X FH 16989 75490");
        row("Svalbard: zone 33", 79, 9.5, "33 north 383011 mE 8775490 mN", "33X UH 83010 75490");
        row("Longyearbyen", 78.22334, 15.64689, "33 north 514739 mE 8683376 mN", "33X WG 14738 83376");
        row("Svalbard: zone 35", 79, 25, "35 north 457406 mE 8770704 mN", "35X MH 57405 70703");
        row("Svalbard: zone 37", 79, 33.5, "37 north 383011 mE 8775490 mN", "37X CH 83010 75490");
        row("west of the date line", -17.5, 179.99, "60 south 817528 mE 8062638 mN", "60K ZF 17528 62638");
        row("east of it", -17.5, -179.99, "1 south 182472 mE 8062638 mN", "01K AA 82471 62638");
        row("on it", 10, -180, "1 north 171071 mE 1106909 mN", "01P AM 71071 06908");
        // Without a reference of those programs, which leave out the poles: the letters by NGA.STND.0037 from the UPS values.
        row("near the north pole", 84.5, 30, "UPS north 2305541 mE 1470788 mN", "Z FB 05540 70788");
        row("north pole", 90, 0, "UPS north 2000000 mE 2000000 mN", "Z AH 00000 00000");
        row("south pole", -90, 0, "UPS south 2000000 mE 2000000 mN", "B AN 00000 00000");
        row("Antarctica", -82, -100, "UPS south 1123937 mE 1845526 mN", "A PL 23936 45526");
    }

    void gridOfKnownPlaces()
    {
        QFETCH(double, latitude);
        QFETCH(double, longitude);
        QFETCH(QString, mgrs);
        QTEST(coordinatesText(latitude, longitude, CoordinateFormat::Utm), "utm");
        QCOMPARE(coordinatesText(latitude, longitude, CoordinateFormat::Mgrs), mgrs);
        QCOMPARE(coordinatesToCopy(latitude, longitude, CoordinateFormat::Mgrs), mgrs.remove(QLatin1Char(' ')));
    }

    void gridIsCopiedForOtherPrograms()
    {
        const auto copied = [](double latitude, double longitude) {
            return coordinatesToCopy(latitude, longitude, CoordinateFormat::Utm);
        };
        QCOMPARE(copied(33.3, 44.4), QStringLiteral("38n 444141 3684706"));
        QCOMPARE(copied(-35.363261, 149.165230), QStringLiteral("55s 696719 6084520"));
        QCOMPARE(copied(-90, 0), QStringLiteral("s 2000000 2000000"));
    }

    void noPlaceHasNoGrid_data()
    {
        QTest::addColumn<double>("latitude");
        QTest::addColumn<double>("longitude");
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("unknown latitude") << kNone << 8.5;
        QTest::newRow("unknown longitude") << 47.4 << kNone;
        QTest::newRow("beyond the pole") << 90.1 << 0.0;
        QTest::newRow("endless") << 0.0 << std::numeric_limits<double>::infinity();
    }

    void noPlaceHasNoGrid()
    {
        QFETCH(double, latitude);
        QFETCH(double, longitude);
        for (const CoordinateFormat format : {CoordinateFormat::Utm, CoordinateFormat::Mgrs}) {
            QCOMPARE(coordinatesText(latitude, longitude, format), dash());
            QVERIFY(coordinatesToCopy(latitude, longitude, format).isEmpty());
        }
    }

    void widestIsAsLongAsAny()
    {
        for (const CoordinateFormat format : {CoordinateFormat::Decimal, CoordinateFormat::DegreesMinutesSeconds,
                                              CoordinateFormat::Utm, CoordinateFormat::Mgrs})
            for (double latitude = -85; latitude <= 85; latitude += 5)
                for (double longitude = -180; longitude < 180; longitude += 15)
                    QVERIFY2(coordinatesText(latitude, longitude, format).size() <= widestCoordinates(format).size(),
                             qPrintable(coordinatesText(latitude, longitude, format)));
    }

    void formatIsKept()
    {
        const QTemporaryDir folder;
        QSettings store(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        Settings settings;
        for (const CoordinateFormat format : {CoordinateFormat::Utm, CoordinateFormat::Mgrs}) {
            settings.coordinates = format;
            storeSettings(store, settings);
            QCOMPARE(loadSettings(store).coordinates, format);
        }
        store.setValue(QStringLiteral("view/coordinates"), 4);
        QCOMPARE(loadSettings(store).coordinates, CoordinateFormat::Decimal);
    }
};

SKYSEAL_TEST(CoordinatesTest)
#include "coordinates_test.moc"
