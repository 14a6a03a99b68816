// The classification of received blocks by the rules of their link: every kind of traffic on every kind of link.
#include "core/channel/cobs.h"
#include "core/channel/handshake_messages.h"
#include "core/engine/common/ingress.h"
#include "tests/support/idle_link.h"
#include "tests/support/heartbeat.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;

namespace {

constexpr LinkId kLink{1};
constexpr TimePoint kReceivedAt{std::chrono::seconds(100)};

/// Writes down one letter for each call.
struct Calls final : IngressSink
{
    bool takePairing(const link::Link &, const link::ReceivedBlock &message) override
    {
        const bool is = pairing && !message.bytes.empty() && (message.bytes[0] & 0x0c) == 0x0c;
        if (is)
            text += 'P';
        return is;
    }
    bool namesSession(ByteView message) const override { return std::ranges::equal(message, sessionRecord); }
    bool takeRecord(const link::Link &, const link::ReceivedBlock &message) override
    {
        text += message.path.carrier == Carrier::Datagram ? 'R' : message.path.carrier == Carrier::Serial ? 'C' : 'T';
        return std::ranges::equal(message.bytes, sessionRecord);
    }
    void takeSealedInPlace(const link::Link &, const link::ReceivedBlock &) override { text += 'I'; }
    void takeClear(const link::Link &, const link::ReceivedBlock &, const mavlink::ScanItem &item) override
    {
        text += item.frame ? 'f' : mavlink::isDamagedFrame(item) ? 'd' : '-';
    }
    void takeUnusable(const link::Link &, Unusable what) override
    {
        constexpr std::string_view kLetters = "gcDM";
        text += kLetters[static_cast<std::size_t>(what)];
    }

    bool pairing = false;
    Bytes sessionRecord;
    std::string text;
};

Bytes bytesOf(const QByteArray &text)
{
    return Bytes(text.begin(), text.end());
}

const Bytes kHeartbeat = bytesOf(clearHeartbeat(1, 1, false));

Bytes damaged()
{
    Bytes out = kHeartbeat;
    out[8] ^= 0xff;
    return out;
}

/// A block with the first byte and the length of a first message.
Bytes firstMessage()
{
    Bytes out(channel::kFirstLength, 7);
    out[0] = channel::firstByte(channel::HandshakeMessage::First);
    return out;
}

Bytes pairingMessage()
{
    Bytes out(50, 7);
    out[0] = channel::firstByte(channel::DatagramKind::Pairing, 0);
    return out;
}

Bytes inCobs(const Bytes &message)
{
    Bytes out(channel::kMaxCobs);
    out.resize(channel::writeCobs(message, out));
    return out;
}

Bytes inTunnel(const Bytes &message)
{
    CarrierWriter writer;
    writer.setNode({7, 191});
    Bytes out;
    writer.write({kLink, {}, Carrier::Tunnel, {}}, message,
                 [&](ByteView frame) { out.insert(out.end(), frame.begin(), frame.end()); });
    return out;
}

/// An ingress with one link, and the calls that blocks lead to.
struct Bench
{
    Bench(const IngressRules &rules, const std::string &url) : m_link(url, kLink)
    {
        m_carriers.setNode({255, 190});
        ingress.addLink(kLink, rules, calls);
    }
    std::string take(Bytes bytes)
    {
        calls.text.clear();
        ingress.take(m_link, {{kLink, {}}, bytes, kReceivedAt});
        return calls.text;
    }

    Calls calls;

private:
    CarrierWriter m_carriers;
    IdleLink m_link;

public:
    Ingress ingress{mavlink::Dialect::builtin(), m_carriers};
};

IngressRules sealedDatagrams()
{
    return {.takesDatagrams = true, .takesTunnel = true, .dropsNodeHeartbeats = true};
}

IngressRules sealedStream()
{
    return {
        .isStream = true, .takesCobs = true, .takesTunnel = true, .dropsNodeHeartbeats = true, .clear = ClearScan::UnlessCobs};
}

} // namespace

class IngressTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void datagrams();
    void datagramsOfAPlainLink();
    void framesCutOverDatagrams();
    void unsearchedDatagrams();
    void pairingComesFirst();
    void clearFramesOnASharedStream();
    void streamOfCobsIsNotSearched();
    void resemblanceDoesNotEndTheSearch();
    void newStreamTakesRecordsOfSessionsOnly();
    void unsearchedLinkIsNeverSearched();
    void tunnelOnBothKindsOfLinks();
    void rulesChangeWithinABlock();
    void unregisteredLinkIsSilent();
};

void IngressTest::datagrams()
{
    Bench bench(sealedDatagrams(), "udpin:127.0.0.1:0");
    QCOMPARE(bench.take(firstMessage()), std::string("R"));
    QCOMPARE(bench.take(kHeartbeat), std::string("f"));
    QCOMPARE(bench.take(damaged()), std::string("dD"));
    QCOMPARE(bench.take({}), std::string("g"));
    QCOMPARE(bench.take({1, 2, 3}), std::string("-g"));
    Bytes two = kHeartbeat;
    two.insert(two.end(), kHeartbeat.begin(), kHeartbeat.end());
    QCOMPARE(bench.take(two), std::string("ff"));
}

void IngressTest::datagramsOfAPlainLink()
{
    Bench bench({}, "udpin:127.0.0.1:0");
    QCOMPARE(bench.take(firstMessage()), std::string("-g"));
    QCOMPARE(bench.take(kHeartbeat), std::string("f"));
    QCOMPARE(bench.take(inTunnel(firstMessage())), std::string("f"));
}

void IngressTest::framesCutOverDatagrams()
{
    const auto part = [](std::ptrdiff_t from, std::ptrdiff_t to) {
        return Bytes(kHeartbeat.begin() + from, kHeartbeat.begin() + to);
    };
    Bytes endAndRecord = part(8, std::ssize(kHeartbeat));
    Bench plain({.takesDatagrams = true}, "udpin:127.0.0.1:0");
    QCOMPARE(plain.take(part(0, 8)), std::string("D")); // not counted before it is known to be damaged
    QCOMPARE(plain.take(endAndRecord), std::string("f"));
    QCOMPARE(plain.take(kHeartbeat), std::string("f"));
    QCOMPARE(plain.take(part(0, 8)), std::string("D"));
    QCOMPARE(plain.take(kHeartbeat), std::string("df"));
    // A datagram that continues a frame and may be a record is both where records are opened: the beginning proves nothing.
    IngressRules rules = sealedDatagrams();
    rules.sealed = true;
    Bench sealed(rules, "udpin:127.0.0.1:0");
    QCOMPARE(sealed.take(firstMessage()), std::string("R"));
    QCOMPARE(sealed.take(part(0, 8)), std::string("D"));
    QCOMPARE(sealed.take(firstMessage()), std::string("d-R"));
    QCOMPARE(sealed.take(firstMessage()), std::string("R"));
}

void IngressTest::unsearchedDatagrams()
{
    IngressRules rules = sealedDatagrams();
    rules.clear = ClearScan::Never;
    Bench bench(rules, "udpin:127.0.0.1:0");
    QCOMPARE(bench.take(firstMessage()), std::string("R"));
    QCOMPARE(bench.take(kHeartbeat), std::string("c"));
    QCOMPARE(bench.take(Bytes(2048, 0xfe)), std::string("c")); // one call: the block is not searched
    QCOMPARE(bench.take(damaged()), std::string("c"));
    QCOMPARE(bench.take({1, 2, 3}), std::string("g"));
    QCOMPARE(bench.take({}), std::string("g"));
}

void IngressTest::pairingComesFirst()
{
    Bench bench(sealedDatagrams(), "udpin:127.0.0.1:0");
    QCOMPARE(bench.take(pairingMessage()), std::string("R")); // the channel counts it
    bench.calls.pairing = true;
    QCOMPARE(bench.take(pairingMessage()), std::string("P"));
    QCOMPARE(bench.take(inTunnel(pairingMessage())), std::string("P"));
    QCOMPARE(bench.take(firstMessage()), std::string("R"));
}

void IngressTest::clearFramesOnASharedStream()
{
    Bench bench(sealedStream(), "tcp:127.0.0.1:1");
    QCOMPARE(bench.take(damaged()), std::string("")); // may be an incomplete COBS frame
    QVERIFY(bench.take(kHeartbeat).ends_with('f'));
    Bytes both = damaged();
    both.insert(both.end(), kHeartbeat.begin(), kHeartbeat.end());
    QCOMPARE(bench.take(both), std::string("df")); // MAVLink was heard here
}

void IngressTest::streamOfCobsIsNotSearched()
{
    Bench bench(sealedStream(), "tcp:127.0.0.1:1");
    Bytes record(60, 7);
    record[0] = channel::firstByte(channel::DatagramKind::Record, 0);
    bench.calls.sessionRecord = record;
    QCOMPARE(bench.take(inCobs(record)), std::string("C"));
    QVERIFY(bench.ingress.isCobs({kLink, {}}, kReceivedAt));
    QCOMPARE(bench.take(kHeartbeat), std::string(""));
    bench.ingress.forget({kLink, {}});
    QVERIFY(!bench.ingress.isCobs({kLink, {}}, kReceivedAt));
    QCOMPARE(bench.take(kHeartbeat), std::string("f"));
}

void IngressTest::resemblanceDoesNotEndTheSearch()
{
    // Random bytes of records in TUNNEL contain, between two zeros, what a message in COBS would be.
    Bench bench(sealedStream(), "tcp:127.0.0.1:1");
    QCOMPARE(bench.take(inTunnel(firstMessage())), std::string("T"));
    QVERIFY(bench.take(inCobs(firstMessage())).starts_with('C'));
    QVERIFY(!bench.ingress.isCobs({kLink, {}}, kReceivedAt));
    QVERIFY(bench.take(inTunnel(firstMessage())).ends_with('T'));
    QVERIFY(bench.take(kHeartbeat).ends_with('f'));
}

void IngressTest::newStreamTakesRecordsOfSessionsOnly()
{
    Bytes record(60, 7);
    record[0] = channel::firstByte(channel::DatagramKind::Record, 0);
    Bytes other = record;
    other[1] = 8;
    Bench bench(sealedStream(), "tcp:127.0.0.1:1");
    bench.calls.sessionRecord = record;
    QVERIFY(bench.take(inCobs(other)).find('C') == std::string::npos);
    QVERIFY(!bench.ingress.isCobs({kLink, {}}, kReceivedAt));
    QVERIFY(bench.take(inCobs(record)).ends_with('C'));
    QVERIFY(bench.ingress.isCobs({kLink, {}}, kReceivedAt));
    QCOMPARE(bench.take(inCobs(other)), std::string("C"));
}

void IngressTest::unsearchedLinkIsNeverSearched()
{
    Bench bench({.isStream = true, .takesCobs = true, .clear = ClearScan::Never}, "tcp:127.0.0.1:1");
    QCOMPARE(bench.take(kHeartbeat), std::string(""));
    QCOMPARE(bench.take({0}), std::string("")); // ends the COBS frame that the heartbeat was taken for
    QCOMPARE(bench.take(inCobs(firstMessage())), std::string("C"));
    bench.ingress.setRules(kLink, {.isStream = true, .takesCobs = true, .clear = ClearScan::Always});
    QCOMPARE(bench.take(kHeartbeat), std::string("f")); // though COBS was heard
}

void IngressTest::tunnelOnBothKindsOfLinks()
{
    for (const bool isStream : {false, true}) {
        Bench bench({.isStream = isStream, .takesTunnel = true}, isStream ? "tcp:127.0.0.1:1" : "udpin:127.0.0.1:0");
        QCOMPARE(bench.take(inTunnel(firstMessage())), std::string("T"));
        QVERIFY(bench.take(firstMessage()).find('R') == std::string::npos); // only in TUNNEL
        QVERIFY(bench.take(kHeartbeat).ends_with('f'));
    }
}

void IngressTest::rulesChangeWithinABlock()
{
    // The sink ends the search for clear frames when it receives the message in front of them.
    struct Switching final : IngressSink
    {
        bool takeRecord(const link::Link &, const link::ReceivedBlock &) override
        {
            ingress->setRules(kLink, {.isStream = true, .takesCobs = true, .clear = ClearScan::Never});
            return false;
        }
        void takeClear(const link::Link &, const link::ReceivedBlock &, const mavlink::ScanItem &) override { ++clear; }
        Ingress *ingress = nullptr;
        int clear = 0;
    };
    Switching sink;
    CarrierWriter carriers;
    Ingress ingress(mavlink::Dialect::builtin(), carriers);
    sink.ingress = &ingress;
    ingress.addLink(kLink, {.isStream = true, .takesCobs = true, .clear = ClearScan::Always}, sink);
    IdleLink link("tcp:127.0.0.1:1", kLink);
    Bytes block = inCobs(firstMessage());
    block.insert(block.end(), kHeartbeat.begin(), kHeartbeat.end());
    ingress.take(link, {{kLink, {}}, block, kReceivedAt});
    QCOMPARE(sink.clear, 0);
}

void IngressTest::unregisteredLinkIsSilent()
{
    Bench bench(sealedDatagrams(), "udpin:127.0.0.1:0");
    bench.ingress.removeLink(kLink);
    QCOMPARE(bench.take(kHeartbeat), std::string(""));
}

SKYSEAL_TEST(IngressTest)
#include "ingress_test.moc"
