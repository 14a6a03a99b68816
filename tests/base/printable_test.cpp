// Text of others is shown, and steers nothing.
#include "core/base/json_writer.h"
#include "core/base/printable.h"
#include "tests/support/test_runner.h"

#include <QtCore/QChar>
#include <QtCore/QString>
#include <QtTest/QTest>

using namespace skyseal;

class PrintableTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unprintableCharactersAreReplaced_data();
    void unprintableCharactersAreReplaced();
    void agreesWithUnicode();
    void jsonIsLeftAsItIs();
};

void PrintableTest::unprintableCharactersAreReplaced_data()
{
    QTest::addColumn<QByteArray>("given");
    QTest::addColumn<QByteArray>("shown");
    const auto row = [](const char *name, const char *given, const char *shown) {
        QTest::newRow(name) << QByteArray(given) << QByteArray(shown);
    };
    row("plain", "PreArm: GPS 1 \"ok\"", "PreArm: GPS 1 \"ok\"");
    row("letters of others", "H\xc3\xb6he \xc2\xb5 \xe2\x82\xac \xf0\x9f\x9a\x81",
        "H\xc3\xb6he \xc2\xb5 \xe2\x82\xac \xf0\x9f\x9a\x81");
    row("title of the window", "\x1b]0;mine\x07", "?]0;mine?");
    row("further line", "hi\nskyseal: armed\r\x7f", "hi?skyseal: armed??");
    row("C1 control",
        "\xc2\x9b"
        "2J",
        "?2J");
    row("C1 control of Latin-1",
        "\x9b"
        "2J",
        "?2J");
    row("right-to-left override", "gpj\xe2\x80\xae.exe", "gpj?.exe");
    row("isolates", "\xe2\x81\xa6x\xe2\x81\xa9", "?x?");
    row("zero width", "sc\xe2\x80\x8bout\xef\xbb\xbf", "sc?out?");
    row("tags", "a\xf3\xa0\x81\x81", "a?");
    row("line separator",
        "a\xe2\x80\xa8"
        "b",
        "a?b");
    row("damaged", "a\xe2\x82", "a?");
    row("overlong escape",
        "\xc0\x9b"
        "x",
        "??x");
}

void PrintableTest::unprintableCharactersAreReplaced()
{
    QFETCH(QByteArray, given);
    QFETCH(QByteArray, shown);
    QCOMPARE(QByteArray::fromStdString(printable(given.toStdString())), shown);
    QCOMPARE(isPrintable(given.toStdString()), given == shown);
    QVERIFY(isPrintable(shown.toStdString()));
}

void PrintableTest::agreesWithUnicode()
{
    // Every control, format and separating character that Qt's tables know.
    for (char32_t value = 0; value <= 0x10ffff; ++value) {
        const QChar::Category category = QChar::category(value);
        const bool expected = category == QChar::Other_Control || category == QChar::Other_Format
            || category == QChar::Separator_Line || category == QChar::Separator_Paragraph;
        if (expected)
            QVERIFY2(isUnprintable(value), qPrintable(QString::number(value, 16)));
        // Of letters and digits, only the fillers of Hangul are unprintable.
        if (QChar::isLetterOrNumber(value) && isUnprintable(value))
            QVERIFY2((value >= 0x115f && value <= 0x1160) || value == 0x3164 || value == 0xffa0,
                     qPrintable(QString::number(value, 16)));
    }
}

void PrintableTest::jsonIsLeftAsItIs()
{
    std::string all;
    for (char32_t value = 0; value <= 0x10ffff; ++value) {
        if (value < 0xd800 || value > 0xdfff)
            all += QString::fromUcs4(&value, 1).toStdString();
    }
    JsonWriter json;
    json.beginObject().field("text", all).endObject();
    QVERIFY(isPrintable(json.text()));
    QCOMPARE(printable(json.text()), json.text());
}

SKYSEAL_TEST(PrintableTest)
#include "printable_test.moc"
