// The file with the cipher suites beside a recording: what is written can be read, and broken lines are counted and skipped.
#include "core/log/link_events.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <rapidcheck.h>

#include <fstream>
#include <sstream>

using namespace skyseal;
using namespace skyseal::tlog;

namespace {

constexpr WallTime kTime{std::chrono::microseconds(1'700'000'000'000'000)};

LinkEvents readText(const std::string &text)
{
    std::istringstream input(text);
    return readLinkEvents(input);
}

LinkEvent aes(const std::string &peer)
{
    return {LinkEvent::Kind::Switched, kTime, "aes-256-gcm", peer};
}

} // namespace

class LinkEventsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void formatIsTheDocumentedOne()
    {
        QCOMPARE(lineOf(aes("air-1")), std::string("1700000000000000 switched aes-256-gcm air-1\n"));
        const LinkEvent up{LinkEvent::Kind::Sealed, kTime, "chacha20-poly1305", {}};
        QCOMPARE(lineOf(up), std::string("1700000000000000 sealed chacha20-poly1305\n"));
        const LinkEvent plain{LinkEvent::Kind::Plain, kTime, "none", "2"};
        QCOMPARE(lineOf(plain), std::string("1700000000000000 plain none 2\n"));
        QVERIFY(linkEventOf("1700000000000000 plain none 2") == plain);
        QVERIFY(linkEventOf("1700000000000000 sealed chacha20-poly1305") == up);
        QVERIFY(linkEventOf("1700000000000000 switched aes-256-gcm air-1") == aes("air-1"));
        QVERIFY(linkEventOf("1700000000000000 switched aes-256-gcm the other  one") == aes("the other  one"));
    }

    void brokenLines_data()
    {
        QTest::addColumn<QByteArray>("line");
        const auto row = [](const char *name, const QByteArray &line) { QTest::newRow(name) << line; };
        row("empty", "");
        row("words", "no event");
        row("no suite", "1700000000000000 sealed");
        row("empty suite", "1700000000000000 sealed  air-1");
        row("unknown event", "1700000000000000 opened aes-256-gcm air-1");
        row("time before 1970", "-1 sealed aes-256-gcm air-1");
        row("time after 2200", "9223372036854775807 sealed aes-256-gcm air-1");
        row("time beyond 64 bits", "99999999999999999999 sealed aes-256-gcm air-1");
        row("letters in the time", "17000000000x0000 sealed aes-256-gcm air-1");
        row("markup as suite", "1700000000000000 sealed <b>aes</b> air-1");
        row("long suite", "1700000000000000 sealed " + QByteArray(41, 'a') + " air-1");
        row("long peer", "1700000000000000 sealed aes-256-gcm " + QByteArray(101, 'a'));
        row("escape in the peer", "1700000000000000 sealed aes-256-gcm air\x1b[31m");
        row("carriage return", "1700000000000000 sealed aes-256-gcm\r");
        row("peer without UTF-8", "1700000000000000 sealed aes-256-gcm \xff");
    }
    void brokenLines()
    {
        QFETCH(QByteArray, line);
        const LinkEvents read = readText(lineOf(aes("before")) + line.toStdString() + '\n' + lineOf(aes("after")));
        QCOMPARE(read.events.size(), std::size_t(2));
        QCOMPARE(read.events[1].peer, std::string("after"));
        QCOMPARE(read.unreadable, std::uint64_t(1));
    }

    void commentsAreSkipped()
    {
        const LinkEvents read = readText("# a comment\n" + lineOf(aes("air-1")) + "#\n");
        QCOMPARE(read.events.size(), std::size_t(1));
        QCOMPARE(read.unreadable, std::uint64_t(0));
    }

    /// A name that was cut looks like another peer.
    void lineThatACrashCutIsNoEvent()
    {
        const std::string whole = lineOf(aes("air-1")) + lineOf(aes("air-12"));
        const LinkEvents read = readText(whole.substr(0, whole.size() - 2));
        QCOMPARE(read.events.size(), std::size_t(1));
        QCOMPARE(read.unreadable, std::uint64_t(1));
    }

    void whatIsReadIsBounded()
    {
        std::string many;
        for (std::size_t i = 0; i < LinkEvents::kMost + 500; ++i)
            many += lineOf(aes("air-1"));
        QCOMPARE(readText(many).events.size(), LinkEvents::kMost);
        QCOMPARE(readText(many).unreadable, std::uint64_t(1));
        const LinkEvents endless = readText(std::string(3 * LinkEvents::kMostBytes, 'x'));
        QVERIFY(endless.events.empty());
        QCOMPARE(endless.unreadable, std::uint64_t(2)); // one line, and what was not read
    }

    /// The recorder writes no more than the reader takes.
    void longestLinesFit()
    {
        LinkEvent longest = aes(std::string(LinkEvent::kLongestPeer, 'p'));
        longest.suite.assign(LinkEvent::kLongestSuite, 's');
        QVERIFY((lineOf(longest).size() + 10) * LinkEvents::kMost < LinkEvents::kMostBytes);
    }

    void missingFileHasNoEvents()
    {
        const QTemporaryDir folder;
        const std::string recording = folder.filePath(QStringLiteral("a.tlog")).toStdString();
        QVERIFY(linkEventsOf(recording).events.empty());
        QCOMPARE(linkEventsOf(recording).unreadable, std::uint64_t(0));
        std::ofstream(linkEventsFile(recording)) << lineOf(aes("air-1"));
        QCOMPARE(linkEventsOf(recording).events.size(), std::size_t(1));
    }

    void fileThatIsNoneIsSaidToBeUnreadable()
    {
        const QTemporaryDir folder;
        const std::string recording = folder.filePath(QStringLiteral("a.tlog")).toStdString();
        QVERIFY(QDir().mkpath(QString::fromStdString(linkEventsFile(recording))));
        QCOMPARE(linkEventsOf(recording).unreadable, std::uint64_t(1));
    }

    void everyPeerIsWrittenReadably()
    {
        QVERIFY(rc::check("the line of any peer is one readable line", [](const std::string &peer) {
            const LinkEvents read = readText(lineOf(aes(peer)));
            RC_ASSERT(read.events.size() == 1 && read.unreadable == 0);
            RC_ASSERT(lineOf(read.events[0]) == lineOf(aes(peer)));
        }));
        const std::string umlauts = [] {
            std::string out;
            for (int i = 0; i < 80; ++i)
                out += "\xc3\xbc";
            return out;
        }();
        QCOMPARE(readText(lineOf(aes(umlauts))).events.at(0).peer, umlauts.substr(0, LinkEvent::kLongestPeer));
        QCOMPARE(readText(lineOf(aes('x' + umlauts))).events.at(0).peer.size(), LinkEvent::kLongestPeer - 1); // no half of one
    }
};

SKYSEAL_TEST_APPLESS(LinkEventsTest)
#include "link_events_test.moc"
