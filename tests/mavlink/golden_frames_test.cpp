// Frames packed by the reference implementation, and the facts about all messages: read where SKYSEAL_MAVLINK_FACTS names
// their folder, or beside the checkout.
#include "core/base/hex.h"
#include "core/mavlink/frame.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::mavlink;

class GoldenFramesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void layoutsAreTheReferences();
    void everyFrameIsValid();

private:
    QByteArray read(const char *name) const;
    QString m_folder;
};

void GoldenFramesTest::initTestCase()
{
    m_folder = qEnvironmentVariable("SKYSEAL_MAVLINK_FACTS", QStringLiteral(SKYSEAL_SOURCE_DIR "/../shared/mavlink"));
    if (!QFile::exists(m_folder + QStringLiteral("/golden_frames.jsonl")))
        QSKIP("SKYSEAL_MAVLINK_FACTS names no folder with the reference frames: skipped");
}

QByteArray GoldenFramesTest::read(const char *name) const
{
    QFile file(m_folder + QLatin1Char('/') + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void GoldenFramesTest::layoutsAreTheReferences()
{
    const QJsonArray messages = QJsonDocument::fromJson(read("ardupilotmega.json"))[QLatin1String("messages")].toArray();
    QCOMPARE(messages.size(), 325);
    QCOMPARE(Dialect::builtin().messages().size(), std::size_t(325));
    for (const auto &value : messages) {
        const QJsonObject fact = value.toObject();
        const MessageInfo *info = Dialect::builtin().find(static_cast<std::uint32_t>(fact[QLatin1String("id")].toInt()));
        QVERIFY(info);
        QCOMPARE(info->crcExtra, fact[QLatin1String("crc_extra")].toInt());
        QCOMPARE(info->minLength, fact[QLatin1String("min_len")].toInt());
        QCOMPARE(info->maxLength, fact[QLatin1String("max_len")].toInt());
        QCOMPARE(info->targetSystemOffset, fact[QLatin1String("target_system_ofs")].toInt(-1));
        QCOMPARE(info->targetComponentOffset, fact[QLatin1String("target_component_ofs")].toInt(-1));
        const QJsonArray fields = fact[QLatin1String("fields")].toArray();
        QCOMPARE(info->fields.size(), static_cast<std::size_t>(fields.size()));
        for (qsizetype i = 0; i < fields.size(); ++i)
            QCOMPARE(info->fields[static_cast<std::size_t>(i)].offset, fields[i][QLatin1String("offset")].toInt());
    }
}

void GoldenFramesTest::everyFrameIsValid()
{
    int count = 0;
    for (const QByteArray &line : read("golden_frames.jsonl").split('\n')) {
        if (line.isEmpty())
            continue;
        const QJsonObject golden = QJsonDocument::fromJson(line).object();
        const Bytes bytes = *fromHex(golden[QLatin1String("hex")].toString().toStdString());
        const auto frame = readFrame(bytes, Dialect::builtin());
        QVERIFY2(frame.has_value(), line.constData());
        QCOMPARE(frame->messageId(), static_cast<std::uint32_t>(golden[QLatin1String("id")].toInt()));
        QCOMPARE(frame->version(), golden[QLatin1String("version")].toInt());
        QCOMPARE(frame->isSigned(), !golden[QLatin1String("signed")].isNull());
        ++count;
    }
    QCOMPARE(count, 671);
}

QTEST_APPLESS_MAIN(GoldenFramesTest)
#include "golden_frames_test.moc"
