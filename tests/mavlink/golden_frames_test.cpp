// Frames packed by the reference implementation and the layout of all its messages, from tests/data/mavlink; the larger set
// and the full facts are taken where SKYSEAL_MAVLINK_FACTS names their folder, or where they lie beside the checkout.
#include "core/base/secret_bytes.h"
#include "core/base/hex.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/signing.h"
#include "core/mavlink/message_json.h"
#include "core/mavlink/payload_builder.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

#include <algorithm>

#include <cmath>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString dataPath(const char *name)
{
    return QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/data/mavlink/") + QLatin1String(name);
}

/// The text of a JSON number or string as parseFieldValue wants it; `fallback` are the exact bits where JSON has none for
/// them.
std::optional<FieldValue> fromJson(FieldType type, const QJsonValue &value, const QJsonValue &nanBits)
{
    if (nanBits.isString())
        return FieldValue::fromBits(type, nanBits.toString().toULongLong(nullptr, 16));
    if (value.isString())
        return parseFieldValue(type, value.toString().toStdString());
    return FieldValue::fromNumber(type, value.toDouble());
}

/// Surrogates U+DC80…U+DCFF are single bytes, all else is UTF-8.
std::string bytesOf(const QString &text)
{
    std::string out;
    for (const QChar c : text) {
        if (c.unicode() >= 0xdc80 && c.unicode() <= 0xdcff)
            out.push_back(static_cast<char>(c.unicode() & 0xff));
        else
            out += QString(c).toStdString();
    }
    return out;
}

/// Builds the frame again from its decoded JSON, header and all.
Bytes frameFromJson(const QJsonObject &event, const Frame &original)
{
    const MessageInfo *info = Dialect::builtin().find(static_cast<std::uint32_t>(event[QLatin1String("id")].toInt()));
    PayloadBuilder builder(*info);
    const QJsonObject fields = event[QLatin1String("fields")].toObject();
    const QJsonObject nans = event[QLatin1String("nan_bits")].toObject();
    for (const FieldInfo &field : info->fields) {
        const QLatin1String name(field.name.data(), static_cast<qsizetype>(field.name.size()));
        const QJsonValue value = fields[name];
        if (value.isUndefined())
            continue;
        if (field.type == FieldType::Char) {
            if (!builder.setText(field, bytesOf(value.toString())))
                return {};
            continue;
        }
        for (std::size_t i = 0; i < field.elements(); ++i) {
            const QJsonValue bits = nans[name].toObject()[QString::number(i)];
            const auto element = fromJson(field.type, field.arrayLength ? value.toArray()[static_cast<qsizetype>(i)] : value,
                                          bits);
            if (!element || !builder.set(field, i, *element))
                return {};
        }
    }
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const auto frame = writeFrame(buffer, event[QLatin1String("version")].toInt(), original.sequence(), original.systemId(),
                                  original.componentId(), info->id, info->crcExtra, info->minLength, builder.payload(),
                                  original.incompatFlags());
    if (original.isSigned())
        std::copy(original.signatureBlock().begin(), original.signatureBlock().end(), frame.last(kSignatureLength).begin());
    return {frame.begin(), frame.end()};
}

QJsonObject decoded(const Frame &frame)
{
    JsonWriter json;
    writeMessageJson(json, frame);
    // QJsonDocument would read -0.0 as the integer 0.
    static const QRegularExpression kMinusZero(QStringLiteral("(?<=[:,\\[])-0\\.0(?=[,\\]}])"));
    QString text = QString::fromStdString(json.text());
    text.replace(kMinusZero, QStringLiteral("\"-0.0\""));
    return QJsonDocument::fromJson(text.toUtf8()).object();
}

QJsonArray listOf(const QJsonValue &value)
{
    return value.isArray() ? value.toArray() : QJsonArray{value};
}

} // namespace

class GoldenFramesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void layoutsAreTheReferences();
    void factsAreTheReferences();
    void everyFieldOfEveryFrame();
    void signaturesMatch();
    void signedCopiesAreTheReferences();
    void encodedAgainTheBytesAreTheSame();

private:
    std::vector<QJsonObject> m_golden;
};

void GoldenFramesTest::initTestCase()
{
    QByteArray lines = contentOf(test::mavlinkFactsFolder() + QStringLiteral("/golden_frames.jsonl"));
    if (lines.isEmpty())
        lines = contentOf(dataPath("golden_frames.jsonl"));
    for (const QByteArray &line : lines.split('\n')) {
        if (!line.isEmpty())
            m_golden.push_back(QJsonDocument::fromJson(line).object());
    }
    QVERIFY(m_golden.size() > 100);
    qInfo("%zu reference frames", m_golden.size());
}

void GoldenFramesTest::layoutsAreTheReferences()
{
    std::size_t count = 0;
    for (const QByteArray &line : contentOf(dataPath("message_facts.txt")).split('\n')) {
        if (line.isEmpty() || line.startsWith('#'))
            continue;
        const QList<QByteArray> words = line.split(' ');
        const MessageInfo *info = Dialect::builtin().find(words[0].toUInt());
        QVERIFY2(info, line.constData());
        QCOMPARE(QByteArray(info->name.data(), static_cast<qsizetype>(info->name.size())), words[1]);
        QCOMPARE(int(info->crcExtra), words[2].toInt());
        QCOMPARE(int(info->minLength), words[3].toInt());
        QCOMPARE(int(info->maxLength), words[4].toInt());
        QCOMPARE(int(info->targetSystemOffset), words[5].toInt());
        QCOMPARE(int(info->targetComponentOffset), words[6].toInt());
        QCOMPARE(static_cast<qsizetype>(info->fields.size()), words.size() - 7);
        for (std::size_t i = 0; i < info->fields.size(); ++i) {
            const QByteArray field = QByteArray::fromStdString(std::string(info->fields[i].name)) + '@';
            QCOMPARE(field + QByteArray::number(info->fields[i].offset), words[static_cast<qsizetype>(i) + 7]);
        }
        QCOMPARE(Dialect::builtin().find(info->name), info);
        ++count;
    }
    QCOMPARE(count, std::size_t(325));
    QCOMPARE(Dialect::builtin().messages().size(), count);
}

void GoldenFramesTest::factsAreTheReferences()
{
    SKYSEAL_REQUIRES("mavlink_facts");
    const QJsonObject facts =
        QJsonDocument::fromJson(contentOf(test::mavlinkFactsFolder() + QStringLiteral("/ardupilotmega.json"))).object();
    QVERIFY(!facts.isEmpty());
    const auto text = [](std::string_view view) { return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size())); };
    for (const auto &value : facts[QLatin1String("messages")].toArray()) {
        const MessageInfo *info = Dialect::builtin().find(static_cast<std::uint32_t>(value[QLatin1String("id")].toInt()));
        QVERIFY(info);
        const QJsonArray fields = value[QLatin1String("fields")].toArray();
        for (std::size_t i = 0; i < info->fields.size(); ++i) {
            const FieldInfo &field = info->fields[i];
            const QJsonValue fact = fields[static_cast<qsizetype>(i)];
            QCOMPARE(text(field.name), fact[QLatin1String("name")].toString());
            QCOMPARE(int(field.arrayLength), fact[QLatin1String("array")].toInt());
            QCOMPARE(field.extension, fact[QLatin1String("extension")].toBool());
            QCOMPARE(text(field.enumName), fact[QLatin1String("enum")].toString());
            QCOMPARE(text(field.units), fact[QLatin1String("units")].toString());
            QCOMPARE(text(field.printFormat), fact[QLatin1String("print")].toString());
            QCOMPARE(text(nameOf(field.type)), fact[QLatin1String("type")].toString());
        }
    }
    const QJsonArray enums = facts[QLatin1String("enums")].toArray();
    QCOMPARE(Dialect::builtin().enums().size(), static_cast<std::size_t>(enums.size()));
    for (const auto &value : enums) {
        const EnumInfo *info = Dialect::builtin().enumeration(value[QLatin1String("name")].toString().toStdString());
        QVERIFY(info);
        QCOMPARE(info->bitmask, value[QLatin1String("bitmask")].toBool());
        const QJsonArray entries = value[QLatin1String("entries")].toArray();
        QCOMPARE(info->entries.size(), static_cast<std::size_t>(entries.size()));
        for (const auto &entry : entries) {
            const auto number = static_cast<std::uint64_t>(entry[QLatin1String("value")].toInteger());
            QCOMPARE(text(info->nameOf(number)), entry[QLatin1String("name")].toString());
        }
    }
}

void GoldenFramesTest::everyFieldOfEveryFrame()
{
    std::size_t compared = 0;
    for (const QJsonObject &golden : m_golden) {
        const QByteArray name = golden[QLatin1String("msg")].toString().toUtf8();
        const Bytes bytes = *fromHex(golden[QLatin1String("hex")].toString().toStdString());
        const auto frame = readFrame(bytes, Dialect::builtin());
        QVERIFY2(frame.has_value(), name.constData());
        const QJsonObject event = decoded(*frame);
        QCOMPARE(event[QLatin1String("event")].toString(), QStringLiteral("message"));
        QCOMPARE(event[QLatin1String("name")], golden[QLatin1String("msg")]);
        for (const char *key : {"id", "version", "sysid", "compid", "seq"})
            QCOMPARE(event[QLatin1String(key)], golden[QLatin1String(key)]);
        QCOMPARE(event[QLatin1String("signed")].toBool(), !golden[QLatin1String("signed")].isNull());

        const QJsonObject fields = golden[QLatin1String("fields")].toObject();
        const QJsonObject floats = golden[QLatin1String("float_hex")].toObject();
        QCOMPARE(event[QLatin1String("fields")].toObject().keys(), fields.keys());
        for (const FieldInfo &field : frame->info().fields) {
            const QLatin1String key(field.name.data(), static_cast<qsizetype>(field.name.size()));
            if (!floats.contains(key)) {
                QVERIFY2(event[QLatin1String("fields")][key] == fields[key], (name + ' ' + key.data()).constData());
                compared += fields.contains(key);
                continue;
            }
            const QJsonArray patterns = listOf(floats[key]), numbers = listOf(event[QLatin1String("fields")][key]);
            QCOMPARE(static_cast<std::size_t>(patterns.size()), field.elements());
            for (qsizetype i = 0; i < patterns.size(); ++i) {
                const FieldValue value = fieldValue(frame->payload(), field, static_cast<std::size_t>(i));
                QCOMPARE(static_cast<qulonglong>(value.bits()), patterns[i].toString().toULongLong(nullptr, 16));
                const auto back = fromJson(field.type, numbers[i], QJsonValue());
                QVERIFY(back && (*back == value || (std::isnan(value.asDouble()) && std::isnan(back->asDouble()))));
                ++compared;
            }
        }
    }
    qInfo("%zu values compared", compared);
}

void GoldenFramesTest::signaturesMatch()
{
    int count = 0;
    for (const QJsonObject &golden : m_golden) {
        const QJsonObject facts = golden[QLatin1String("signed")].toObject();
        if (facts.isEmpty())
            continue;
        const Bytes bytes = *fromHex(golden[QLatin1String("hex")].toString().toStdString());
        const Bytes keyBytes = *fromHex(facts[QLatin1String("key")].toString().toStdString());
        const Key32 key{std::span<const std::uint8_t, 32>(keyBytes.data(), 32)};
        const auto frame = readFrame(bytes, Dialect::builtin());
        QVERIFY(frame && frame->isSigned() && signatureMatches(*frame, key));
        QCOMPARE(int(signatureLinkId(*frame)), facts[QLatin1String("link_id")].toInt());
        QCOMPARE(static_cast<qint64>(signatureTime(*frame)), facts[QLatin1String("timestamp")].toInteger());
        Bytes again = bytes;
        std::fill(again.end() - 13, again.end(), std::uint8_t(0));
        QVERIFY(signFrame(again, key, signatureLinkId(*frame), signatureTime(*frame)));
        QCOMPARE(toHex(again), toHex(bytes));
        ++count;
    }
    QVERIFY(count > 5);
}

/// A frame that gets its signature on the way, or another one, is the frame that its sender would have signed.
void GoldenFramesTest::signedCopiesAreTheReferences()
{
    Key32 key, other;
    for (std::size_t i = 0; i < key.size(); ++i)
        key.mutableView()[i] = static_cast<std::uint8_t>(7 * i + 3);
    int count = 0;
    for (const QJsonObject &golden : m_golden) {
        const Bytes bytes = *fromHex(golden[QLatin1String("hex")].toString().toStdString());
        const auto frame = readFrame(bytes, Dialect::builtin());
        QVERIFY(frame);
        FrameSigner signer(key.clone(), 1, 5);
        std::array<std::uint8_t, kMaxFrameLength> copy;
        if (frame->version() == 1) {
            QVERIFY(signer.signCopy(bytes, copy).empty());
            continue;
        }
        if (!frame->isSigned()) {
            const auto out = readFrame(signer.signCopy(bytes, copy), Dialect::builtin()); // its checksum is right
            QVERIFY(out && signatureMatches(*out, key) && std::ranges::equal(out->payload(), frame->payload()));
            continue;
        }
        ++count;
        const MessageInfo &info = frame->info();
        FrameSigner again(key.clone(), signatureLinkId(*frame), signatureTime(*frame) - 1);
        FrameSigner andAgain(key.clone(), signatureLinkId(*frame), signatureTime(*frame) - 1);
        std::array<std::uint8_t, kMaxFrameLength> buffer;
        const ByteView plain = writeFrame(buffer, 2, frame->sequence(), frame->systemId(), frame->componentId(), info.id,
                                          info.crcExtra, info.minLength, frame->payload());
        if (plain.size() + kSignatureLength == bytes.size()) // a payload of zeros alone is written shorter
            QVERIFY(std::ranges::equal(again.signCopy(plain, copy), bytes));
        Bytes others = bytes;
        QVERIFY(signFrame(others, other, 77, 9));
        QVERIFY(std::ranges::equal(andAgain.signCopy(others, copy), bytes));
    }
    QVERIFY(count > 10);
}

void GoldenFramesTest::encodedAgainTheBytesAreTheSame()
{
    for (const QJsonObject &golden : m_golden) {
        const Bytes bytes = *fromHex(golden[QLatin1String("hex")].toString().toStdString());
        const auto frame = readFrame(bytes, Dialect::builtin());
        QVERIFY(frame.has_value());
        QCOMPARE(toHex(frameFromJson(decoded(*frame), *frame)), toHex(bytes));
    }
}

SKYSEAL_TEST_APPLESS(GoldenFramesTest)
#include "golden_frames_test.moc"
