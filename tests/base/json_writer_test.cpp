// JSON as other programs must be able to read it: QJsonDocument judges the syntax, exact texts judge the numbers.
#include "core/base/json_writer.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtTest/QTest>

#include <limits>

using namespace skyseal;

class JsonWriterTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsOrderAndNests();
    void numbersAreExact();
    void textIsEscaped();
    void bytesThatAreNoTextKeepTheirIdentity();
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

void JsonWriterTest::bytesThatAreNoTextKeepTheirIdentity()
{
    // Alone, overlong, a surrogate, cut off, beyond U+10FFFF; then valid sequences of 2, 3 and 4 bytes.
    JsonWriter json;
    json.value(std::string_view("\x80 \xc0\xaf \xed\xa0\x80 \xe2\x82 \xf4\x90\x80\x80 \xc3\xa9\xe2\x82\xac\xf0\x9f\x9a\x81"));
    QCOMPARE(json.text(), std::string("\"\\udc80 \\udcc0\\udcaf \\udced\\udca0\\udc80 \\udce2\\udc82 "
                                      "\\udcf4\\udc90\\udc80\\udc80 \xc3\xa9\xe2\x82\xac\xf0\x9f\x9a\x81\""));
}

QTEST_APPLESS_MAIN(JsonWriterTest)
#include "json_writer_test.moc"
