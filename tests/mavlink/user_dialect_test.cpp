// Dialects of a user, read while the program runs: used like the built-in one, and refused with file, line and reason.
#include "core/mavlink/field_value.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/user_dialect.h"
#include "tests/support/test_runner.h"

#include <QtCore/QRegularExpression>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

const QByteArray kOwnMessage = R"(<mavlink>
  <include>common.xml</include>
  <enums>
    <enum name="MAV_TYPE"><entry value="250" name="MAV_TYPE_KITE"/></enum>
    <enum name="KITE_FLAGS" bitmask="true"><entry value="0x1" name="KITE_UP"/><entry value="2**3" name="KITE_FAST"/></enum>
  </enums>
  <messages>
    <message id="60001" name="KITE_STATUS">
      <field type="uint8_t" name="target_system">for whom</field>
      <field type="float" name="pull" units="N">pull</field>
      <field type="uint16_t[3]" name="lines" enum="KITE_FLAGS">lines</field>
      <extensions/>
      <field type="char[10]" name="label">label</field>
    </message>
  </messages>
</mavlink>)";

QByteArray message(const QByteArray &inside, const QByteArray &attributes = "id=\"60001\" name=\"KITE\"")
{
    return "<mavlink><messages>\n<message " + attributes + ">" + inside + "</message></messages></mavlink>";
}

const QByteArray kField = "<field type=\"float\" name=\"a\"/>";

} // namespace

class UserDialectTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ownMessagesWorkLikeBuiltInOnes();
    void theBuiltInOneStaysAsItWas();
    void unknownValuesOfADialect();
    void everyUnknownValueOfTheDefinitionsIsRead();
    void includesAreFollowedOnce();
    void wrongFilesAreRefused_data();
    void wrongFilesAreRefused();
    void anEndlessFileOfEntriesIsRefusedSoon();
    void anythingCutOffIsRefused();

private:
    Result<Dialect, InputError> load(const QByteArray &content, const char *name = "kite.xml")
    {
        QFile file(m_folder.filePath(QLatin1String(name)));
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        file.close();
        return loadUserDialect(file.fileName().toStdString());
    }

    QTemporaryDir m_folder;
};

void UserDialectTest::ownMessagesWorkLikeBuiltInOnes()
{
    const auto dialect = load(kOwnMessage);
    QVERIFY2(dialect.has_value(), dialect ? "" : dialect.error().text().c_str());
    const MessageInfo *info = dialect->find(60001);
    QVERIFY(info && info == dialect->find("KITE_STATUS"));
    QCOMPARE(int(info->minLength), 11);
    QCOMPARE(int(info->maxLength), 21);
    QCOMPARE(int(info->field("pull")->offset), 0);
    QCOMPARE(int(info->field("lines")->offset), 4);
    QCOMPARE(int(info->targetSystemOffset), 10);
    QCOMPARE(std::string(info->field("pull")->units), std::string("N"));
    QCOMPARE(std::string(dialect->enumeration("MAV_TYPE")->nameOf(250)), std::string("MAV_TYPE_KITE"));
    QCOMPARE(std::string(dialect->enumeration("MAV_TYPE")->nameOf(2)), std::string("MAV_TYPE_QUADROTOR"));
    QCOMPARE(std::string(dialect->enumeration("KITE_FLAGS")->nameOf(8)), std::string("KITE_FAST"));
    QVERIFY(dialect->find(0u) && dialect->messages().size() == Dialect::builtin().messages().size() + 1);

    std::array<std::uint8_t, kMaxFrameLength> buffer;
    std::array<std::uint8_t, 21> payload{};
    QVERIFY(setFieldText(payload, *info->field("label"), "abc"));
    FrameWriter writer(1, 1);
    const auto bytes = writer.write(info->id, info->crcExtra, info->minLength, payload, buffer);
    QCOMPARE(readFrame(bytes, Dialect::builtin()).error().fault, FrameFault::UnknownMessage);
    const auto frame = readFrame(bytes, *dialect);
    QVERIFY(frame.has_value());
    QCOMPARE(std::string(fieldText(frame->payload(), *info->field("label"))), std::string("abc"));
}

void UserDialectTest::theBuiltInOneStaysAsItWas()
{
    QVERIFY(load(kOwnMessage));
    QVERIFY(!Dialect::builtin().find(60001));
    QVERIFY(Dialect::builtin().enumeration("MAV_TYPE")->nameOf(250).empty());
    // A dialect outlives the one that it was made from.
    auto first = std::make_unique<Dialect>(*load(kOwnMessage));
    const auto second = first->extended({});
    first.reset();
    QCOMPARE(std::string(second->find(60001)->name), std::string("KITE_STATUS"));
}

void UserDialectTest::unknownValuesOfADialect()
{
    const auto dialect = load(R"(<mavlink>
      <enums><enum name="GAIT"><entry value="7" name="GAIT_NONE"/></enum></enums>
      <messages><message id="60002" name="HORSE">
        <field type="uint16_t" name="hoof" invalid="UINT16_MAX"/>
        <field type="int8_t[2]" name="ears" invalid="[-1]"/>
        <field type="uint8_t" name="gait" enum="GAIT" invalid="GAIT_NONE"/>
        <field type="float" name="speed" invalid="NaN"/>
        <field type="float" name="height" invalid="-1.0"/>
        <field type="char[9]" name="name" invalid="[0]"/>
        <field type="uint8_t" name="odd" invalid="as the rider says"/>
      </message></messages></mavlink>)");
    QVERIFY2(dialect.has_value(), dialect ? "" : dialect.error().text().c_str());
    const auto knows = [&](const char *name, double number) {
        const FieldInfo &field = *dialect->find(60002)->field(name);
        return isKnown(FieldValue::fromNumber(field.type, number), field.unknown);
    };
    QVERIFY(!knows("hoof", 65535) && knows("hoof", 65534));
    QVERIFY(!knows("ears", -1) && knows("ears", 1));
    QVERIFY(!knows("gait", 7) && knows("gait", 0));
    QVERIFY(!knows("speed", std::nan("")) && knows("speed", 0));
    QVERIFY(!knows("height", -1) && !knows("height", std::nan("")) && knows("height", 0));
    QVERIFY(dialect->find(60002)->field("name")->unknown.empty() && dialect->find(60002)->field("odd")->unknown.empty());
}

void UserDialectTest::everyUnknownValueOfTheDefinitionsIsRead()
{
    static const QRegularExpression kField(
        QStringLiteral("<field type=\"(\\w+)[^\"]*\" name=\"(\\w+)\".* invalid=\"([^\"]*)\""));
    static const QRegularExpression kMessage(QStringLiteral("<message .*name=\"(\\w+)\""));
    int read = 0;
    for (const char *name : {"minimal", "standard", "common", "ardupilotmega"}) {
        QFile file(QStringLiteral(SKYSEAL_SOURCE_DIR "/resources/dialects/") + QLatin1String(name) + QStringLiteral(".xml"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const MessageInfo *message = nullptr;
        while (!file.atEnd()) {
            const QString line = QString::fromUtf8(file.readLine());
            if (const auto found = kMessage.match(line); found.hasMatch())
                message = Dialect::builtin().find(found.captured(1).toStdString());
            const auto found = kField.match(line);
            const bool isText = found.captured(1) == QLatin1String("char");
            if (!found.hasMatch() || isText || found.captured(3).contains(QLatin1String("nan"), Qt::CaseInsensitive))
                continue;
            const FieldInfo *field = message ? message->field(found.captured(2).toStdString()) : nullptr;
            QVERIFY2(field && !field->unknown.empty(), qPrintable(line));
            ++read;
        }
    }
    QVERIFY2(read > 200, qPrintable(QString::number(read)));
}

void UserDialectTest::includesAreFollowedOnce()
{
    QVERIFY(load("<mavlink><include>kite.xml</include><include>ring.xml</include></mavlink>", "ring.xml"));
    QVERIFY(load(kOwnMessage));
    const auto ring = load(
        "<mavlink><include>kite.xml</include><include>ring.xml</include><include>./kite.xml</include></mavlink>", "ring.xml");
    QVERIFY(ring && ring->find(60001));
    // The standard's own files may lie beside it.
    const auto whole = loadUserDialect(SKYSEAL_SOURCE_DIR "/resources/dialects/ardupilotmega.xml");
    QVERIFY(whole && whole->messages().size() == Dialect::builtin().messages().size());
}

void UserDialectTest::wrongFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<int>("line");
    QTest::addColumn<QByteArray>("reason");
    const auto row = [](const char *name, const QByteArray &content, int line, const char *reason) {
        QTest::newRow(name) << content << line << QByteArray(reason);
    };
    row("empty", "", 1, "not well-formed");
    row("no XML", "HEARTBEAT", 1, "not well-formed");
    row("cut off", kOwnMessage.left(kOwnMessage.size() - 12), 15, "not well-formed");
    row("another root", "<html/>", 1, "no <mavlink>");
    row("absolute include", "<mavlink>\n<include>/etc/passwd</include></mavlink>", 2, "relative");
    row("missing include", "<mavlink><include>gone.xml</include></mavlink>", 0, "cannot be read");
    row("id taken", message(kField, "id=\"0\" name=\"KITE\""), 2, "already HEARTBEAT");
    row("name taken", message(kField, "id=\"60001\" name=\"HEARTBEAT\""), 2, "known under another id");
    row("another layout", message(kField, "id=\"0\" name=\"HEARTBEAT\""), 2, "another layout");
    row("twice", message(kField) + "", 2, "");
    row("id too large", message(kField, "id=\"16777216\" name=\"KITE\""), 2, "0 to 16777215");
    row("id no number", message(kField, "id=\"12x\" name=\"KITE\""), 2, "0 to 16777215");
    row("no name", message(kField, "id=\"60001\""), 2, "needs a name");
    row("name with spaces", message(kField, "id=\"60001\" name=\"A B\""), 2, "needs a name");
    row("no fields", message(""), 2, "has no fields");
    row("unknown type", message("\n<field type=\"int24_t\" name=\"a\"/>"), 3, "unknown type \"int24_t\"");
    row("array of 0", message("<field type=\"float[0]\" name=\"a\"/>"), 2, "array length");
    row("array of 256", message("<field type=\"char[256]\" name=\"a\"/>"), 2, "array length");
    row("array not closed", message("<field type=\"char[3\" name=\"a\"/>"), 2, "array length");
    row("payload of 256", message("<field type=\"double[32]\" name=\"a\"/>"), 2, "longer than 255");
    row("field twice", message(kField + kField), 2, "stands twice");
    row("entry without name", "<mavlink><enums><enum name=\"E\"><entry value=\"1\"/></enum></enums></mavlink>", 1,
        "needs a name");
    row("entry no number", "<mavlink><enums><enum name=\"E\"><entry value=\"x\" name=\"X\"/></enum></enums></mavlink>", 1,
        "whole number");
    row("entry of 2**64", "<mavlink><enums><enum name=\"E\"><entry value=\"2**64\" name=\"X\"/></enum></enums></mavlink>", 1,
        "whole number");
    row("entry of powers without end",
        "<mavlink><enums><enum name=\"E\"><entry value=\"" + QByteArray("2**").repeated(1'000'000)
            + "1\" name=\"X\"/></enum></enums></mavlink>",
        1, "whole number");
    row("value with two names",
        "<mavlink><enums><enum name=\"E\"><entry value=\"1\" name=\"X\"/>\n<entry value=\"1\" "
        "name=\"Y\"/></enum></enums></mavlink>",
        2, "is X already");
}

void UserDialectTest::wrongFilesAreRefused()
{
    QFETCH(QByteArray, content);
    QFETCH(int, line);
    QFETCH(QByteArray, reason);
    const auto dialect = load(content, "wrong.xml");
    if (reason.isEmpty()) {
        QVERIFY(dialect.has_value());
        return;
    }
    QVERIFY(!dialect.has_value());
    const InputError &error = dialect.error();
    QVERIFY2(QByteArray::fromStdString(error.message.text()).contains(reason), error.text().c_str());
    QCOMPARE(static_cast<int>(error.line), line);
    QVERIFY2(QByteArray::fromStdString(error.source).endsWith(".xml"), error.text().c_str());
}

void UserDialectTest::anEndlessFileOfEntriesIsRefusedSoon()
{
    QByteArray content = "<mavlink><enums><enum name=\"E\">";
    for (int i = 0; i < 100'000; ++i)
        content += "<entry name=\"X\"/>\n";
    QVERIFY(!load(content + "</enum></enums></mavlink>"));
    content = "<mavlink><messages>";
    for (int i = 0; i < 20'000; ++i)
        content += "<message id=\"" + QByteArray::number(60'000 + i) + "\" name=\"M" + QByteArray::number(i) + "\">" + kField
            + "</message>\n";
    QVERIFY(!load(content + "</messages></mavlink>"));
    content = "<mavlink>";
    for (int i = 0; i < 500'000; ++i)
        content += "<deep>";
    QVERIFY(!load(content));
}

void UserDialectTest::anythingCutOffIsRefused()
{
    for (qsizetype length = 0; length < kOwnMessage.size(); length += 7)
        QVERIFY(!load(kOwnMessage.left(length)));
}

SKYSEAL_TEST_APPLESS(UserDialectTest)
#include "user_dialect_test.moc"
