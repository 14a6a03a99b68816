// The opening of records, apart from a session: the keys of two ends, and every reason for which a record is refused.
#include "core/channel/record_receiver.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::channel;
using crypto::SuiteId;

namespace {

constexpr TimePoint kNow{std::chrono::hours(1)};
constexpr Carrier kCarrier = Carrier::Datagram;

Key32 keyOf(std::uint8_t value)
{
    Key32 out;
    std::ranges::fill(out.mutableView(), value);
    return out;
}

KeyChain chain()
{
    return KeyChain(keyOf(1), keyOf(2), Bytes(32, 3));
}

SwitchSecret exchanged()
{
    return {.shared = keyOf(4)};
}

/// A station that seals and an agent's receiver that opens, with the same keys.
struct Ends
{
    explicit Ends(SuiteId suite = SuiteId::ChaCha20Poly1305)
    {
        station.begin(suite);
        agent.begin(suite);
    }

    Bytes seal(const Bytes &plaintext, std::uint32_t counter)
    {
        LiveEpoch &epoch = station.current();
        const RecordHeader header{DatagramKind::Record, static_cast<std::uint8_t>(static_cast<std::uint32_t>(epoch.number) & 3),
                                  ConnectionId{7}, counter};
        Bytes out(kRecordHeaderLength + epoch.writer->sealedSize(plaintext.size()));
        header.write(out);
        const AssociatedData aad(header, epoch.suite, Direction::FromInitiator, kCarrier);
        epoch.writer->seal(nonceOf(counter), aad.view(), plaintext, MutableByteView(out).subspan(kRecordHeaderLength));
        return out;
    }
    /// Opens a copy and marks its counter, as a session does. The text is the plaintext or the name of the fault.
    std::string open(Bytes record, Carrier carrier = kCarrier)
    {
        const auto header = RecordHeader::read(record);
        if (!header)
            return "no header";
        const auto opened = receiver.open(*header, carrier, record);
        if (!opened) {
            constexpr const char *kNames[] = {"replayed", "forged", "malformed", "cloned"};
            return kNames[static_cast<std::size_t>(opened.error())];
        }
        opened->epoch.window.mark(opened->counter);
        return std::string(opened->plaintext.begin(), opened->plaintext.end());
    }

    Epochs station{chain(), true, false}, agent{chain(), false, false};
    RecordReceiver receiver{agent, Direction::FromInitiator, kNow};
};

const Bytes kText{'f', 'r', 'a', 'm', 'e'};

} // namespace

class RecordReceiverTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void opensEachRecordOnce();
    void refusesChangedBytes();
    void refusesAnotherCarrier();
    void refusesUnknownEpochs();
    void namesACloneByItsSecondRecord();
    void opensUnderTheNextEpoch();
    void everySuiteOpens();
};

void RecordReceiverTest::opensEachRecordOnce()
{
    Ends ends;
    const Bytes first = ends.seal(kText, 0), second = ends.seal(kText, 1);
    QCOMPARE(ends.open(second), std::string("frame"));
    QCOMPARE(ends.open(first), std::string("frame")); // reordered
    QCOMPARE(ends.open(first), std::string("replayed"));
    QCOMPARE(ends.open(second), std::string("replayed"));
    QCOMPARE(ends.agent.received().replayed, std::uint64_t(2));
    QCOMPARE(ends.receiver.forgeries().pendingForged(), std::uint64_t(0)); // networks duplicate datagrams
}

void RecordReceiverTest::refusesChangedBytes()
{
    Ends ends;
    const Bytes record = ends.seal(kText, 0);
    for (std::size_t at = kRecordHeaderLength; at < record.size(); ++at) {
        Bytes changed = record;
        changed[at] ^= 1;
        QCOMPARE(ends.open(changed), std::string("forged"));
    }
    const std::uint64_t forged = record.size() - kRecordHeaderLength;
    QCOMPARE(ends.agent.received().forged, forged);
    QCOMPARE(ends.receiver.forgeries().pendingForged(), forged);
    QCOMPARE(ends.open(record), std::string("frame")); // the window was not marked
}

void RecordReceiverTest::refusesAnotherCarrier()
{
    Ends ends;
    QCOMPARE(ends.open(ends.seal(kText, 0), Carrier::Tunnel), std::string("forged"));
}

void RecordReceiverTest::refusesUnknownEpochs()
{
    Ends ends;
    for (const unsigned ahead : {1u, 2u, 3u}) {
        Bytes record = ends.seal(kText, ahead);
        record[0] = channel::firstByte(DatagramKind::Record, static_cast<std::uint8_t>(ahead));
        // One ahead could only come of an agreement that this end does not know.
        QCOMPARE(ends.open(record), std::string(ahead == 1 ? "forged" : "replayed"));
    }
}

void RecordReceiverTest::namesACloneByItsSecondRecord()
{
    Ends ends;
    const Bytes first = ends.seal(kText, 0), second = ends.seal({'c', 'l', 'o', 'n', 'e'}, 0);
    QCOMPARE(ends.open(first), std::string("frame"));
    Bytes forged = second;
    forged.back() ^= 1;
    QCOMPARE(ends.open(forged), std::string("replayed")); // not authentic: no proof of a clone
    QCOMPARE(ends.open(second), std::string("cloned"));
}

void RecordReceiverTest::opensUnderTheNextEpoch()
{
    Ends ends;
    const Bytes before = ends.seal(kText, 0);
    QVERIFY(ends.station.prepareNext(SuiteId::Aes256Gcm, exchanged())
            && ends.agent.prepareNext(SuiteId::Aes256Gcm, exchanged()));
    ends.station.advance();
    const Bytes after = ends.seal(kText, 0);
    QCOMPARE(ends.open(after), std::string("frame"));
    QCOMPARE(ends.open(before), std::string("frame")); // the epoch in use until the session advances
    ends.agent.advance();
    QCOMPARE(ends.open(before), std::string("replayed"));
    ends.agent.retirePrevious();
    QCOMPARE(ends.open(ends.seal(kText, 1)), std::string("frame"));
}

void RecordReceiverTest::everySuiteOpens()
{
    for (const SuiteId suite : crypto::sealedSuites()) {
        Ends ends(suite);
        if (!ends.station.begun())
            continue; // this machine lacks the cipher
        QCOMPARE(ends.open(ends.seal(kText, 5)), std::string("frame"));
    }
}

SKYSEAL_TEST(RecordReceiverTest)
#include "record_receiver_test.moc"
