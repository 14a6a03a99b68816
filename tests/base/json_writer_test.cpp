// JsonWriter: QJsonDocument checks the syntax, expected texts check the numbers.
#include "core/base/json_writer.h"
#include "core/base/utf8.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QStringConverter>
#include <QtTest/QTest>
#include <rapidcheck.h>

#include <limits>

using namespace skyseal;

class JsonWriterTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsOrderAndNests();
    void numbersAreExact();
    void textIsEscaped();
    void bytesThatAreNoTextAreReplaced();
    void anyBytesGiveUtf8();
};

void JsonWriterTest::keepsOrderAndNests()
{
    JsonWriter json;
    json.beginObject().field("event", "stats").key("rx").beginObject().field("good", 3u).field("late", 0u).endObject();
    json.key("list").beginArray().value(1).value(true).null().beginObject().endObject().endArray().endObject();
    QCOMPARE(json.text(), std::string(R"({"event":"stats","rx":{"good":3,"late":0},"list":[1,true,null,{}]})"));
}

void JsonWriterTest::numbersAreExact()
{
    JsonWriter json;
    json.beginArray().value(-0.0).value(0.1).value(0.1f).value(std::numeric_limits<double>::quiet_NaN());
    json.value(-std::numeric_limits<float>::infinity()).value(std::numeric_limits<std::uint64_t>::max()).endArray();
    QCOMPARE(json.text(), std::string(R"([-0.0,0.1,0.1,"NaN","-Infinity",18446744073709551615])"));
}

void JsonWriterTest::textIsEscaped()
{
    const std::string hard = std::string("a\"b\\c\n\t") + '\x01' + "\xc3\xa9";
    JsonWriter json;
    json.beginObject().field("text", std::string_view(hard)).endObject();
    const QJsonDocument read = QJsonDocument::fromJson(QByteArray::fromStdString(json.text()));
    QCOMPARE(read.object()[QLatin1String("text")].toString().toStdString(), hard);
}

void JsonWriterTest::bytesThatAreNoTextAreReplaced()
{
    // A lone byte, overlong, a surrogate, truncated, beyond U+10FFFF; then valid sequences of 2, 3 and 4 bytes.
    JsonWriter json;
    json.value(std::string_view("\x80 \xc0\xaf \xed\xa0\x80 \xe2\x82 \xf4\x90\x80\x80 \xc3\xa9\xe2\x82\xac\xf0\x9f\x9a\x81"));
    const QString read = QJsonDocument::fromJson('[' + QByteArray::fromStdString(json.text()) + ']')[0].toString();
    const QChar no(0xfffd);
    QCOMPARE(read,
             QString(no) + QLatin1Char(' ') + no + no + QLatin1Char(' ') + no + no + no + QLatin1Char(' ') + no
                 + QLatin1Char(' ') + no + no + no + no + QString::fromUtf8(" é€🚁"));
}

void JsonWriterTest::anyBytesGiveUtf8()
{
    QVERIFY(rc::check("strict UTF-8, no surrogate, and text that is text stays as it is", [](const std::string &bytes) {
        JsonWriter json;
        json.beginArray().value(bytes).endArray();
        // Compared with Qt's decoder, in both directions.
        QStringDecoder strict(QStringDecoder::Utf8, QStringConverter::Flag::Stateless);
        const QString line = strict(QByteArray::fromStdString(json.text()));
        RC_ASSERT(!strict.hasError());
        RC_ASSERT(!line.contains(QLatin1String("\\ud")));
        QJsonParseError error;
        const QJsonDocument read = QJsonDocument::fromJson(QByteArray::fromStdString(json.text()), &error);
        RC_ASSERT(error.error == QJsonParseError::NoError);
        QStringDecoder own(QStringDecoder::Utf8, QStringConverter::Flag::Stateless);
        const QString text = own(QByteArray::fromStdString(bytes));
        RC_ASSERT(isUtf8(bytes) == !own.hasError());
        if (!own.hasError())
            RC_ASSERT(read[0].toString() == text);
        else
            RC_ASSERT(read[0].toString().contains(QChar(0xfffd)));
    }));
}

SKYSEAL_TEST_APPLESS(JsonWriterTest)
#include "json_writer_test.moc"
