// The byte layout of records, control messages and announcements; other bytes are refused.
#include "core/crypto/x25519.h"
#include "core/base/hex.h"
#include "core/channel/control.h"
#include "core/channel/key_chain.h"
#include "core/channel/mac1.h"
#include "core/channel/record.h"
#include "pair.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

using namespace skyseal;
using namespace skyseal::channel;
using crypto::SuiteId;

class RecordTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void headerBytes();
    void headersSurviveTheWire();
    void otherFirstBytesAreRefused();
    void shortRecordsAreRefused();
    void associatedDataIsUnambiguous();
    void controlBytes();
    void controlSurvivesTheWire();
    void randomControlMessagesAreSafe();
    void numbersOfReportsHave64Bits();
    void announcementsNeedTheKeyToBeRecognised();
    void epochKeysDependOnEverything();
};

void RecordTest::headerBytes()
{
    Bytes bytes(40);
    RecordHeader{DatagramKind::Record, 2, ConnectionId{0xbeef}, 0x0a0b0c}.write(bytes);
    QCOMPARE(toHex(ByteView(bytes).first(6)), std::string("52efbe0c0b0a"));
    RecordHeader{DatagramKind::SingleRecord, 3, {}, 1}.write(bytes);
    QCOMPARE(toHex(ByteView(bytes).first(4)), std::string("57010000"));
    const AssociatedData associated(ByteView(bytes).first(4), SuiteId::Aes256Ctr, Direction::FromResponder, Carrier::Serial);
    QCOMPARE(toHex(associated.view()), std::string("57010000030103"));
}

void RecordTest::headersSurviveTheWire()
{
    QVERIFY(rc::check([] {
        RecordHeader header;
        header.kind = *rc::gen::element(DatagramKind::Record, DatagramKind::SingleRecord);
        header.epochBits = static_cast<std::uint8_t>(*rc::gen::inRange(0, 4));
        header.connection = ConnectionId{*rc::gen::arbitrary<std::uint16_t>()};
        header.counter = *rc::gen::inRange(0u, 1u << 24);
        Bytes bytes(kRecordHeaderLength + kMacLength);
        header.write(bytes);
        const auto read = RecordHeader::read(bytes);
        RC_ASSERT(read && read->kind == header.kind && read->epochBits == header.epochBits);
        RC_ASSERT(read->counter == header.counter);
        RC_ASSERT(header.kind == DatagramKind::SingleRecord || read->connection == header.connection);
    }));
}

void RecordTest::otherFirstBytesAreRefused()
{
    Bytes bytes(60);
    for (int first = 0; first < 256; ++first) {
        bytes[0] = static_cast<std::uint8_t>(first);
        QCOMPARE(RecordHeader::read(bytes).has_value(), first >= 0x50 && first <= 0x57);
        QCOMPARE(isOurs(bytes[0]), first >= 0x40 && first <= 0x7f);
    }
}

void RecordTest::shortRecordsAreRefused()
{
    Bytes bytes(60, 0x50);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        QCOMPARE(RecordHeader::read(ByteView(bytes).first(length)).has_value(), length >= 22);
    bytes[0] = 0x54;
    for (std::size_t length = 0; length < bytes.size(); ++length)
        QCOMPARE(RecordHeader::read(ByteView(bytes).first(length)).has_value(), length >= 20);
}

void RecordTest::associatedDataIsUnambiguous()
{
    std::set<std::string> seen;
    std::size_t count = 0;
    Bytes header(kRecordHeaderLength);
    for (const DatagramKind kind : {DatagramKind::Record, DatagramKind::SingleRecord}) {
        for (const auto &suite : crypto::suites()) {
            for (const Direction direction : {Direction::FromInitiator, Direction::FromResponder}) {
                for (const Carrier carrier : {Carrier::Datagram, Carrier::Tunnel, Carrier::Serial}) {
                    const RecordHeader h{kind, 1, ConnectionId{7}, 9};
                    h.write(header);
                    const AssociatedData data(ByteView(header).first(h.length()), suite.id, direction, carrier);
                    seen.insert(toHex(data.view()));
                    ++count;
                }
            }
        }
    }
    QCOMPARE(seen.size(), count);
}

void RecordTest::controlBytes()
{
    Bytes out(kMaxControl);
    const auto hexOf = [&](const ControlMessage &message) {
        const std::size_t length = writeControl(message, out);
        return toHex(ByteView(out).first(length));
    };
    crypto::PublicKey key;
    for (std::size_t i = 0; i < key.size(); ++i)
        key[i] = static_cast<std::uint8_t>(i);
    QCOMPARE(hexOf(Propose{ProposalId{5}, Epoch{9}, SuiteId::Aes256Cbc, key}),
             std::string("0105000000090000000") + "4000102030405060708090a0b0c0d0e0f" + "101112131415161718191a1b1c1d1e1f");
    QCOMPARE(hexOf(Accept{ProposalId{5}, key}),
             std::string("0205000000000102030405060708090a0b0c0d0e0f") + "101112131415161718191a1b1c1d1e1f");
    QCOMPARE(hexOf(Refuse{ProposalId{5}}), std::string("0305000000"));
    QCOMPARE(hexOf(Confirm{Epoch{9}, 300}), std::string("04090000002c010000"));
    QCOMPARE(hexOf(Confirmed{Epoch{9}, 300}), std::string("05090000002c010000"));
    Report report;
    report.stamp = 1;
    report.echo = 2;
    report.held = 3;
    report.answerAtOnce = true;
    report.rx = {300, 1, 2, 3, 4, 5, 6, 127};
    report.tx = {128, 0};
    QCOMPARE(hexOf(report), std::string("0601010000000200000003000000ac020102030405067f800100"));
    report.answerAtOnce = false;
    report.frames = FrameCounters{200, 5};
    QCOMPARE(hexOf(report), std::string("0602010000000200000003000000ac020102030405067f800100c80105"));
    QCOMPARE(hexOf(Close{}), std::string("07"));
}

void RecordTest::controlSurvivesTheWire()
{
    QVERIFY(rc::check([] {
        Report report;
        report.stamp = *rc::gen::arbitrary<std::uint32_t>();
        report.rx.good = *rc::gen::arbitrary<std::uint64_t>();
        report.rx.openedBytes = UINT64_MAX;
        report.tx.records = *rc::gen::arbitrary<std::uint64_t>();
        report.tx.sealedBytes = *rc::gen::arbitrary<std::uint64_t>();
        if (*rc::gen::arbitrary<bool>())
            report.frames = FrameCounters{*rc::gen::arbitrary<std::uint64_t>(), UINT64_MAX};
        Bytes out(kMaxControl);
        const std::size_t length = writeControl(report, out);
        RC_ASSERT(length > 0u);
        const auto read = readControl(ByteView(out).first(length));
        RC_ASSERT(read && std::holds_alternative<Report>(*read));
        const auto &copy = std::get<Report>(*read);
        RC_ASSERT(copy.stamp == report.stamp && copy.rx.good == report.rx.good && copy.rx.openedBytes == UINT64_MAX);
        RC_ASSERT(copy.tx.records == report.tx.records && copy.tx.sealedBytes == report.tx.sealedBytes);
        RC_ASSERT(copy.frames.has_value() == report.frames.has_value());
        // The parentheses are needed: the operators that the macro overloads evaluate both sides.
        RC_ASSERT((!copy.frames || (copy.frames->taken == report.frames->taken && copy.frames->lost == UINT64_MAX)));
        for (std::size_t shorter = 0; shorter < length; ++shorter)
            RC_ASSERT(!readControl(ByteView(out).first(shorter)));
    }));
}

void RecordTest::randomControlMessagesAreSafe()
{
    QVERIFY(rc::check([] {
        auto bytes = *rc::gen::arbitrary<Bytes>();
        if (!bytes.empty())
            bytes[0] &= 0x0f;
        const auto message = readControl(bytes);
        if (!message)
            return;
        Bytes out(kMaxControl);
        const auto length = writeControl(*message, out);
        const auto again = readControl(ByteView(out).first(length));
        RC_ASSERT(again && again->index() == message->index());
    }));
    QVERIFY(!readControl({}));
}

void RecordTest::numbersOfReportsHave64Bits()
{
    const auto reads = [](const char *number, std::size_t place) {
        Bytes report = *fromHex("0600010000000000000000000000");
        for (std::size_t i = 0; i < 10; ++i) {
            const Bytes bytes = *fromHex(i == place ? number : "00");
            report.insert(report.end(), bytes.begin(), bytes.end());
        }
        return readControl(report).has_value();
    };
    for (const std::size_t place : {0u, 7u, 8u, 9u}) {
        QVERIFY(reads("ffffffffffffffffff01", place));
        QVERIFY(!reads("ffffffffffffffffff02", place)); // one bit more
        QVERIFY(!reads("ffffffffffffffffff81", place));
        QVERIFY(!reads("8080808080808080808000", place)); // a byte more
    }
}

void RecordTest::announcementsNeedTheKeyToBeRecognised()
{
    test::SeededRandom random(3);
    const auto agent = crypto::X25519KeyPair::generate(random);
    const auto other = crypto::X25519KeyPair::generate(random);
    auto one = Announcement(agent.publicKey).make(random);
    const auto two = Announcement(agent.publicKey).make(random);
    QVERIFY(Announcement(agent.publicKey).recognises(one));
    QVERIFY(Announcement(agent.publicKey).recognises(two));
    QVERIFY(!Announcement(other.publicKey).recognises(one));
    // No bytes by which an observer could link two of them.
    QVERIFY(!std::equal(one.begin() + 1, one.begin() + 17, two.begin() + 1));
    QVERIFY(!std::equal(one.begin() + 17, one.begin() + 33, two.begin() + 17));
    for (std::size_t bit = 8; bit < 33 * 8; ++bit) {
        one[bit / 8] = static_cast<std::uint8_t>(one[bit / 8] ^ 1u << bit % 8);
        QVERIFY(!Announcement(agent.publicKey).recognises(one));
        one[bit / 8] = static_cast<std::uint8_t>(one[bit / 8] ^ 1u << bit % 8);
    }
}

void RecordTest::epochKeysDependOnEverything()
{
    Key32 a, b;
    a.mutableView()[0] = 1;
    b.mutableView()[0] = 2;
    const Bytes hash(64, 3);
    Bytes otherHash = hash;
    otherHash[0] ^= 1;
    const auto exchanged = [](std::uint8_t proposer, std::uint8_t answerer, std::uint8_t shared) {
        SwitchSecret out;
        out.proposer[31] = proposer;
        out.answerer[31] = answerer;
        out.shared.mutableView()[31] = shared;
        return out;
    };

    std::set<std::string> seen;
    std::size_t count = 0;
    const auto note = [&](const EpochSecrets &secrets) {
        seen.insert(toHex(secrets.fromInitiator.view()));
        seen.insert(toHex(secrets.fromResponder.view()));
        count += 2;
    };
    const KeyChain chain(a, b, hash);
    note(chain.begin(SuiteId::Aes256Gcm));
    note(chain.begin(SuiteId::Aes256Ctr));
    note(KeyChain(b, a, hash).begin(SuiteId::Aes256Gcm));
    note(KeyChain(a, b, otherHash).begin(SuiteId::Aes256Gcm));
    const EpochSecrets zero = chain.begin(SuiteId::Aes256Gcm);
    note(zero.next.advance(Epoch{1}, SuiteId::Aes256Gcm, exchanged(0, 0, 0)));
    note(zero.next.advance(Epoch{2}, SuiteId::Aes256Gcm, exchanged(0, 0, 0)));
    note(zero.next.advance(Epoch{1}, SuiteId::Aes256Ctr, exchanged(0, 0, 0)));
    note(zero.next.advance(Epoch{1}, SuiteId::Aes256Gcm, exchanged(1, 0, 0)));
    note(zero.next.advance(Epoch{1}, SuiteId::Aes256Gcm, exchanged(0, 1, 0)));
    note(zero.next.advance(Epoch{1}, SuiteId::Aes256Gcm, exchanged(0, 0, 1)));
    const EpochSecrets one = zero.next.advance(Epoch{1}, SuiteId::Aes256Gcm, exchanged(0, 0, 0));
    note(one.next.advance(Epoch{1}, SuiteId::Aes256Gcm, exchanged(0, 0, 0)));
    QCOMPARE(seen.size(), count);
    // and not on other inputs
    note(KeyChain(a, b, hash).begin(SuiteId::Aes256Gcm));
    QCOMPARE(seen.size(), count - 2);
}

SKYSEAL_TEST(RecordTest)
#include "record_test.moc"
