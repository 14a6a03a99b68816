// Mission and parameter files: what is written is read back, damaged files say where.
#include "core/vehicle/mission_file.h"
#include "core/vehicle/parameter_file.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <cmath>

using namespace skyseal;
using namespace skyseal::vehicle;

class PlanFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void missionFileComesBack();
    void missionFilesAsPeopleHaveThem();
    void itemsWithoutAPlaceKeepTheirNumbers();
    void numbersFromOneAreThoseBehindAHome();
    void badMissionFilesSayWhere_data();
    void badMissionFilesSayWhere();
    void parameterFilesOfBothForms();
    void parameterFileComesBack();
    void badParameterFilesSayWhere_data();
    void badParameterFilesSayWhere();
    void anyTextIsParsedOrRefused();
};

void PlanFileTest::missionFileComesBack()
{
    std::vector<vehicle::MissionItem> items(3);
    items[0].current = true;
    items[1] = {1, 22, 3, false, false, {15, 0, 0.1f, std::nanf("")}, 47.39804191, -8.54559371, 12.5f};
    items[2].sequence = 2;
    items[2].parameters[1] = -1.5e-7f;
    const std::string text = missionText(items);
    QVERIFY(text.starts_with("QGC WPL 110\n0\t1\t3\t16\t0\t"));
    auto again = parseMission(text, "m");
    QVERIFY2(again, again ? "" : again.error().text().c_str());
    QVERIFY(std::isnan(again->items[1].parameters[3]));
    again->items[1].parameters[3] = items[1].parameters[3] = 0;
    QCOMPARE(again->items, items);
    QVERIFY(!again->withoutHome);
}

/// Byte order marks, comments, all line ends, blanks for tabs, NaN in any case: what stations, scripts and editors write.
void PlanFileTest::missionFilesAsPeopleHaveThem()
{
    const std::string first = "0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t100\t1", second = "1 0 3 22 15 0 0 NaN nan -NAN 40 1";
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const std::string text = "\xef\xbb\xbfQGC WPL 110" + end + "# a comment" + end + end + first + end + "\t# and another"
            + end + second + "  # behind an item" + end;
        const auto read = parseMission(text, "m");
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(read->items.size(), std::size_t(2));
        const MissionItem &takeOff = read->items[1];
        QVERIFY(std::isnan(takeOff.parameters[3]) && std::isnan(takeOff.latitude) && std::isnan(takeOff.longitude));
        QCOMPARE(takeOff.altitude, 40.f);
    }
    QVERIFY(parseMission("QGC WPL 110\n0 1 0 16 0 0 0 0 +47 8 100 1", "m")); // no end of the last line
    // Frames for integers are synonyms that not every station reads.
    const auto frames = parseMission(
        "QGC WPL 110\n0 1 5 16 0 0 0 0 47 8 1 1\n1 0 6 16 0 0 0 0 47 8 1 1\n2 0 11 16 0 0 0 0 47 8 1 1\n", "m");
    QVERIFY(frames);
    QCOMPARE(frames->items[0].frame, std::uint8_t(0));
    QCOMPARE(frames->items[1].frame, std::uint8_t(3));
    QCOMPARE(frames->items[2].frame, std::uint8_t(10));
    QVERIFY(missionText({{.frame = 11}}).starts_with("QGC WPL 110\n0\t0\t10\t"));
}

void PlanFileTest::itemsWithoutAPlaceKeepTheirNumbers()
{
    // A photo (203), flags of a gimbal (1000), a place in metres: none is a latitude, so that none has to be on the globe.
    const auto read = parseMission("QGC WPL 110\n0 1 3 203 0 0 0 0 1 0 0 1\n1 0 3 1000 -30 90 0 0 4096 0 154 1\n"
                                   "2 0 1 16 0 0 0 0 500.25 -200 -10 1\n",
                                   "m");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->items[0].latitude, 1.);
    QCOMPARE(read->items[1].latitude, 4096.);
    QCOMPARE(read->items[2].latitude, 500.25);
    QCOMPARE(parseMission(missionText(read->items), "m")->items, read->items);
}

void PlanFileTest::numbersFromOneAreThoseBehindAHome()
{
    const auto read = parseMission("QGC WPL 110\n1 0 3 22 0 0 0 0 0 0 20 1\n2 0 3 177 1 3 0 0 0 0 0 1\n", "m");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->withoutHome);
    QCOMPARE(read->items[0].sequence, std::uint16_t(0));
    QCOMPARE(read->items[1].parameters[0], 0.f); // the jump still leads to the take-off
    const auto ofPx4 = parseMission("QGC WPL 120\n0 1 0 16 0 0 0 0 47 8 100 1\n", "m");
    QVERIFY(ofPx4 && ofPx4->withoutHome);
}

void PlanFileTest::badMissionFilesSayWhere_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("error");
    const QByteArray head("QGC WPL 110\n"), home("0 1 0 16 0 0 0 0 47 8 100 1\n");
    QTest::newRow("empty") << QByteArray() << QByteArray("m:1: not a mission file: the first line must be \"QGC WPL 110\"");
    QTest::newRow("other kind") << QByteArray("hello\n")
                                << QByteArray("m:1: not a mission file: the first line must be \"QGC WPL 110\"");
    QTest::newRow("plan in JSON") << QByteArray("{\n\"fileType\": \"Plan\"}")
                                  << QByteArray("m:1: this is a plan in JSON; mission files begin with \"QGC WPL 110\"");
    QTest::newRow("version") << QByteArray("QGC WPL 100\n")
                             << QByteArray("m:1: version 100 of mission files is not known, only 110 and 120");
    QTest::newRow("no items") << head + "# nothing\n" << QByteArray("m: the file has no items after its first line");
    QTest::newRow("columns") << head + "0 1 0 16 0 0 0 0 47 8 100\n"
                             << QByteArray("m:2: an item has 12 columns, this line has 11");
    QTest::newRow("no number") << head + "0 1 0 16 0 0 0 0 47 east 100 1\n" << QByteArray("m:2:21: \"east\" is not a number");
    QTest::newRow("decimal comma") << head + home + "1\t0\t3\t16\t1\t0\t0\t0\t14,01000\t80,5000\t20\t1\n"
                                   << QByteArray("m:3:18: \"14,01000\" has a decimal comma; numbers in files have a point");
    QTest::newRow("latitude") << head + "0 1 0 16 0 0 0 0 97 8 100 1\n"
                              << QByteArray("m:2:18: \"97\" is not a latitude from -90 to 90");
    QTest::newRow("longitude") << head + "# 1\n" + "0 1 0 16 0 0 0 0 47 -188 100 1\n"
                               << QByteArray("m:3:21: \"-188\" is not a longitude from -180 to 180");
    QTest::newRow("gap") << head + home + "2 0 3 16 0 0 0 0 47 8 20 1\n"
                         << QByteArray("m:3:1: item 2 stands where item 1 is expected");
    QTest::newRow("begins in the middle") << head + "2 0 3 16 0 0 0 0 47 8 20 1\n"
                                          << QByteArray("m:2:1: item 2 stands where item 0 is expected");
    QTest::newRow("no command") << head + "0 1 0 nan 0 0 0 0 47 8 100 1\n" << QByteArray("m:2:7: \"nan\" is not a number");
    QTest::newRow("half a command") << head + "0 1 0 16.5 0 0 0 0 47 8 100 1\n"
                                    << QByteArray("m:2:7: \"16.5\" is not a whole number from 0 to 65535");
    QTest::newRow("infinite") << head + "0 1 0 16 inf 0 0 0 47 8 100 1\n" << QByteArray("m:2:10: \"inf\" is not a number");
    QTest::newRow("too large") << head + "0 1 0 16 1e39 0 0 0 47 8 100 1\n" << QByteArray("m:2:10: \"1e39\" is not a number");
    QTest::newRow("control characters") << head + "0 1 0 16 0 0 0 0 \x1b[2J 8 100 1\n"
                                        << QByteArray("m:2:18: \"?[2J\" is not a number");
}

void PlanFileTest::badMissionFilesSayWhere()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, error);
    const auto parsed = parseMission(text.toStdString(), "m");
    QVERIFY(!parsed);
    QCOMPARE(QByteArray::fromStdString(parsed.error().text()), error);
}

void PlanFileTest::parameterFilesOfBothForms()
{
    const auto plain = parseParameters("# from a copter\nRTL_ALT,1500\n\nWPNAV_SPEED 7.5e2\r\nATC_RAT_RLL_P, 0.135\n", "p");
    QVERIFY2(plain, plain ? "" : plain.error().text().c_str());
    QCOMPARE(plain->size(), std::size_t(3));
    QCOMPARE((*plain)[1].name, std::string("WPNAV_SPEED"));
    QCOMPARE((*plain)[1].value, 750.);
    QCOMPARE((*plain)[2].value, 0.135);
    const auto qgc = parseParameters("# Vehicle-Id Component-Id Name Value Type\n1\t1\tCOM_LIMIT\t-7\t6\n", "p");
    QVERIFY(qgc && qgc->size() == 1);
    QCOMPARE((*qgc)[0].name, std::string("COM_LIMIT"));
    QCOMPARE((*qgc)[0].value, -7.);
    QCOMPARE((*qgc)[0].type, std::uint8_t(mavlink::MAV_PARAM_TYPE_INT32));
}

void PlanFileTest::parameterFileComesBack()
{
    QVERIFY(rc::check("every value is read back as it was, within the precision of its type", [] {
        std::vector<Parameter> written;
        for (int i = 0; i < 5; ++i) {
            const bool isWide = *rc::gen::arbitrary<bool>();
            const double value = isWide ? *rc::gen::arbitrary<std::int32_t>()
                                        : static_cast<double>(static_cast<float>(*rc::gen::arbitrary<double>()));
            if (std::isfinite(value))
                written.push_back({.name = "P" + std::to_string(i), .value = value, .type = std::uint8_t(isWide ? 6 : 9)});
        }
        RC_PRE(!written.empty());
        const bool qgcForm = *rc::gen::arbitrary<bool>();
        const auto read = parseParameters(qgcForm ? qgcParameterText(written, 1, 1) : parameterText(written), "p");
        RC_ASSERT(read && read->size() == written.size());
        for (std::size_t i = 0; i < written.size(); ++i) {
            RC_ASSERT((*read)[i].name == written[i].name);
            RC_ASSERT(static_cast<float>((*read)[i].value) == static_cast<float>(written[i].value));
            RC_ASSERT((written[i].type != 6 || (*read)[i].value == written[i].value));
            RC_ASSERT((!qgcForm || (*read)[i].type == written[i].type));
        }
    }));
    QCOMPARE(parameterText({{.name = "A", .value = static_cast<double>(0.135f)}}), std::string("A,0.135\n"));
}

void PlanFileTest::badParameterFilesSayWhere_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::newRow("empty") << QByteArray() << 0;
    QTest::newRow("comments only") << QByteArray("# nothing\n") << 0;
    QTest::newRow("no value") << QByteArray("A,1\nB\n") << 2;
    QTest::newRow("no number") << QByteArray("A,one\n") << 1;
    QTest::newRow("nan") << QByteArray("A,nan\n") << 1;
    QTest::newRow("name") << QByteArray("A_NAME_THAT_IS_TOO_LONG,1\n") << 1;
    QTest::newRow("control character") << QByteArray("A\x1b[0m,1\n") << 1;
    QTest::newRow("twice") << QByteArray("A,1\nB,2\nA,3\n") << 3;
    QTest::newRow("type") << QByteArray("1\t1\tA\t1\t99\n") << 1;
    QByteArray many;
    for (int i = 0; i <= 8192; ++i)
        many += "P" + QByteArray::number(i) + ",1\n";
    QTest::newRow("too many") << many << 8193;
}

void PlanFileTest::badParameterFilesSayWhere()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    const auto parsed = parseParameters(text.toStdString(), "p.param");
    QVERIFY(!parsed);
    QCOMPARE(parsed.error().source, std::string("p.param"));
    QCOMPARE(static_cast<int>(parsed.error().line), line);
}

void PlanFileTest::anyTextIsParsedOrRefused()
{
    QVERIFY(rc::check("items and names are within their bounds, whatever the text", [] {
        const auto piece = rc::gen::element<std::string>("QGC WPL 110\n", "0", "1", "\t", " ", ",", "\n", "\r", "nan", "1e999",
                                                         "-", "47.5", "65536", "#", "NAME", std::string(1, '\0'), "\xff");
        std::string text = *rc::gen::element<std::string>("", "QGC WPL 110\n", "0 1 0 16 0 0 0 0 47 8 100 1\n");
        for (const std::string &part : *rc::gen::container<std::vector<std::string>>(piece))
            text += part;
        if (const auto read = parseMission(text, "m")) {
            for (std::size_t i = 0; i < read->items.size(); ++i)
                RC_ASSERT(read->items[i].sequence == i && !(std::abs(read->items[i].latitude) > 90));
        }
        if (const auto parameters = parseParameters(text, "p")) {
            for (const Parameter &parameter : *parameters)
                RC_ASSERT(!parameter.name.empty() && parameter.name.size() <= 16 && std::isfinite(parameter.value));
        }
    }));
}

SKYSEAL_TEST_APPLESS(PlanFileTest)
#include "plan_file_test.moc"
