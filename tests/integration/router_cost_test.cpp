// What a frame costs the agent and mavlink-router, each as a whole process (event loop, wake-ups, system calls and cold caches
// included), on the same frames in turn. With SKYSEAL_MAVLINK_ROUTERD naming the program.
#include "tests/engine/bare_end.h"
#include "tests/engine/traffic.h"
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include "core/crypto/init_crypto.h"
#include "core/link/steady_now.h"
#include "core/metrics/process_usage.h"

#include <QtCore/QDeadlineTimer>

#include <algorithm>
#include <cstdio>
#include <functional>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr std::size_t kMeasured = 256; ///< frames of one burst after the other, which can be repeated without a gap

/// A running forwarder between a vehicle's socket and a far end.
class Forwarder
{
public:
    /// `wait` returns when the far end may have received something, at the latest after the time that it is given; `take`
    /// returns the number of frames that the far end has received since.
    Forwarder(qint64 process, quint16 port, std::function<void(Duration)> wait, std::function<std::size_t()> take)
        : m_process(process), m_port(port), m_wait(std::move(wait)), m_take(std::move(take))
    {}

    /// Sends so many frames, `together` at once and the next ones `apart` later. Returns the CPU nanoseconds of the forwarder
    /// for each; nullopt if it lost one.
    std::optional<double> forward(std::size_t frames, std::size_t together, Duration apart)
    {
        m_take();
        const Duration before = *metrics::processCpuTime(m_process);
        std::size_t arrived = 0;
        TimePoint due = steadyNow();
        for (std::size_t sent = 0; sent < frames; sent += together) {
            m_vehicle.send(m_port, std::span(m_traffic.frames()).subspan(sent % kMeasured, together));
            due = std::max(due, steadyNow()) + apart; // frames are never sent later and closer together
            for (TimePoint now = steadyNow(); now < due; now = steadyNow()) {
                m_wait(due - now);
                arrived += m_take();
            }
        }
        const QDeadlineTimer patience(kDeadlineMs);
        while (arrived < frames && !patience.hasExpired()) {
            m_wait(apart);
            arrived += m_take();
        }
        const Duration spent = *metrics::processCpuTime(m_process) - before;
        if (arrived != frames)
            return std::nullopt;
        return seconds(spent) * 1e9 / static_cast<double>(frames);
    }

private:
    qint64 m_process;
    quint16 m_port;
    std::function<void(Duration)> m_wait;
    std::function<std::size_t()> m_take;
    BareSocket m_vehicle;
    Traffic m_traffic{kMeasured};
};

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

class RouterCostTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void aFrameCostsLess_data();
    void aFrameCostsLess();

private:
    QString m_router = qEnvironmentVariable("SKYSEAL_MAVLINK_ROUTERD");
    std::unique_ptr<Flight> m_flight;
    std::unique_ptr<BareEnd> m_ground;
    BareSocket m_behindRouter;
    std::unique_ptr<Program> m_agent, m_routing;
    std::unique_ptr<Forwarder> m_byAgent, m_byRouter;
};

void RouterCostTest::initTestCase()
{
    if (m_router.isEmpty())
        QSKIP("SKYSEAL_MAVLINK_ROUTERD names no mavlink-routerd");
    QVERIFY(crypto::initCrypto());
    m_flight = std::make_unique<Flight>();
    QVERIFY(m_flight->ready());
    auto secrets = engine::readSecretFiles({m_flight->path(QStringLiteral("ground.key")).toStdString(),
                                            m_flight->path(QStringLiteral("ground.peers")).toStdString()});
    QVERIFY(secrets);
    m_ground = std::make_unique<BareEnd>(std::move(*secrets), channel::Role::Station,
                                         channel::Policy{channel::defaultSuites(), false, false});
    QStringList arguments = m_flight->airArguments(m_ground->port());
    arguments.removeAll(QStringLiteral("--json"));
    arguments.removeAll(QStringLiteral("--allow-research"));
    m_agent = std::make_unique<Program>(QStringLiteral("skyseal-air"), arguments);
    QVERIFY(eventually([this] {
        m_ground->pump();
        return m_ground->up();
    }));
    m_byAgent = std::make_unique<Forwarder>(
        m_agent->pid(), m_flight->vehiclePort, [this](Duration most) { m_ground->waitReadable(most); },
        [this] { return m_ground->pump(); });

    const quint16 port = freeUdpPort();
    const QString address = QStringLiteral("127.0.0.1:%1");
    m_routing = std::make_unique<Program>(m_router,
                                          QStringList{QStringLiteral("-t"), QStringLiteral("0"), QStringLiteral("-e"),
                                                      address.arg(m_behindRouter.port()), address.arg(port)});
    m_byRouter = std::make_unique<Forwarder>(
        m_routing->pid(), port, [this](Duration most) { m_behindRouter.waitReadable(most); },
        [this] {
            std::size_t frames = 0;
            while (const std::size_t count = m_behindRouter.receive())
                frames += count;
            return frames;
        });
    BareSocket probe;
    const Traffic one(1);
    QVERIFY(eventually([&] { // until it listens
        probe.send(port, one.frames());
        return m_behindRouter.receive() > 0;
    }));
    for (Forwarder *side : {m_byAgent.get(), m_byRouter.get()}) // the first frames meet addresses that are not known yet
        side->forward(kMeasured, 1, std::chrono::milliseconds(1));
}

void RouterCostTest::aFrameCostsLess_data()
{
    QTest::addColumn<int>("together");
    QTest::addColumn<int>("apartMicroseconds");
    QTest::addRow("one at a time, 100 a second") << 1 << 10'000;
    QTest::addRow("one at a time, 2000 a second") << 1 << 500;
    QTest::addRow("eight at a time, 2000 a second") << 8 << 4'000;
}

/// In rounds of about a second for each of the two, so that both meet the same machine and their own work of each second.
void RouterCostTest::aFrameCostsLess()
{
    QFETCH(int, together);
    QFETCH(int, apartMicroseconds);
    const Duration apart = std::chrono::microseconds(apartMicroseconds);
    const std::size_t frames = static_cast<std::size_t>(together) * static_cast<std::size_t>(1'000'000 / apartMicroseconds);
    const int rounds = qEnvironmentVariableIsSet("SKYSEAL_ROUNDS") ? qEnvironmentVariableIntValue("SKYSEAL_ROUNDS") : 11;
    std::vector<double> agent, router;
    for (int i = 0; i < rounds; ++i) {
        const auto routed = m_byRouter->forward(frames, static_cast<std::size_t>(together), apart);
        QVERIFY2(routed, m_routing->errors());
        router.push_back(*routed);
        const auto sealed = m_byAgent->forward(frames, static_cast<std::size_t>(together), apart);
        QVERIFY2(sealed, m_agent->errors());
        agent.push_back(*sealed);
    }
    const double ratio = median(agent) / median(router);
    std::printf("%s: mavlink-router %.2f us a frame, agent %.2f, ratio %.2f; best %.2f and %.2f\n", QTest::currentDataTag(),
                median(router) / 1000, median(agent) / 1000, ratio, *std::ranges::min_element(router) / 1000,
                *std::ranges::min_element(agent) / 1000);
    QVERIFY2(ratio < 1, qPrintable(QString::number(ratio)));
}

SKYSEAL_TEST(RouterCostTest)
#include "router_cost_test.moc"
