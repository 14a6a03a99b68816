// The log protocol against a small server, clean and through a radio that drops, and against hostile answers.
#include "core/vehicle/log_client.h"
#include "kept_sink.h"
#include "transfer_measure.h"
#include "tests/support/test_runner.h"

#include <rapidcheck.h>

#include <map>

using namespace skyseal;
using namespace skyseal::vehicle;

class OnboardLogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void logsAreListed();
    void logIsReadWhateverItsSize();
    void missingLogIsAFailure();
    void logThatEndsBeforeItsListedSize();
    void logsAreErased();
    void silentVehicleIsGivenUp();
    void transferIsCancelled();
    void lostLinkIsNotFlooded();
    void logGoesOn_data();
    void logGoesOn();
    void otherLogStartsAnew_data();
    void otherLogStartsAnew();
    void everythingArrivesThroughABadRadio_data();
    void everythingArrivesThroughABadRadio();
    void lossCostsLittleTime_data();
    void lossCostsLittleTime();
    void anyDataIsBounded();
};

namespace {

/// Sends lists and data at a steady pace. Each request for data is answered in turn; that of PX4 replaces the one before.
class LogPeer : public ScriptedPeer
{
public:
    static constexpr Duration kInterval = std::chrono::microseconds(500); ///< between messages of data

    std::map<std::uint16_t, Bytes> logs;
    std::uint32_t listedMore = 0; ///< logs are listed so much larger than they are
    bool erases = true;
    bool isPx4 = false;
    /// PX4 serves a request at most so often (MavlinkReceiver::run()), then as much as its radio has taken in between.
    Duration cycle = kInterval;
    int ends = 0;     ///< LOG_REQUEST_END that have come
    int requests = 0; ///< for data
    std::size_t bytesSent = 0;
    std::uint32_t time = 0; ///< of all logs

    void handle(TimePoint now, const OutMessage &message, std::vector<ToStation> &out) override
    {
        if (const auto list = as<mavlink::LogRequestList>(message)) {
            mavlink::LogEntry entry;
            entry.num_logs = static_cast<std::uint16_t>(logs.size());
            const std::uint16_t last = logs.empty() ? std::uint16_t(0) : logs.rbegin()->first;
            entry.last_log_num = std::min(list->end, last);
            if (logs.empty())
                out.push_back(send(entry));
            for (const auto &[id, content] : logs) {
                entry.id = id;
                entry.size = static_cast<std::uint32_t>(content.size()) + listedMore;
                entry.time_utc = time;
                if (id >= list->start && id <= list->end)
                    out.push_back(send(entry));
            }
            if (isPx4 && !logs.empty() && list->start > last) {
                entry.id = last; // clamped
                out.push_back(send(entry));
            } else if (!logs.empty() && list->start > last) {
                entry.size = 0;
                for (std::uint16_t i = 0; i < 100; ++i) { // ArduPilot goes on to the greatest number, and from 0
                    entry.id = static_cast<std::uint16_t>(list->start + i);
                    out.push_back(send(entry));
                }
            }
        }
        if (const auto data = as<mavlink::LogRequestData>(message)) {
            ++requests;
            if (isPx4)
                m_runs.clear();
            m_runs.push_back(*data);
            m_due = std::min(m_due, std::max(now, m_served + cycle));
        }
        if (as<mavlink::LogErase>(message) && erases)
            logs.clear();
        if (as<mavlink::LogRequestEnd>(message)) {
            m_runs.clear();
            ++ends;
        }
    }

    void handleDeadline(TimePoint now, std::vector<ToStation> &out) override
    {
        m_served = now;
        for (Duration sent{}; sent < cycle && !m_runs.empty(); sent += kInterval)
            sendData(out);
        m_due = m_runs.empty() ? kNever : now + cycle;
    }
    TimePoint nextDeadline() const override { return m_due; }

private:
    void sendData(std::vector<ToStation> &out)
    {
        mavlink::LogRequestData &run = m_runs.front();
        const Bytes &content = logs[run.id];
        mavlink::LogData data;
        data.id = run.id;
        data.ofs = run.ofs;
        const std::size_t rest = run.ofs < content.size() ? content.size() - run.ofs : 0;
        data.count = static_cast<std::uint8_t>(std::min<std::size_t>({90, run.count, rest}));
        std::copy_n(content.begin() + static_cast<std::ptrdiff_t>(content.size() - rest), data.count, data.data.begin());
        out.push_back(send(data));
        bytesSent += data.count;
        run.ofs += 90;
        run.count -= std::min<std::uint32_t>(run.count, 90);
        if (run.count == 0 || data.count < 90)
            m_runs.erase(m_runs.begin());
    }

    std::vector<mavlink::LogRequestData> m_runs;
    TimePoint m_served{};
    TimePoint m_due = kNever;
};

} // namespace

void OnboardLogTest::logsAreListed()
{
    Harness h = Harness::copter();
    LogPeer peer;
    LossyLink link(h, peer, 0, 1);
    QVERIFY(resultOf<LogResult>(h, link, ListLogs{}).entries->empty());
    for (std::uint16_t id = 3; id < 30; ++id)
        peer.logs[id] = noise(id);
    const LogResult result = resultOf<LogResult>(h, link, ListLogs{});
    QVERIFY2(result.ok, result.reason.text().c_str());
    QCOMPARE(result.entries->size(), std::size_t(27));
    QCOMPARE((*result.entries)[0], (OnboardLog{3, 3, 0}));
}

void OnboardLogTest::logIsReadWhateverItsSize()
{
    for (const std::size_t size : {std::size_t(0), std::size_t(1), LogClient::kChunk, LogClient::kChunk * LogClient::kPiece,
                                   LogClient::kChunk * LogClient::kPiece + 1, std::size_t(250'000)}) {
        Harness h = Harness::copter();
        LogPeer peer;
        peer.logs[4] = noise(size);
        LossyLink link(h, peer, 0, 1);
        const LogResult result = resultOf<LogResult>(h, link, ReadLog{4});
        QVERIFY2(result.ok, result.reason.text().c_str());
        QCOMPARE(*result.content, peer.logs[4]);
    }
}

void OnboardLogTest::missingLogIsAFailure()
{
    Harness h = Harness::copter();
    LogPeer peer;
    peer.logs[4] = noise(100);
    LossyLink link(h, peer, 0, 1);
    for (const bool isPx4 : {false, true}) {
        peer.isPx4 = isPx4;
        peer.ends = 0;
        const TimePoint begin = h.now;
        QCOMPARE(resultOf<LogResult>(h, link, ReadLog{9}).reason.text(), std::string("the vehicle has no such log"));
        QVERIFY(h.now < begin + std::chrono::seconds(1));
        link.run(std::chrono::milliseconds(100), [] { return false; });
        QCOMPARE(peer.ends, 1); // what else comes is not wanted
    }
    h.sent();
    QCOMPARE(resultOf<LogResult>(h, link, ReadLog{0}).reason.text(),
             std::string("the vehicle has no such log")); // ArduPilot counts from 1
    peer.logs.clear();                                    // of a vehicle that is silent about a log that it does not have
    h.vehicle.perform(h.now, RequestId{1}, ReadLog{9});
    QCOMPARE(h.sentOf<mavlink::LogRequestList>().at(0).start, std::uint16_t(9));
    const auto whole = h.nextSent<mavlink::LogRequestList>(h.now + std::chrono::seconds(3));
    QVERIFY(whole && whole->second.start == 0 && whole->second.end == 0xFFFF);
}

void OnboardLogTest::logThatEndsBeforeItsListedSize()
{
    for (const std::size_t size : {std::size_t(900), std::size_t(905)}) {
        Harness h = Harness::copter();
        LogPeer peer;
        peer.listedMore = 5000;
        peer.logs[4] = noise(size);
        LossyLink link(h, peer, 0.1, 2);
        const LogResult result = resultOf<LogResult>(h, link, ReadLog{4});
        QVERIFY2(result.ok, result.reason.text().c_str());
        QCOMPARE(*result.content, peer.logs[4]);
    }
}

void OnboardLogTest::logsAreErased()
{
    Harness h = Harness::copter();
    LogPeer peer;
    peer.logs[1] = noise(100);
    LossyLink link(h, peer, 0, 1);
    QVERIFY(resultOf<LogResult>(h, link, EraseLogs{}).ok);
    QVERIFY(peer.logs.empty());
    peer.logs[1] = noise(100);
    peer.erases = false;
    const LogResult result = resultOf<LogResult>(h, link, EraseLogs{});
    QVERIFY(!result.ok && result.changeUnanswered);
}

void OnboardLogTest::silentVehicleIsGivenUp()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ListLogs{});
    h.runUntil(h.now + std::chrono::seconds(60));
    const std::size_t requests = h.sentOf<mavlink::LogRequestList>().size();
    QVERIFY2(requests >= 4 && requests <= 10, std::to_string(requests).c_str());
    QCOMPARE(h.poll<LogResult>()->reason.text(), std::string("the vehicle does not list its logs"));
    QVERIFY(!h.poll<LogResult>());
}

void OnboardLogTest::transferIsCancelled()
{
    Harness h = Harness::copter();
    h.vehicle.perform(h.now, RequestId{1}, ReadLog{4});
    h.feed(mavlink::LogEntry{.id = 4, .num_logs = 4, .last_log_num = 4, .time_utc = 0, .size = 1000});
    h.sent();
    h.vehicle.perform(h.now, RequestId{2}, ListLogs{});
    QCOMPARE(h.poll<LogResult>()->reason.text(), std::string("another request for logs is under way"));
    h.vehicle.perform(h.now, RequestId{3}, CancelTransfer{RequestId{1}});
    const auto result = h.poll<LogResult>();
    QVERIFY(result && result->id == RequestId{1} && result->reason.text() == "cancelled");
    QCOMPARE(h.sentOf<mavlink::LogRequestEnd>().size(), std::size_t(1));
}

void OnboardLogTest::lostLinkIsNotFlooded()
{
    Harness h = Harness::px4();
    LogPeer peer;
    peer.isPx4 = true;
    peer.logs[4] = noise(500'000);
    LossyLink link(h, peer, 0.1, 1);
    // While it is being steered.
    link.addOutage(h.now + std::chrono::seconds(4), h.now + std::chrono::seconds(60), LossyLink::Direction::Down);
    h.vehicle.perform(h.now, RequestId{1}, ReadLog{4});
    link.run(std::chrono::seconds(4), [] { return false; });
    const int before = peer.requests;
    QVERIFY(before > 10);
    std::optional<LogResult> result;
    QVERIFY(link.run(std::chrono::seconds(60), [&] { return (result = h.poll<LogResult>()).has_value(); }));
    QVERIFY2(result->reason.text().find("does not send byte") != std::string::npos, result->reason.text().c_str());
    QVERIFY2(peer.requests - before < 150, std::to_string(peer.requests - before).c_str());
}

void OnboardLogTest::logGoesOn_data()
{
    QTest::addColumn<bool>("isPx4");
    QTest::addColumn<double>("share"); // of the journal that is there
    for (const double share : {0.3, 0.95, 1.}) {
        QTest::addRow("ArduPilot, %.2f", share) << false << share;
        QTest::addRow("PX4, %.2f", share) << true << share;
    }
}

void OnboardLogTest::logGoesOn()
{
    QFETCH(bool, isPx4);
    QFETCH(double, share);
    constexpr std::size_t kSize = LogClient::kChunk * LogClient::kPiece + 100'005; // two pieces
    LogPeer peer;
    peer.isPx4 = isPx4;
    peer.time = 1'700'000'000;
    peer.logs[4] = noise(kSize);
    const auto sink = std::make_shared<JournalSink>();
    TimePoint now = at(100);
    std::size_t sent = 0;
    const auto read = [&](double loss, std::shared_ptr<const KeptPart> kept) { // another program each time
        Harness h = isPx4 ? Harness::px4() : Harness::copter();
        h.now = now;
        LossyLink link(h, peer, loss, 3);
        peer.bytesSent = 0;
        const LogResult out = resultOf<LogResult>(h, link, ReadLog{4, std::move(kept), sink});
        sent = peer.bytesSent;
        link.run(std::chrono::seconds(5), [] { return false; }); // a PX4 that has not heard of the end goes on
        now = h.now + std::chrono::seconds(1);
        return out;
    };
    QVERIFY(read(0.1, nullptr).ok);
    if (share < 1)
        sink->journal.resize(static_cast<std::size_t>(share * static_cast<double>(sink->journal.size())));
    const auto kept = sink->kept();
    sink->journal.resize(kept->journalSize);
    const std::size_t missing = kSize - bytesIn(*kept);
    const LogResult result = read(0, kept);
    QVERIFY2(result.ok, result.reason.text().c_str());
    QCOMPARE(*result.content, peer.logs[4]);
    QCOMPARE(bytesIn(*sink->kept()), kSize);
    // A PX4 sends the chunks between the lost ones as well.
    QVERIFY2(sent >= missing && sent <= missing + kSize / 3, std::to_string(sent).c_str());
    QCOMPARE(sent == 0, share == 1.);
}

void OnboardLogTest::otherLogStartsAnew_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<quint32>("time");
    QTest::newRow("other size") << 50'001 << 1'700'000'000u;
    QTest::newRow("other time") << 50'000 << 1'700'000'001u;
    QTest::newRow("unknown time") << 50'000 << 0u;
}

void OnboardLogTest::otherLogStartsAnew()
{
    QFETCH(int, size);
    QFETCH(quint32, time);
    Harness h = Harness::copter();
    LogPeer peer;
    LossyLink link(h, peer, 0, 1);
    peer.time = time == 0 ? 0 : 1'700'000'000;
    peer.logs[4] = noise(50'000);
    const auto sink = std::make_shared<JournalSink>();
    QVERIFY(resultOf<LogResult>(h, link, ReadLog{4, nullptr, sink}).ok);
    peer.time = time;
    peer.logs[4] = noise(static_cast<std::size_t>(size), 2);
    const LogResult glued = resultOf<LogResult>(h, link, ReadLog{4, sink->kept(), sink});
    QVERIFY(!glued.ok && glued.unfit && !glued.content);
    const LogResult anew = resultOf<LogResult>(h, link, ReadLog{4, nullptr, sink});
    QVERIFY2(anew.ok, anew.reason.text().c_str());
    QCOMPARE(*anew.content, peer.logs[4]);
}

void OnboardLogTest::everythingArrivesThroughABadRadio_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("seed");
    QTest::addColumn<bool>("isPx4");
    for (int seed = 1; seed <= 25; ++seed) {
        for (const double loss : {0.1, 0.25}) {
            QTest::addRow("ArduPilot, loss %.2f, seed %d", loss, seed) << loss << seed << false;
            QTest::addRow("PX4, loss %.2f, seed %d", loss, seed) << loss << seed << true;
        }
    }
}

void OnboardLogTest::everythingArrivesThroughABadRadio()
{
    QFETCH(double, loss);
    QFETCH(int, seed);
    QFETCH(bool, isPx4);
    Harness h = isPx4 ? Harness::px4() : Harness::copter();
    LogPeer peer;
    peer.isPx4 = isPx4;
    for (std::uint16_t id = 1; id < 10; ++id)
        peer.logs[id] = noise(id * 20'000u);
    LossyLink link(h, peer, loss, static_cast<unsigned>(seed));
    QCOMPARE(resultOf<LogResult>(h, link, ListLogs{}).entries->size(), std::size_t(9));
    const LogResult result = resultOf<LogResult>(h, link, ReadLog{9});
    QVERIFY2(result.ok, result.reason.text().c_str());
    QCOMPARE(*result.content, peer.logs[9]);
}

void OnboardLogTest::lossCostsLittleTime_data()
{
    QTest::addColumn<bool>("isPx4");
    QTest::addColumn<Duration>("cycle");
    QTest::addColumn<double>("tenth"); // the most at 10 % loss, in times of the clean one
    QTest::addColumn<double>("quarter");
    QTest::newRow("ArduPilot") << false << LogPeer::kInterval << 2. << 3.;
    QTest::newRow("PX4, one run at a time") << true << LogPeer::kInterval << 2. << 3.;
    // So fast a radio waits for its requests, each of which brings 20 chunks from a lost one on: of 5556 chunks, of which a
    // quarter is lost again and again, 278 + 241 + 159 + 67 + 22 + 7 stretches of 10 ms, 2.7 times the clean time, besides
    // requests of which both copies are lost.
    QTest::newRow("PX4, one run every 10 ms") << true << Duration(std::chrono::milliseconds(10)) << 2. << 3.;
}

void OnboardLogTest::lossCostsLittleTime()
{
    QFETCH(bool, isPx4);
    QFETCH(Duration, cycle);
    QFETCH(double, tenth);
    QFETCH(double, quarter);
    const auto timeToRead = [isPx4, cycle](double loss, unsigned seed) {
        Harness h = isPx4 ? Harness::px4() : Harness::copter();
        LogPeer peer;
        peer.isPx4 = isPx4;
        peer.cycle = cycle;
        peer.logs[4] = noise(500'000);
        LossyLink link(h, peer, loss, seed, std::chrono::milliseconds(25));
        const TimePoint begin = h.now;
        const LogResult result = resultOf<LogResult>(h, link, ReadLog{4});
        return result.ok && *result.content == peer.logs[4] ? seconds(h.now - begin) : 600.;
    };
    const double clean = timeToRead(0, 1);
    verifyCostOfLoss(timeToRead, clean, tenth, quarter);
}

void OnboardLogTest::anyDataIsBounded()
{
    QVERIFY(rc::check("every read ends, and keeps no more than was listed", [] {
        Harness h = Harness::copter();
        h.vehicle.perform(h.now, RequestId{1}, ReadLog{4});
        const auto size = *rc::gen::element<std::uint32_t>(0, 1, 90, 1000, 200'000, 0xFFFFFFFF);
        h.feed(mavlink::LogEntry{.id = 4, .num_logs = 1, .last_log_num = 4, .time_utc = 0, .size = size});
        std::optional<LogResult> result = h.poll<LogResult>();
        for (int i = 0; i < 100 && !result; ++i) {
            mavlink::LogData data;
            data.id = *rc::gen::element<std::uint16_t>(4, 4, 4, 5);
            data.ofs = *rc::gen::element<std::uint32_t>(0, 90, 180, 45, 91'980, 92'160, 0xFFFFFFFF);
            data.count = *rc::gen::element<std::uint8_t>(0, 1, 89, 90, 255);
            h.feed(data);
            h.sent();
            result = h.poll<LogResult>();
        }
        const TimePoint end = h.now + std::chrono::minutes(5);
        while (!result && h.now < end) {
            h.runUntil(h.now + std::chrono::seconds(1));
            h.sent();
            result = h.poll<LogResult>();
        }
        RC_ASSERT(result.has_value());
        RC_ASSERT((!result->content || result->content->size() <= size));
    }));
}

SKYSEAL_TEST_APPLESS(OnboardLogTest)
#include "onboard_log_test.moc"
