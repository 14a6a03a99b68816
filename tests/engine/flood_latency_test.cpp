// A flood of handshake messages against a real agent, 20,000 a second: what a legitimate session feels of it. Telemetry goes
// through the agent all the while, seconds with and without the flood take turns, and the two are compared within this one
// run. Nothing else should run beside it.
#include "core/channel/handshake.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/secret_file.h"
#include "core/link/steady_now.h"
#include "tests/engine/bare_end.h"
#include "tests/engine/traffic.h"
#include "tests/support/flight.h"

#include <QtTest/QTest>

#include <atomic>
#include <cstdio>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr int kFloodPerMillisecond = 20;

/// First messages to one port from a thread of its own, while it is switched on.
class Flood
{
public:
    Flood(std::uint16_t port, const channel::PublicKey *knownKey) : m_thread([this, port, knownKey] { run(port, knownKey); })
    {
    }
    ~Flood()
    {
        m_ends = true;
        m_thread.join();
    }
    void set(bool on) { m_on = on; }
    std::uint64_t sent() const { return m_sent; }

private:
    void run(std::uint16_t port, const channel::PublicKey *knownKey)
    {
        // It stands for another machine: the making of the messages, and its place on the processor, are not the agent's to pay.
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10);
        BareSocket socket;
        crypto::SystemRandom random;
        std::vector<channel::FirstMessage> messages(1000 * kFloodPerMillisecond);
        for (auto &message : messages) {
            random.fill(message);
            message[0] = channel::firstByte(channel::HandshakeMessage::First);
            if (knownKey)
                channel::Mac1(*knownKey).sign(message);
        }
        const std::vector<ByteView> views(messages.begin(), messages.end());
        std::size_t next = 0;
        for (TimePoint due = steadyNow(); !m_ends; due += 1ms) {
            while (steadyNow() < due) {
                if (socket.waitReadable(1))
                    socket.receive(); // cookies, which nobody brings back
            }
            if (!m_on) {
                due = steadyNow();
                continue;
            }
            socket.send(port, std::span(views).subspan(next, kFloodPerMillisecond));
            next = (next + kFloodPerMillisecond) % views.size();
            m_sent += kFloodPerMillisecond;
        }
    }

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
    QTest::addColumn<bool>("keyIsKnown");
    QTest::newRow("from who does not know the agent's key") << false;
    QTest::newRow("from who knows it") << true;
}

void FloodLatencyTest::legitimateSessionDoesNotFeelIt()
{
    QFETCH(bool, keyIsKnown);
    QVERIFY(crypto::initCrypto());
    Flight flight;
    QVERIFY(flight.ready());
    Introduced keys;
    const auto load = [&](const char *name) {
        return std::make_shared<const crypto::X25519KeyPair>(
            *keys::loadIdentity(flight.path(QLatin1String(name)).toStdString()));
    };
    keys.ground = load("ground.key");
    keys.air = load("air.key");
    BareEnd ground(keys, channel::Role::Station, {channel::defaultSuites(), false, false});
    flight.groundPort = ground.port();
    Program air(QStringLiteral("skyseal-air"), flight.airArguments());
    QVERIFY(!air.waitFor(QStringLiteral("link"), 10000).isEmpty());
    for (const TimePoint stop = steadyNow() + 10s; !ground.up() && steadyNow() < stop; ground.pump())
        ground.waitReadable(10);
    QVERIFY(ground.up());
    const std::uint16_t agentPort = ground.endpoint().sessionInfo(ground.session())->path.remote.port;

    BareSocket vehicle;
    const Traffic telemetry(256);
    // The agent takes a session for up only once it heard a record; what its vehicle says before is for nobody.
    std::size_t through = 0;
    for (const TimePoint stop = steadyNow() + 10s; through == 0 && steadyNow() < stop; through = ground.pump()) {
        const std::array<ByteView, 1> frame{telemetry.frames()[0]};
        vehicle.send(flight.vehiclePort, frame);
        ground.waitReadable(20);
    }
    QVERIFY(through > 0);
    Flood flood(agentPort, keyIsKnown ? &keys.air->publicKey : nullptr);
    std::vector<double> quiet, flooded;
    std::size_t next = 0, lost = 0, before = 0;
    for (int second = 0; second < 20; ++second) {
        const bool on = second % 2 == 1;
        flood.set(on);
        const TimePoint stop = steadyNow() + 1s, settled = steadyNow() + 100ms;
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
        }
        if (second == 3)
            before = residentBytes(air.pid());
    }
    flood.set(false);
    const std::size_t after = residentBytes(air.pid());
    const double p99Quiet = percentile(quiet, 0.99), p99Flooded = percentile(flooded, 0.99);
    qInfo("%s: flood of %.0f a second; latency p50 %.0f us quiet, %.0f us flooded; p99 %.0f us quiet, %.0f us flooded (x "
          "%.2f); "
          "lost %zu of %zu; resident %zu kB, then %zu kB",
          QTest::currentDataTag(), static_cast<double>(flood.sent()) / 10, percentile(quiet, 0.5), percentile(flooded, 0.5),
          p99Quiet, p99Flooded, p99Flooded / p99Quiet, lost, next, before / 1024, after / 1024);
    QVERIFY(flood.sent() >= 190'000);
    QVERIFY(p99Flooded <= 2 * p99Quiet);
    QVERIFY(after <= before + 512 * 1024);
    QCOMPARE(lost, std::size_t(0));
}

QTEST_GUILESS_MAIN(FloodLatencyTest)
#include "flood_latency_test.moc"
