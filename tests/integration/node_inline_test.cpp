// A reader without inline framing on a stream of sealed and plain frames: the npm package node-mavlink finds every plain frame,
// and reports the sealed ones with incompatibility flags that require dropping them, and with invalid signatures.
#include "core/base/secret_bytes.h"
#include "core/channel/inline_frame.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/common/dialect_traits.h"
#include "core/mavlink/frame_writer.h"
#include "tests/support/eventually.h"
#include "tests/support/node_mavlink.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtTest/QTest>

#include <random>

using namespace skyseal;
using namespace skyseal::channel;

class NodeInlineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void findsEveryPlainFrame_data();
    void findsEveryPlainFrame();

private:
    QString m_node;
};

void NodeInlineTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
    SKYSEAL_REQUIRES("node_mavlink");
    m_node = test::findNodeMavlink();
}

void NodeInlineTest::findsEveryPlainFrame_data()
{
    QTest::addColumn<int>("suite");
    for (const crypto::SuiteInfo &info : crypto::suites()) {
        if (crypto::mayBeInline(info.id))
            QTest::newRow(info.name.data()) << static_cast<int>(info.id);
    }
}

void NodeInlineTest::findsEveryPlainFrame()
{
    QFETCH(int, suite);
    constexpr int kEach = 1000;
    const engine::DialectTraits facts(mavlink::Dialect::builtin());
    const auto cipher = crypto::makeInlineCipher(static_cast<crypto::SuiteId>(suite), Key32());
    const char *names[] = {"ATTITUDE", "COMMAND_LONG", "GPS_RAW_INT", "STATUSTEXT", "HEARTBEAT", "SYS_STATUS"};
    std::mt19937 random(31);
    QByteArray stream;
    const auto append = [&stream](ByteView bytes) {
        stream.append(reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    };
    for (int i = 0; i < kEach; ++i) {
        const mavlink::MessageInfo &info = *mavlink::Dialect::builtin().find(names[random() % std::size(names)]);
        Bytes payload(info.maxLength);
        for (auto &byte : payload)
            byte = static_cast<std::uint8_t>(random());
        Bytes buffer(mavlink::kMaxFrameLength), sealed(kMaxInlineFrame);
        const auto frame = mavlink::writeFrame(buffer, 2, static_cast<std::uint8_t>(i), 1, 1, info.id, info.crcExtra,
                                               info.minLength, payload);
        const auto sealable = SealableFrame::read(frame, facts);
        QVERIFY(sealable);
        const InlinePlace place{0, static_cast<std::uint32_t>(i), Direction::FromResponder, Carrier::Datagram};
        QVERIFY(sealable->seal(place, *cipher, sealed));
        append(ByteView(sealed).first(sealable->sealedSize()));
        append(frame);
    }

    QProcess node;
    node.start(m_node,
               {QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/integration/node_inline_reader.cjs"), QString(64, QLatin1Char('5'))});
    node.write(stream);
    node.closeWriteChannel();
    QVERIFY(node.waitForFinished(test::kDeadlineMs));
    const QJsonObject seen = QJsonDocument::fromJson(node.readAllStandardOutput()).object();
    qInfo("%s", QJsonDocument(seen).toJson(QJsonDocument::Compact).constData());
    QCOMPARE(seen[QLatin1String("plain")].toInt(), kEach); // none lost behind a sealed frame, none read from one
    QCOMPARE(seen[QLatin1String("unknownFlags")].toInt(), kEach);
    QCOMPARE(seen[QLatin1String("unknownFlagsSigned")].toInt(), 0);
    QCOMPARE(seen[QLatin1String("signed")].toInt() + seen[QLatin1String("other")].toInt(), 0);
}

SKYSEAL_TEST(NodeInlineTest)
#include "node_inline_test.moc"
