// The rules of signing: times that only rise, streams apart from each other, nothing learned from a wrong signature. That
// the signatures themselves are the reference's is shown by golden_frames_test.
#include "core/base/secret_bytes.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/signing.h"
#include "core/mavlink/signing_key.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::mavlink;

namespace {

constexpr SigningTime kNow = 100 * kSigningMinute;

Key32 keyOf(std::uint8_t first)
{
    Key32 key;
    key.mutableView()[0] = first;
    return key;
}

/// A signed frame that owns its bytes.
struct SignedFrame
{
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    std::size_t length = 0;

    Frame frame() const { return *readFrame(ByteView(buffer).first(length), Dialect::builtin()); }
};

SignedFrame signedAt(SigningTime time, std::uint8_t linkId = 1, std::uint8_t system = 1, std::uint8_t component = 1,
                     const Key32 &key = keyOf(1))
{
    SignedFrame out;
    std::array<std::uint8_t, Heartbeat::kMaxLength> payload{1, 2, 3};
    const auto frame = writeFrame(out.buffer, 2, 0, system, component, Heartbeat::kId, Heartbeat::kCrcExtra,
                                  Heartbeat::kMinLength, payload, kFlagSigned);
    out.length = frame.size();
    signFrame(frame, key, linkId, time);
    return out;
}

} // namespace

class SigningTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void timeCountsFrom2015();
    void signerNeverRepeatsATime();
    void everyBitIsSigned();
    void replayIsRefusedPerStream();
    void aNewStreamMayNotBeOld();
    void wrongSignaturesTeachNothing();
    void streamsAreBounded();
    void unsignedFramesAreNamed();
    void version1IsNeverSigned();
    void unknownMessagesAreSignedAndVerified();
    void keyFiles();
};

void SigningTest::timeCountsFrom2015()
{
    QCOMPARE(signingTime(WallTime(std::chrono::seconds(1'420'070'400))), SigningTime(0));
    QCOMPARE(signingTime(WallTime(std::chrono::seconds(1'420'070'401))), SigningTime(100'000));
    QCOMPARE(signingTime(WallTime(std::chrono::seconds(5))), SigningTime(0));
}

void SigningTest::signerNeverRepeatsATime()
{
    FrameSigner signer(keyOf(1), 1, 50);
    FrameWriter writer(1, 1);
    writer.setSigner(&signer);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    SigningTime last = 50;
    for (const SigningTime now : {40u, 40u, 60u, 60u, 10u}) {
        signer.advanceTo(now);
        const auto frame = readFrame(writer.write(Heartbeat(), buffer), Dialect::builtin());
        QVERIFY(frame && frame->isSigned() && signatureMatches(*frame, keyOf(1)));
        QVERIFY(signatureTime(*frame) > last);
        last = signatureTime(*frame);
        QCOMPARE(signer.lastTime(), last);
    }
    signer.advanceTo(~SigningTime(0));
    QVERIFY(writer.write(Heartbeat(), buffer).empty()); // 48 bits are used up: better silent than repeating
}

void SigningTest::everyBitIsSigned()
{
    const SignedFrame good = signedAt(kNow);
    QVERIFY(signatureMatches(good.frame(), keyOf(1)));
    QVERIFY(!signatureMatches(good.frame(), keyOf(2)));
    for (std::size_t bit = 0; bit < good.length * 8; ++bit) {
        SignedFrame bad = good;
        bad.buffer[bit / 8] = static_cast<std::uint8_t>(bad.buffer[bit / 8] ^ (1 << bit % 8));
        const auto frame = readFrame(ByteView(bad.buffer).first(bad.length), Dialect::builtin());
        QVERIFY2(!frame || !signatureMatches(*frame, keyOf(1)), qPrintable(QString::number(bit)));
    }
}

void SigningTest::replayIsRefusedPerStream()
{
    SignatureVerifier verifier(keyOf(1), kNow);
    QCOMPARE(verifier.check(signedAt(kNow).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.check(signedAt(kNow).frame()), SignatureVerdict::Replayed);
    QCOMPARE(verifier.check(signedAt(kNow - 1).frame()), SignatureVerdict::Replayed);
    QCOMPARE(verifier.check(signedAt(kNow, 2).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.check(signedAt(kNow, 1, 2).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.check(signedAt(kNow, 1, 1, 2).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.check(signedAt(kNow + 1).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.count(SignatureVerdict::Good), std::uint64_t(5));
    QCOMPARE(verifier.count(SignatureVerdict::Replayed), std::uint64_t(2));
}

void SigningTest::aNewStreamMayNotBeOld()
{
    SignatureVerifier verifier(keyOf(1), kNow);
    QCOMPARE(verifier.check(signedAt(kNow - kSigningMinute - 1).frame()), SignatureVerdict::TooOld);
    QCOMPARE(verifier.check(signedAt(kNow - kSigningMinute).frame()), SignatureVerdict::Good);
    // A known stream may lag; what it has said moves on the time that new ones are measured by.
    QCOMPARE(verifier.check(signedAt(kNow + kSigningMinute, 2).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.newestTime(), kNow + kSigningMinute);
    QCOMPARE(verifier.check(signedAt(kNow - 5).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.check(signedAt(kNow - 5, 3).frame()), SignatureVerdict::TooOld);
}

void SigningTest::wrongSignaturesTeachNothing()
{
    SignatureVerifier verifier(keyOf(1), kNow);
    QCOMPARE(verifier.check(signedAt(kNow + 10 * kSigningMinute, 1, 1, 1, keyOf(2)).frame()), SignatureVerdict::Wrong);
    QCOMPARE(verifier.newestTime(), kNow);
    QCOMPARE(verifier.check(signedAt(kNow).frame()), SignatureVerdict::Good);
}

void SigningTest::streamsAreBounded()
{
    SignatureVerifier verifier(keyOf(1), kNow);
    for (std::size_t i = 0; i < SignatureVerifier::kMaxStreams; ++i)
        QCOMPARE(verifier.check(signedAt(kNow, static_cast<std::uint8_t>(i)).frame()), SignatureVerdict::Good);
    QCOMPARE(verifier.check(signedAt(kNow, 200).frame()), SignatureVerdict::TooManyStreams);
    QCOMPARE(verifier.check(signedAt(kNow + 1, 0).frame()), SignatureVerdict::Good);
}

void SigningTest::unsignedFramesAreNamed()
{
    FrameWriter writer(1, 1);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const auto frame = readFrame(writer.write(Heartbeat(), buffer), Dialect::builtin());
    QVERIFY(!signatureMatches(*frame, keyOf(1)));
    QVERIFY(frame->signatureBlock().empty());
    QCOMPARE(SignatureVerifier(keyOf(1), kNow).check(*frame), SignatureVerdict::Unsigned);
}

void SigningTest::version1IsNeverSigned()
{
    FrameSigner signer(keyOf(1), 1);
    FrameWriter writer(1, 1, 1);
    writer.setSigner(&signer);
    std::array<std::uint8_t, kMaxFrameLength> buffer;
    const auto frame = readFrame(writer.write(Heartbeat(), buffer), Dialect::builtin());
    QVERIFY(frame && frame->version() == 1 && !frame->isSigned());
    QVERIFY(!signFrame(writer.write(Heartbeat(), buffer), keyOf(1), 1, 1));
}

/// An agent forwards messages that its dialect does not know.
void SigningTest::unknownMessagesAreSignedAndVerified()
{
    constexpr std::uint32_t kUnknown = 0xabcdef;
    constexpr std::uint8_t kItsCrcExtra = 99;
    QVERIFY(!Dialect::builtin().find(kUnknown));
    const std::array<std::uint8_t, 5> payload{1, 2, 3, 4, 5};
    std::array<std::uint8_t, kMaxFrameLength> plain, whole, copy;
    const ByteView frame = writeFrame(plain, 2, 7, 1, 1, kUnknown, kItsCrcExtra, 5, payload);
    FrameSigner signer(keyOf(1), 3, kNow);
    const ByteView out = signer.signCopy(frame, copy);
    // As its sender would have written it, who knows CRC_EXTRA.
    const MutableByteView expected = writeFrame(whole, 2, 7, 1, 1, kUnknown, kItsCrcExtra, 5, payload, kFlagSigned);
    QVERIFY(signFrame(expected, keyOf(1), 3, kNow + 1));
    QVERIFY(std::ranges::equal(out, expected));
    SignatureVerifier verifier(keyOf(1), kNow);
    QCOMPARE(verifier.check(out), SignatureVerdict::Good);
    QCOMPARE(verifier.check(out), SignatureVerdict::Replayed);
    QCOMPARE(verifier.check(frame), SignatureVerdict::Unsigned);
    copy[12] ^= 1;
    QCOMPARE(verifier.check(out), SignatureVerdict::Wrong);
}

void SigningTest::keyFiles()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("key"));
    const auto read = [&path](const QByteArray &content) {
        QFile file(path);
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        file.close();
        return readSigningKey(path.toStdString());
    };
    const QByteArray hex("01" + QByteArray(62, '0'));
    QVERIFY(read(hex)->equals(keyOf(1)));
    QVERIFY(read(" " + hex + "\r\n")->equals(keyOf(1)));
    QVERIFY(read('\x01' + QByteArray(31, '\0'))->equals(keyOf(1)));
    for (const QByteArray &wrong :
         {QByteArray(), hex.left(62), hex + "0", hex + "00", QByteArray(64, 'g'), QByteArray(1000, '0')}) {
        const auto key = read(wrong);
        QVERIFY(!key);
        QCOMPARE(key.error().source, path.toStdString());
    }
    QVERIFY(!readSigningKey("/nowhere/key"));
}

SKYSEAL_TEST_APPLESS(SigningTest)
#include "signing_test.moc"
