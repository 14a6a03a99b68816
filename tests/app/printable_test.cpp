// Words of others on the terminal: they are shown, and steer nothing.
#include "app/common/output.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::app;

class PrintableTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void controlCharactersAreReplaced_data();
    void controlCharactersAreReplaced();
};

void PrintableTest::controlCharactersAreReplaced_data()
{
    QTest::addColumn<QByteArray>("given");
    QTest::addColumn<QByteArray>("shown");
    QTest::newRow("plain") << QByteArray("PreArm: GPS 1 \"ok\"") << QByteArray("PreArm: GPS 1 \"ok\"");
    QTest::newRow("letters of others") << QByteArray("H\xc3\xb6he \xc2\xb5 \xe2\x82\xac")
                                       << QByteArray("H\xc3\xb6he \xc2\xb5 \xe2\x82\xac");
    QTest::newRow("title of the window") << QByteArray("\x1b]0;mine\x07") << QByteArray("?]0;mine?");
    QTest::newRow("further line") << QByteArray("hi\nskyseal: armed\r\x7f") << QByteArray("hi?skyseal: armed??");
    QTest::newRow("C1") << QByteArray("\xc2\x9b"
                                      "2J")
                        << QByteArray("??2J");
}

void PrintableTest::controlCharactersAreReplaced()
{
    QFETCH(QByteArray, given);
    QFETCH(QByteArray, shown);
    QCOMPARE(QByteArray::fromStdString(printable(given.toStdString())), shown);
}

SKYSEAL_TEST(PrintableTest)
#include "printable_test.moc"
