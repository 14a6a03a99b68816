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
    void parameterFilesAsPeopleHaveThem();
    void parametersBelongToComponents();
    void latestOfSeveralValuesCounts();
    void badLineCostsItselfOnly();
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
    QTest::newRow("many columns") << head + QByteArray("1 ").repeated(100'000)
                                  << QByteArray("m:2: an item has 12 columns, this line has 100 or more");
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
    QVERIFY(plain->unread.empty() && plain->repeats.empty());
    const auto &parameters = plain->parameters;
    QCOMPARE(parameters.size(), std::size_t(3));
    QCOMPARE(parameters[1].name, std::string("WPNAV_SPEED"));
    QCOMPARE(parameters[1].value, 750.);
    QCOMPARE(parameters[2].value, 0.135);
    QCOMPARE(parameters[2].componentId, std::uint8_t(0));
    const auto qgc = parseParameters("# Vehicle-Id Component-Id Name Value Type\n1\t1\tCOM_LIMIT\t-7\t6\n", "p");
    QVERIFY(qgc && qgc->parameters.size() == 1);
    QCOMPARE(qgc->parameters[0].name, std::string("COM_LIMIT"));
    QCOMPARE(qgc->parameters[0].value, -7.);
    QCOMPARE(qgc->parameters[0].type, std::uint8_t(mavlink::MAV_PARAM_TYPE_INT32));
    QCOMPARE(qgc->parameters[0].componentId, std::uint8_t(1));
}

/// Lines of files that ArduPilot and MAVProxy load, and what a vehicle without a calibration reports.
void PlanFileTest::parameterFilesAsPeopleHaveThem()
{
    const std::string text = "\xef\xbb\xbfMNT1_TYPE        1           # a comment behind a value\r"
                             "FRAME_CLASS\t     2\r\n"
                             "   RTL_ALT=1500\n"
                             "BRD_OPTIONS 0x1F @READONLY # of the board\n"
                             "  # indented\n"
                             "COMPASS_ODI_X,nan\nCOMPASS_OFS_X,-Inf\nCOMPASS_OFS_Y\tNaN\n"
                             "1 1 SYSID_THISMAV +7 2\n";
    const auto read = parseParameters(text, "p");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY2(read->unread.empty(), read->unread.empty() ? "" : read->unread[0].text().c_str());
    QCOMPARE(read->parameters.size(), std::size_t(8));
    const auto value = [&](std::size_t i) { return read->parameters[i].value; };
    QCOMPARE(value(0), 1.);
    QCOMPARE(value(1), 2.);
    QCOMPARE(value(2), 1500.);
    QCOMPARE(value(3), 31.);
    QVERIFY(std::isnan(value(4)) && std::isnan(value(6)));
    QCOMPARE(value(5), -HUGE_VAL);
    QCOMPARE(value(7), 7.);
}

void PlanFileTest::parametersBelongToComponents()
{
    const std::string text = "1\t1\tRTL_ALT\t1500\t4\n1\t154\tG_PARAM_PAN\t0.5\t9\n1\t154\tRTL_ALT\t3\t4\n";
    const auto read = parseParameters(text, "p");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->repeats.empty());
    QCOMPARE(read->parameters.size(), std::size_t(3));
    QCOMPARE(read->parameters[2].componentId, std::uint8_t(154));
    QCOMPARE(qgcParameterText(read->parameters, 1, 1), "# Vehicle-Id Component-Id Name Value Type\n" + text);
    const std::vector<Parameter> ofTheVehicle{{.name = "A", .value = 1}, {.name = "B", .value = 2, .componentId = 154}};
    QCOMPARE(qgcParameterText(ofTheVehicle, 3, 7),
             std::string("# Vehicle-Id Component-Id Name Value Type\n3\t7\tA\t1\t9\n3\t154\tB\t2\t9\n"));
    QCOMPARE(parameterText(ofTheVehicle), std::string("A,1\n")); // a form without components
}

void PlanFileTest::latestOfSeveralValuesCounts()
{
    const auto read = parseParameters("RTL_ALT,1500\nWPNAV_SPEED,500\nRTL_ALT,2000\nWPNAV_SPEED 500\n", "p");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->parameters.size(), std::size_t(2));
    QCOMPARE(read->parameters[0].value, 2000.);
    QVERIFY(read->unread.empty());
    QCOMPARE(read->repeats.size(), std::size_t(1)); // the same value again is none
    QCOMPARE(read->repeats[0].text(), std::string("p:3: RTL_ALT occurs again; this line counts"));
}

void PlanFileTest::badLineCostsItselfOnly()
{
    const auto read = parseParameters("A,1\nB\nC 2,5\nD,one\nE,5\n", "p");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->parameters.size(), std::size_t(2));
    QCOMPARE(read->parameters[1].name, std::string("E"));
    QCOMPARE(read->unread.size(), std::size_t(3));
    QCOMPARE(read->unread[0].text(),
             std::string("p:2:1: a name and a value, or QGroundControl's five columns, are expected, not \"B\""));
    QCOMPARE(read->unread[1].text(), std::string("p:3:3: \"2,5\" has a decimal comma; numbers in files have a point"));
    QCOMPARE(read->unread[2].text(), std::string("p:4:3: \"one\" is not a number"));
}

void PlanFileTest::parameterFileComesBack()
{
    QVERIFY(rc::check("every value is read back as it was, within the precision of its type", [] {
        std::vector<Parameter> written;
        for (int i = 0; i < 5; ++i) {
            const bool isWide = *rc::gen::arbitrary<bool>();
            const double value = isWide ? *rc::gen::arbitrary<std::int32_t>()
                                        : static_cast<double>(static_cast<float>(*rc::gen::arbitrary<double>()));
            written.push_back({.name = "P" + std::to_string(i), .value = value, .type = std::uint8_t(isWide ? 6 : 9)});
        }
        const bool qgcForm = *rc::gen::arbitrary<bool>();
        const auto read = parseParameters(qgcForm ? qgcParameterText(written, 1, 1) : parameterText(written), "p");
        RC_ASSERT(read && read->unread.empty() && read->parameters.size() == written.size());
        for (std::size_t i = 0; i < written.size(); ++i) {
            const Parameter &one = read->parameters[i];
            RC_ASSERT(one.name == written[i].name);
            RC_ASSERT((static_cast<float>(one.value) == static_cast<float>(written[i].value)
                       || (std::isnan(one.value) && std::isnan(written[i].value))));
            RC_ASSERT((written[i].type != 6 || one.value == written[i].value));
            RC_ASSERT((!qgcForm || one.type == written[i].type));
        }
    }));
    QCOMPARE(parameterText({{.name = "A", .value = static_cast<double>(0.135f)}}), std::string("A,0.135\n"));
    // Whole numbers as such: other stations read them as integers.
    QCOMPARE(parameterText({{.name = "A", .value = 10000000}, {.name = "B", .value = 2147483647, .type = 6}}),
             std::string("A,10000000\nB,2147483647\n"));
}

void PlanFileTest::badParameterFilesSayWhere_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("error");
    QTest::newRow("empty") << QByteArray() << QByteArray("p: contains no parameters");
    QTest::newRow("comments only") << QByteArray("# nothing\n") << QByteArray("p: contains no parameters");
    QTest::newRow("no number") << QByteArray("\nA, one\n") << QByteArray("p:2:4: \"one\" is not a number");
    QTest::newRow("hexadecimal") << QByteArray("A 0x1g\n") << QByteArray("p:1:3: \"0x1g\" is not a number");
    QTest::newRow("name") << QByteArray("A_NAME_THAT_IS_TOO_LONG,1\n")
                          << QByteArray(
                                 "p:1:1: \"A_NAME_THAT_IS_TOO_LONG\" is not a name of at most 16 letters, digits and signs");
    QTest::newRow("control character") << QByteArray("A\x1b[0m,1\n")
                                       << QByteArray("p:1:1: \"A?[0m\" is not a name of at most 16 letters, digits and signs");
    QTest::newRow("type") << QByteArray("1\t1\tA\t1\t99\n") << QByteArray("p:1:9: \"99\" is not a type of parameters");
    QTest::newRow("component") << QByteArray("1\t0\tA\t1\t9\n") << QByteArray("p:1:3: \"0\" is not a component from 1 to 255");
    QByteArray many;
    for (int i = 0; i <= 8192; ++i)
        many += "P" + QByteArray::number(i) + ",1\n";
    QTest::newRow("too many") << many << QByteArray("p:8193: more than 8192 parameters");
    QTest::newRow("something else") << "A,1\n" + QByteArray("a line of prose\n").repeated(200)
                                    << QByteArray("p:102: not a parameter file: 100 lines before this one cannot be read");
}

void PlanFileTest::badParameterFilesSayWhere()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, error);
    const auto parsed = parseParameters(text.toStdString(), "p");
    QVERIFY(!parsed);
    QCOMPARE(QByteArray::fromStdString(parsed.error().text()), error);
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
        if (const auto file = parseParameters(text, "p")) {
            for (const Parameter &parameter : file->parameters)
                RC_ASSERT(!parameter.name.empty() && parameter.name.size() <= 16);
            RC_ASSERT(file->unread.size() <= kMostUnread);
        }
    }));
}

SKYSEAL_TEST_APPLESS(PlanFileTest)
#include "plan_file_test.moc"
