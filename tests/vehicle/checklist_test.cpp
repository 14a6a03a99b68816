// Checklists as text files: items, conditions in the grammar of flight scripts, and lines that are wrong, named by number.
#include "core/vehicle/checklist.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::vehicle;

class ChecklistTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itemsAreReadWithTheirConditions()
    {
        const auto list = parseChecklist("\xEF\xBB\xBF# Quadrotor\r\n\r\n  Propellers tight \r\n"
                                         "Battery full [ battery_percent>=90 ]\n[x] is text\nMode [mode==LOITER]",
                                         "quad.txt");
        QVERIFY2(list, list ? "" : list.error().text().c_str());
        QCOMPARE(list->items.size(), std::size_t(4));
        QCOMPARE(list->items[0].text, std::string("Propellers tight"));
        QVERIFY(!list->items[0].condition);
        QCOMPARE(list->items[1].text, std::string("Battery full"));
        QCOMPARE(list->items[1].conditionText, std::string("battery_percent>=90"));
        QCOMPARE(list->items[2].text, std::string("[x] is text"));
        QVERIFY(list->problems.empty());

        VehicleState state;
        const WaitUntil &battery = *list->items[1].condition, &mode = *list->items[3].condition;
        QVERIFY(!battery.fulfilledBy(state)); // unknown
        state.batteryPercent = 90;
        state.mode = "LOITER";
        QVERIFY(battery.fulfilledBy(state) && mode.fulfilledBy(state));
        state.batteryPercent = 89.5;
        QVERIFY(!battery.fulfilledBy(state));
    }

    void wrongConditionIsNamedAndItsItemStays_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("problem");
        QTest::newRow("unknown field") << QByteArray("Charged [charge>=90]")
                                       << QByteArray("q.txt:3:10: expected a field's name (");
        QTest::newRow("no operator") << QByteArray("A [battery_percent 90]")
                                     << QByteArray("q.txt:3:20: expected one of >= <= > < == !=, found '90'");
        QTest::newRow("empty") << QByteArray("A []") << QByteArray("q.txt:3:4: expected a field's name (");
        QTest::newRow("no value") << QByteArray("A [battery_v>]")
                                  << QByteArray("q.txt:3:14: expected a number to compare battery_v with, found nothing");
        QTest::newRow("too much") << QByteArray("A [armed==0 5]")
                                  << QByteArray("q.txt:3:13: expected the end of the condition");
        QTest::newRow("no text") << QByteArray("[armed==0]") << QByteArray("q.txt:3:1: expected the text of the item");
    }

    void wrongConditionIsNamedAndItsItemStays()
    {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, problem);
        const auto list = parseChecklist("First\n\n" + line.toStdString() + "\nLast [armed==0]\n", "q.txt");
        QVERIFY(list);
        QCOMPARE(list->items.size(), std::size_t(3));
        QCOMPARE(list->items[1].text, line.toStdString());
        QVERIFY(!list->items[1].condition);
        QVERIFY(list->items[2].condition);
        QCOMPARE(list->problems.size(), std::size_t(1));
        QVERIFY2(list->problems[0].text().starts_with(problem.toStdString()), list->problems[0].text().c_str());
    }

    void otherFilesAreRefused()
    {
        const auto problem = [](const std::string &text) {
            const auto list = parseChecklist(text, "q.txt");
            return list ? std::string() : list.error().text();
        };
        QCOMPARE(problem("\n# only a comment\n"), std::string("q.txt: no items"));
        QCOMPARE(problem("One\n\x01\x02\n"), std::string("q.txt:2: a control character: this is not a text file"));
        QVERIFY(problem("One\n" + std::string(kMaxChecklistItem + 1, 'x')).starts_with("q.txt:2: an item longer"));
        QVERIFY(problem(std::string(kMaxChecklistSize + 1, '\n')).starts_with("q.txt: longer"));
        std::string many;
        for (std::size_t i = 0; i <= kMaxChecklistItems; ++i)
            many += "Item\n";
        QVERIFY(problem(many).starts_with("q.txt:201: more than"));
    }
};

SKYSEAL_TEST_APPLESS(ChecklistTest)
#include "checklist_test.moc"
