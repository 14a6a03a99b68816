// A flood of each kind of message that a stranger can send, 20,000 first messages or 50,000 others a second, against a real
// agent, and its effect on a legitimate session. Telemetry passes the agent all the time, seconds with and without the flood
// alternate, and the two are compared within one run. Nothing else should run beside it. SKYSEAL_FLOOD_SECONDS makes the flood
// last that long without a pause, between two quiet periods.
#include "core/crypto/init_crypto.h"
#include "core/link/steady_now.h"
#include "tests/engine/bare_end.h"
#include "tests/engine/sample_traffic.h"
#include "tests/support/flight.h"
#include "tests/support/stranger_messages.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <atomic>
#include <cstdio>
#include <iterator>
#include <random>
#include <string_view>
#include <thread>

#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

/// A second of them: 50,000, or 20,000 first messages.
std::vector<Bytes> aSecondOf(const StrangerMessage &message, const StrangersKnowledge &knows)
{
    std::mt19937_64 random(3);
    const bool isFirst = std::string_view(message.name).starts_with("first");
    std::vector<Bytes> out;
    for (int i = 0; i < (isFirst ? 20'000 : 50'000); ++i)
        out.push_back(message.make(knows, random));
    return out;
}

/// Sends all of `datagrams` each second, again and again, to one port from a thread of its own, while it is switched on.
class Flood
{
public:
    Flood(std::uint16_t port, std::vector<Bytes> datagrams)
        : m_datagrams(std::move(datagrams)), m_thread([this, port] { run(port); })
    {}
    ~Flood()
    {
        m_ends = true;
        m_thread.join();
    }
    void set(bool on) { m_on = on; }
    std::uint64_t sent() const { return m_sent; }

private:
    /// The interval of the flood.
    static void waitUntil(TimePoint due)
    {
        const Duration left = due - steadyNow();
        const timespec time{0, static_cast<long>(left.count())};
        if (left > Duration())
            ::ppoll(nullptr, 0, &time, nullptr);
    }

    void run(std::uint16_t port)
    {
        // It represents another machine and must not use CPU time of the agent.
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10);
        BareSocket socket;
        const std::vector<ByteView> views(m_datagrams.begin(), m_datagrams.end());
        // In small batches: a send call is not interrupted, and the measured process may wait for this processor.
        const std::size_t atOnce = (views.size() + 3999) / 4000;
        std::size_t next = 0;
        for (TimePoint due = steadyNow(); !m_ends; due += 250us) {
            // Cookies are not read, as by a sender with a forged address: reading them would take CPU time from the agent.
            waitUntil(due);
            if (!m_on) {
                due = steadyNow();
                continue;
            }
            socket.send(port, std::span(views).subspan(next, atOnce));
            next = (next + atOnce) % (views.size() / atOnce * atOnce);
            m_sent += atOnce;
        }
    }

    const std::vector<Bytes> m_datagrams;
    std::atomic<bool> m_on{false}, m_ends{false};
    std::atomic<std::uint64_t> m_sent{0};
    std::thread m_thread;
};

std::size_t residentBytes(qint64 pid)
{
    unsigned long size = 0, resident = 0;
    std::FILE *file = std::fopen(qPrintable(QStringLiteral("/proc/%1/statm").arg(pid)), "r");
    if (!file || std::fscanf(file, "%lu %lu", &size, &resident) != 2)
        return 0;
    std::fclose(file);
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// When the flood is on, in seconds of equal share or around one long time.
std::vector<std::pair<Duration, bool>> phases(int longSeconds)
{
    if (longSeconds > 0)
        return {{15s, false}, {std::chrono::seconds(longSeconds), true}, {15s, false}};
    std::vector<std::pair<Duration, bool>> out;
    for (int second = 0; second < 20; ++second)
        out.emplace_back(1s, second % 2 == 1);
    return out;
}

double percentile(std::vector<double> values, double share)
{
    std::sort(values.begin(), values.end());
    return values.empty() ? 0 : values[static_cast<std::size_t>(static_cast<double>(values.size() - 1) * share)];
}

} // namespace

class FloodLatencyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void legitimateSessionDoesNotFeelIt_data();
    void legitimateSessionDoesNotFeelIt();
};

void FloodLatencyTest::legitimateSessionDoesNotFeelIt_data()
{
    QTest::addColumn<int>("message");
    for (std::size_t i = 0; i < std::size(kStrangerMessages); ++i)
        QTest::newRow(kStrangerMessages[i].name) << static_cast<int>(i);
}

void FloodLatencyTest::legitimateSessionDoesNotFeelIt()
{
    QFETCH(int, message);
    QVERIFY(crypto::initCrypto());
    Flight flight;
    QVERIFY(flight.ready());
    Introduced keys;
    const auto load = [&](const QString &name) {
        const auto secrets = engine::readSecretFiles({flight.path(name + QStringLiteral(".key")).toStdString(),
                                                      flight.path(name + QStringLiteral(".peers")).toStdString()});
        return secrets ? (*secrets)->identity : nullptr;
    };
    keys.ground = load(QStringLiteral("ground"));
    keys.air = load(QStringLiteral("air"));
    QVERIFY(keys.ground && keys.air);
    BareEnd ground(keys, channel::Role::Station, {channel::defaultSuites(), false, false});
    flight.groundPort = ground.port();
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    QVERIFY(!air.waitFor(QStringLiteral("link")).isEmpty());
    for (const TimePoint stop = steadyNow() + 10s; !ground.up() && steadyNow() < stop; ground.pump())
        ground.waitReadable(10);
    QVERIFY(ground.up());
    const std::uint16_t agentPort = ground.sessionInfo().path.remote.port;

    BareSocket vehicle;
    const SampleTraffic telemetry(256);
    // The agent considers a session up only after its first record; frames of the vehicle before that are dropped.
    std::size_t through = 0;
    for (const TimePoint stop = steadyNow() + 10s; through == 0 && steadyNow() < stop; through = ground.pump()) {
        const std::array<ByteView, 1> frame{telemetry.frames()[0]};
        vehicle.send(flight.vehiclePort, frame);
        ground.waitReadable(20);
    }
    QVERIFY(through > 0);
    const StrangersKnowledge knows{publicKeyOf(*keys.air), publicKeyOf(*keys.ground), ground.seal(telemetry.frames()[0])};
    QVERIFY(!knows.record.empty());
    std::vector<Bytes> datagrams = aSecondOf(kStrangerMessages[message], knows);
    const auto perSecond = static_cast<double>(datagrams.size());
    Flood flood(agentPort, std::move(datagrams));
    std::vector<double> quiet, flooded;
    std::size_t next = 0, lost = 0, before = 0;
    double floodSeconds = 0;
    for (const auto &[length, on] : phases(qEnvironmentVariableIntValue("SKYSEAL_FLOOD_SECONDS"))) {
        flood.set(on);
        floodSeconds += on ? seconds(length) : 0;
        const TimePoint stop = steadyNow() + length, settled = steadyNow() + 100ms;
        while (steadyNow() < stop) {
            const std::array<ByteView, 1> frame{telemetry.frames()[next++ % 256]};
            const TimePoint sent = steadyNow();
            vehicle.send(flight.vehiclePort, frame);
            std::size_t got = 0;
            while (got == 0 && steadyNow() < sent + 200ms) {
                ground.waitReadable(5);
                got = ground.pump();
            }
            const Duration took = steadyNow() - sent;
            lost += got == 0;
            if (got > 0 && sent > settled)
                (on ? flooded : quiet).push_back(seconds(took) * 1e6);
            while (steadyNow() < sent + 4ms)
                ground.waitReadable(1), ground.pump();
            if (before == 0 && flood.sent() > static_cast<std::uint64_t>(1.5 * perSecond))
                before = residentBytes(air.pid());
        }
    }
    flood.set(false);
    const std::size_t after = residentBytes(air.pid());
    const double p99Quiet = percentile(quiet, 0.99), p99Flooded = percentile(flooded, 0.99);
    qInfo("%s: flood of %.0f a second; latency p50 %.0f us quiet, %.0f us flooded; p99 %.0f us quiet, %.0f us flooded (x "
          "%.2f); "
          "lost %zu of %zu; resident %zu kB, then %zu kB",
          QTest::currentDataTag(), static_cast<double>(flood.sent()) / floodSeconds, percentile(quiet, 0.5),
          percentile(flooded, 0.5), p99Quiet, p99Flooded, p99Flooded / p99Quiet, lost, next, before / 1024, after / 1024);
    if (std::string_view(kStrangerMessages[message].name).starts_with("record of the session")) { // each came as far as its tag
        const auto judged = [&flood](const QJsonObject &stats) {
            const QJsonObject received = stats[QLatin1String("channel")].toObject()[QLatin1String("rx")].toObject();
            return received[QLatin1String("forged")].toDouble() >= 0.95 * static_cast<double>(flood.sent());
        };
        QVERIFY(!air.waitFor(QStringLiteral("stats"), judged).isEmpty());
    }
    QVERIFY(static_cast<double>(flood.sent()) >= 0.95 * perSecond * floodSeconds);
    QVERIFY(p99Flooded <= 2 * p99Quiet);
    QVERIFY(after <= before + 512 * 1024);
    QCOMPARE(lost, std::size_t(0));
}

SKYSEAL_TEST(FloodLatencyTest)
#include "flood_latency_test.moc"
