// The stream of the paper's published code, encrypted by another implementation (Python's cryptography) with the keys and
// nonces that are built into that code.
#include "core/base/secret_bytes.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/base/hex.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/common/mavsec_stream.h"
#include "core/engine/station/bare_sink.h"
#include "core/mavlink/frame_writer.h"
#include "tests/support/idle_link.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using crypto::MavsecCipher;

namespace {

MavsecStream published(MavsecCipher::Kind kind)
{
    auto cipher = MavsecCipher::make(kind, MavsecCipher::publishedKey(kind), MavsecCipher::publishedNonce(kind),
                                     MavsecCipher::kPublishedCounter);
    return {std::move(*cipher), mavlink::Dialect::builtin()};
}

} // namespace

class MavsecStreamTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void opensFramesOfAnotherImplementation_data();
    void opensFramesOfAnotherImplementation();
    void otherKeysGiveOtherBytes();
    void nonceHasOneLength();
    void framesPassWhileTheHeartbeatIsReadable();
};

void MavsecStreamTest::opensFramesOfAnotherImplementation_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<std::string>("encrypted");
    QTest::addColumn<std::string>("plain");
    const std::string heartbeat = "fd090000070101000000040000000203510403381c";
    const std::string attitude = "fd1c00000801011e000040e201000000803e000000be0000c03f0ad7233c0ad7a33c8fc2f53c8fc3";
    const std::string old = "fe090901010004000000020351040368fc"; // MAVLink 1
    const int chacha = static_cast<int>(MavsecCipher::Kind::ChaCha20), aes = static_cast<int>(MavsecCipher::Kind::Aes256Ctr);
    QTest::newRow("chacha20, heartbeat") << chacha << std::string("fd090000070101000000264f51f3421888e52c611b") << heartbeat;
    QTest::newRow("chacha20, attitude")
        << chacha << std::string("fd1c00000801011e000062ad50f3401b59df2fde27d1b863ddd286c43cbe37fba5def18d3fd0aac2")
        << attitude;
    QTest::newRow("chacha20, MAVLink 1") << chacha << std::string("fe0909010100264f51f3421888e52c31fb") << old;
    QTest::newRow("aes-256-ctr, heartbeat") << aes << std::string("fd0900000701010000000fdf7df15b1447375dc839") << heartbeat;
    QTest::newRow("aes-256-ctr, attitude")
        << aes << std::string("fd1c00000801011e00004b3d7cf15917960d5e9a8babc860053d50b94aa159b6ba3adbf17300142f") << attitude;
    QTest::newRow("aes-256-ctr, MAVLink 1") << aes << std::string("fe09090101000fdf7df15b1447375d98d9") << old;
}

void MavsecStreamTest::opensFramesOfAnotherImplementation()
{
    QFETCH(int, kind);
    QFETCH(std::string, encrypted);
    QFETCH(std::string, plain);
    MavsecStream stream = published(static_cast<MavsecCipher::Kind>(kind));
    const auto bytes = fromHex(encrypted);
    const auto frame = mavlink::readFrame(*bytes, mavlink::Dialect::builtin());
    QVERIFY(frame);                         // the checksum is over what is encrypted
    for (int again = 0; again < 3; ++again) // begun anew for each frame
        QCOMPARE(toHex(stream.open(*frame).bytes()), plain);
    QCOMPARE(toHex(*bytes), encrypted);
}

void MavsecStreamTest::otherKeysGiveOtherBytes()
{
    const auto bytes = fromHex("fd090000070101000000264f51f3421888e52c611b");
    const auto frame = mavlink::readFrame(*bytes, mavlink::Dialect::builtin());
    const auto kind = MavsecCipher::Kind::ChaCha20;
    const Bytes right = [&] {
        MavsecStream stream = published(kind);
        const ByteView payload = stream.open(*frame).payload();
        return Bytes(payload.begin(), payload.end());
    }();
    Bytes nonce = MavsecCipher::publishedNonce(kind);
    const auto opened = [&](const Key32 &key, const Bytes &with, std::uint32_t counter) {
        MavsecStream stream(*MavsecCipher::make(kind, key, with, counter), mavlink::Dialect::builtin());
        const ByteView payload = stream.open(*frame).payload();
        return Bytes(payload.begin(), payload.end());
    };
    QVERIFY(opened(Key32(), nonce, 1) != right);
    QVERIFY(opened(MavsecCipher::publishedKey(kind), nonce, 0) != right);
    ++nonce[11];
    QVERIFY(opened(MavsecCipher::publishedKey(kind), nonce, 1) != right);
}

void MavsecStreamTest::nonceHasOneLength()
{
    for (const auto kind : {MavsecCipher::Kind::ChaCha20, MavsecCipher::Kind::Aes256Ctr}) {
        for (std::size_t length = 0; length <= 20; ++length)
            QCOMPARE(MavsecCipher::make(kind, Key32(), Bytes(length), 0).has_value(),
                     length == MavsecCipher::nonceLength(kind));
    }
}

namespace {

/// The bytes of the frames that it receives, and how many other things.
struct PassedOn final : IngressSink
{
    void takeClear(const link::Link &, const link::ReceivedBlock &, const mavlink::ScanItem &item) override
    {
        others += !item.frame;
        if (item.frame)
            frames.push_back(toHex(item.frame->bytes()));
        if (item.frame && toHex(item.bytes) != frames.back())
            frames.back() = "the bytes of the item are others";
    }
    bool takeRecord(const link::Link &, const link::ReceivedBlock &) override
    {
        ++others;
        return false;
    }

    std::vector<std::string> frames;
    int others = 0;
};

} // namespace

/// A vehicle begins to encrypt, changes its cipher and stops, under the eyes of a station that expects ChaCha20.
void MavsecStreamTest::framesPassWhileTheHeartbeatIsReadable()
{
    mavlink::FrameWriter writer(1, 1);
    const auto written = [&](const auto &message) {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const auto bytes = writer.write(message, buffer);
        return Bytes(bytes.begin(), bytes.end());
    };
    mavlink::Heartbeat alive;
    alive.autopilot = mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
    alive.type = mavlink::MAV_TYPE_QUADROTOR;
    alive.system_status = mavlink::MAV_STATE_STANDBY;
    mavlink::Attitude attitude;
    attitude.roll = 0.25F;
    const Bytes heartbeat = written(alive), telemetry = written(attitude);

    PassedOn rest;
    std::uint64_t unreadable = 0;
    BareSink sink(published(MavsecCipher::Kind::ChaCha20), rest, unreadable);
    MavsecStream right = published(MavsecCipher::Kind::ChaCha20), wrong = published(MavsecCipher::Kind::Aes256Ctr);
    const test::IdleLink link("udpin:127.0.0.1:1", LinkId{1});
    const auto send = [&](const Bytes &bytes, MavsecStream *by) {
        mavlink::ScanItem item;
        item.frame = *mavlink::readFrame(bytes, mavlink::Dialect::builtin());
        if (by)
            item.frame = by->seal(*item.frame);
        item.bytes = item.frame->bytes();
        sink.takeClear(link, {}, item);
    };
    send(telemetry, &right); // nothing is known of the vehicle yet
    QCOMPARE(rest.frames.size(), std::size_t(0));
    for (int again = 0; again < 2; ++again) {
        rest.frames.clear();
        send(heartbeat, &right);
        send(telemetry, &right);
        QCOMPARE(rest.frames, (std::vector<std::string>{toHex(heartbeat), toHex(telemetry)}));
        for (MavsecStream *other : {&wrong, static_cast<MavsecStream *>(nullptr)}) {
            const std::uint64_t before = unreadable;
            send(heartbeat, other);
            send(telemetry, other);
            QCOMPARE(unreadable, before + 2);
        }
        QCOMPARE(rest.frames.size(), std::size_t(2));
    }
    sink.takeClear(link, {}, mavlink::ScanItem{}); // a damaged region
    sink.takeRecord(link, {});
    QCOMPARE(rest.others, 2);
}

SKYSEAL_TEST_APPLESS(MavsecStreamTest)
#include "mavsec_stream_test.moc"
