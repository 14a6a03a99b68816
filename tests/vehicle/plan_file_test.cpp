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
    QVERIFY(std::isnan((*again)[1].parameters[3]));
    (*again)[1].parameters[3] = items[1].parameters[3] = 0;
    QCOMPARE(*again, items);
    QVERIFY(parseMission("QGC WPL 110\r\n0 1 0 16 0 0 0 0 +47 8 100 1\r\n\r\n", "m")); // other line ends, spaces
}

void PlanFileTest::badMissionFilesSayWhere_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::newRow("empty") << QByteArray() << 1;
    QTest::newRow("other kind") << QByteArray("hello\n") << 1;
    QTest::newRow("no items") << QByteArray("QGC WPL 110\n") << 0;
    QTest::newRow("columns") << QByteArray("QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 100\n") << 2;
    QTest::newRow("no number") << QByteArray("QGC WPL 110\n0 1 0 16 0 0 0 0 47 east 100 1\n") << 2;
    QTest::newRow("latitude") << QByteArray("QGC WPL 110\n0 1 0 16 0 0 0 0 97 8 100 1\n") << 2;
    QTest::newRow("gap") << QByteArray("QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 100 1\n2 0 3 16 0 0 0 0 47 8 20 1\n") << 3;
    QTest::newRow("nan") << QByteArray("QGC WPL 110\n0 1 0 16 0 0 0 0 nan 8 100 1\n") << 2;
    QTest::newRow("infinite") << QByteArray("QGC WPL 110\n0 1 0 16 inf 0 0 0 47 8 100 1\n") << 2;
}

void PlanFileTest::badMissionFilesSayWhere()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    const auto parsed = parseMission(text.toStdString(), "m.waypoints");
    QVERIFY(!parsed);
    QCOMPARE(parsed.error().source, std::string("m.waypoints"));
    QCOMPARE(static_cast<int>(parsed.error().line), line);
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
        if (const auto items = parseMission(text, "m")) {
            for (std::size_t i = 0; i < items->size(); ++i)
                RC_ASSERT((*items)[i].sequence == i && std::abs((*items)[i].latitude) <= 90);
        }
        if (const auto parameters = parseParameters(text, "p")) {
            for (const Parameter &parameter : *parameters)
                RC_ASSERT(!parameter.name.empty() && parameter.name.size() <= 16 && std::isfinite(parameter.value));
        }
    }));
}

SKYSEAL_TEST_APPLESS(PlanFileTest)
#include "plan_file_test.moc"
