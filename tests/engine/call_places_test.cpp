// Which links a station calls for agents that listen: MAVLink from the address of a link makes calls rare for a while, and no
// other MAVLink does.
#include "core/engine/station/call_places.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtNetwork/QUdpSocket>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;

namespace {

struct NoListener final : link::LinkListener
{
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
};

} // namespace

class CallPlacesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_links.remove(kLink); }
    void mavlinkFromThereMakesCallsRare();
    void rareCallWaitsForItsTurn();
    void forgedMavlinkNeverStopsCalls_data();
    void forgedMavlinkNeverStopsCalls();
    void mavlinkFromElsewhereDoesNot();
    void notWhereAnAgentHadASession();
    void notWhereAVehicleIsFlownInClear();

private:
    static constexpr LinkId kLink{1};

    struct Second
    {
        bool calls = false, requests = false; ///< the address may be called, or requested to pair
    };
    Second update(bool flown = false)
    {
        const auto places = m_places.update(
            m_now, m_links, [flown](const Path &) { return flown; }, [this](const Path &) { return m_called; });
        if (!places.calls.empty() && m_now >= m_nextTurn) {
            m_called = m_now;
            m_nextTurn = m_now + m_turns;
        }
        return {!places.calls.empty(), !places.requests.empty()};
    }
    /// The seconds from now on in which the address may be called. `mavlink`: a frame comes from it twice a second.
    int callsIn(int seconds, bool mavlink = false, bool flown = false)
    {
        int out = 0;
        for (const TimePoint end = m_now + std::chrono::seconds(seconds); m_now < end; m_now += 500ms) {
            if (mavlink)
                m_places.noteMavlink(*m_link, path(), m_now);
            if ((m_now - TimePoint{1h}) % 1s == Duration::zero()) {
                const Second second = update(flown);
                out += second.calls;
                m_requests += second.requests;
            }
        }
        return out;
    }
    Path path() const { return {kLink, m_link->remote()}; }

    NoListener m_listener;
    LinkPool m_links{m_listener, [](link::Link &) {}};
    QUdpSocket m_peer;
    link::Link *m_link = nullptr;
    CallPlaces m_places;
    TimePoint m_now{1h};
    Duration m_turns{}; ///< time between two turns of the address; none: it is called whenever it may be
    TimePoint m_nextTurn = TimePoint::min();
    std::optional<TimePoint> m_called;
    int m_requests = 0;
};

void CallPlacesTest::init()
{
    m_places = {};
    m_now = TimePoint{1h};
    m_turns = {};
    m_nextTurn = TimePoint::min();
    m_called.reset();
    m_requests = 0;
    if (m_peer.state() != QAbstractSocket::BoundState)
        QVERIFY(m_peer.bind(QHostAddress::LocalHost, 0));
    const std::string url = "udpout:127.0.0.1:" + std::to_string(m_peer.localPort());
    m_link = &m_links.open(kLink, *link::LinkUrl::parse(url));
    EVENTUALLY(m_link->remote() != Address{});
    const Bytes greeting{1, 2, 3};
    m_links.send({kLink, {}}, greeting);
    m_links.flush();
    QCOMPARE(m_link->counters().txBlocks, std::uint64_t(1));
}

void CallPlacesTest::mavlinkFromThereMakesCallsRare()
{
    QCOMPARE(callsIn(10), 10);
    QCOMPARE(callsIn(120, true), 4); // every 30 s from the last one on
    QVERIFY(m_places.takeChanged());
    QVERIFY(!m_places.takeChanged());
    QCOMPARE(m_requests, 14); // of a pairing, as often
    callsIn(10);              // The last MAVLink still counts.
    QCOMPARE(callsIn(10), 10);
}

/// Where many addresses take turns, the one in 30 s must not pass while another one has its turn.
void CallPlacesTest::rareCallWaitsForItsTurn()
{
    m_turns = 7s;
    int turns = 0;
    for (int minute = 0; minute < 10; ++minute) {
        for (int second = 0; second < 60; ++second) {
            const auto before = m_called;
            callsIn(1, true);
            turns += m_called != before;
        }
    }
    QVERIFY2(turns >= 16, qPrintable(QString::number(turns))); // every 37 s at the latest
    QVERIFY2(turns <= 20, qPrintable(QString::number(turns)));
}

void CallPlacesTest::forgedMavlinkNeverStopsCalls_data()
{
    QTest::addColumn<int>("every"); // ms
    for (const int every : {100, 999, 5000, 9999, 10001, 10010, 10999, 11500, 29999, 30001})
        QTest::addRow("every %d ms", every) << every;
}

/// At whatever interval frames are forged, also just when the last one is forgotten.
void CallPlacesTest::forgedMavlinkNeverStopsCalls()
{
    QFETCH(int, every);
    int calls = 0;
    TimePoint forged = m_now, second = m_now + 500ms, latest = m_now;
    for (const TimePoint end = m_now + 1h; m_now < end; m_now = std::min(forged, second)) {
        if (m_now == forged) {
            m_places.noteMavlink(*m_link, path(), m_now);
            forged += std::chrono::milliseconds(every);
        }
        if (m_now == second) {
            second += 1s;
            if (!update().calls)
                continue;
            ++calls;
            QVERIFY(m_now - latest <= 31s);
            latest = m_now;
        }
    }
    QVERIFY2(calls >= 115, qPrintable(QString::number(calls)));
}

void CallPlacesTest::mavlinkFromElsewhereDoesNot()
{
    Path other = path();
    ++other.remote.port;
    m_places.noteMavlink(*m_link, other, m_now);
    QCOMPARE(callsIn(10), 10);
    QVERIFY(!m_places.takeChanged());
}

void CallPlacesTest::notWhereAnAgentHadASession()
{
    Path other = path();
    ++other.remote.port;
    m_places.noteSession(*m_link, other);
    QVERIFY(callsIn(20, true) <= 1);
    m_places.noteSession(*m_link, path());
    QCOMPARE(callsIn(20, true), 20);
}

void CallPlacesTest::notWhereAVehicleIsFlownInClear()
{
    QCOMPARE(callsIn(120, true, true), 0);
}

SKYSEAL_TEST(CallPlacesTest)
#include "call_places_test.moc"
