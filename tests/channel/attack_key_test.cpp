// Attacks on the sealing of a single record, with known keys: the binding of a record to its keys and context, and whether
// wrong padding can be distinguished from a wrong tag.
#include "core/channel/key_chain.h"
#include "core/channel/record.h"
#include "core/crypto/encrypt_then_mac.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/record_cipher.h"
#include "core/crypto/record_keys.h"
#include "every_suite.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

using namespace skyseal;
using namespace skyseal::test;
using namespace skyseal::channel;
using namespace skyseal::crypto;

class AttackKeyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(initCrypto()); }
    void contextIsSealedIn_data();
    void contextIsSealedIn();
    void directionsHaveSeparateKeys_data() { everySuite(); }
    void directionsHaveSeparateKeys();
    void badPaddingLooksLikeABadTag();

private:
    Key32 m_secret = [] {
        Key32 key;
        SeededRandom(kAttackSeed).fill(key.mutableView());
        return key;
    }();
    const Bytes m_frame = Bytes(28, 0xfd);
};

void AttackKeyTest::contextIsSealedIn_data()
{
    QTest::addColumn<int>("suite");
    QTest::addColumn<QString>("part");
    for (const SuiteInfo &info : suites()) {
        if (info.id == SuiteId::None || !suiteAvailable(info.id))
            continue;
        for (const char *part : {"header", "suite", "direction", "carrier"})
            QTest::addRow("%s of %s", part, info.name.data()) << static_cast<int>(info.id) << QString::fromLatin1(part);
    }
}

void AttackKeyTest::contextIsSealedIn()
{
    QFETCH(int, suite);
    QFETCH(QString, part);
    const auto id = static_cast<SuiteId>(suite);
    const auto writer = makeRecordCipher(id, m_secret.clone()), reader = makeRecordCipher(id, m_secret.clone());
    using Header = std::array<std::uint8_t, kRecordHeaderLength>;
    Header header{};
    RecordHeader{DatagramKind::Record, 1, ConnectionId{0x1234}, 7}.write(header);
    const auto sealed = [&] {
        Bytes out(m_frame.size() + kMaxRecordOverhead);
        const AssociatedData said(header, id, Direction::FromResponder, Carrier::Datagram);
        out.resize(writer->seal(7, said.view(), m_frame, out));
        return out;
    }();
    const auto opens = [&](const Header &head, SuiteId named, Direction direction, Carrier carrier) {
        Bytes copy = sealed;
        return reader->open(7, AssociatedData(head, named, direction, carrier).view(), copy).has_value();
    };
    QVERIFY(opens(header, id, Direction::FromResponder, Carrier::Datagram));
    int others = 0;
    if (part == QLatin1String("direction")) {
        others += opens(header, id, Direction::FromInitiator, Carrier::Datagram);
    } else if (part == QLatin1String("carrier")) {
        for (const Carrier carrier : {Carrier::Tunnel, Carrier::Serial})
            others += opens(header, id, Direction::FromResponder, carrier);
    } else if (part == QLatin1String("suite")) {
        for (const SuiteInfo &other : suites())
            others += other.id != id && opens(header, other.id, Direction::FromResponder, Carrier::Datagram);
    } else {
        for (std::size_t bit = 0; bit < header.size() * 8; ++bit) {
            Header changed = header;
            changed[bit / 8] = static_cast<std::uint8_t>(changed[bit / 8] ^ 1u << bit % 8);
            others += opens(changed, id, Direction::FromResponder, Carrier::Datagram);
        }
    }
    HOLDS(others == 0, "header, suite, direction and carrier are sealed in");
}

void AttackKeyTest::directionsHaveSeparateKeys()
{
    QFETCH(int, suite);
    const auto id = static_cast<SuiteId>(suite);
    const KeyChain chain(m_secret, m_secret, asBytes("a handshake's hash"));
    EpochSecrets secrets = chain.begin(id);
    const auto initiators = makeRecordCipher(id, std::move(secrets.fromInitiator));
    const auto responders = makeRecordCipher(id, std::move(secrets.fromResponder));
    Bytes record(m_frame.size() + kMaxRecordOverhead);
    record.resize(initiators->seal(0, {}, m_frame, record));
    HOLDS(!responders->open(0, {}, record), "what one end seals does not open as the other's");
}

void AttackKeyTest::badPaddingLooksLikeABadTag()
{
    // Two blocks whose last byte is not valid padding, under a valid tag: only an owner of the keys can make them, and the
    // result is the same as for a wrong tag, with the plaintext wiped.
    const RecordKeys keys = RecordKeys::derive(m_secret, SuiteId::Aes256Cbc);
    RecordMac mac(keys.mac);
    const auto cipher = makeRecordCipher(SuiteId::Aes256Cbc, m_secret.clone());
    for (const std::uint8_t last : {0x00, 0x11, 0x05, 0xff}) {
        const Bytes plaintext(32, last);
        Bytes record(plaintext.size() + kMaxRecordOverhead);
        QCOMPARE(cipher->seal(9, {}, plaintext, record), std::size_t(48 + 16));
        record.resize(32 + RecordMac::kLength); // without the block of padding
        const auto tag = mac.tag(9, {}, ByteView(record).first(32));
        QVERIFY(tag);
        std::copy(tag->begin(), tag->end(), record.begin() + 32);
        Bytes wrongTag = record;
        wrongTag.back() ^= 1;
        const bool badPadding = cipher->open(9, {}, record).has_value(), badTag = cipher->open(9, {}, wrongTag).has_value();
        QVERIFY(!badTag);
        HOLDS(badPadding == badTag || last == 0x05, "bad padding is refused as a bad tag is");
        if (last != 0x05) // five fives at the end are valid padding: a control of the test itself
            QVERIFY(std::all_of(record.begin(), record.begin() + 32, [](std::uint8_t byte) { return byte == 0; }));
        else
            QVERIFY(badPadding);
    }
}

SKYSEAL_TEST(AttackKeyTest)
#include "attack_key_test.moc"
