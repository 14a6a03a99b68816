// What a frame costs the agent and mavlink-router, each as a whole process (event loop, wake-ups, system calls and cold caches
// included), on the same frames in turn, and the least programs that seal frames. SKYSEAL_MAVLINK_ROUTERD names the router,
// SKYSEAL_SUITE a suite other than ChaCha20-Poly1305.
#include "tests/engine/bare_end.h"
#include "tests/engine/sample_traffic.h"
#include "tests/support/flight.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include "core/crypto/init_crypto.h"
#include "core/experiment/bare_calls.h"
#include "core/link/steady_now.h"
#include "core/metrics/process_usage.h"

#include <QtCore/QDeadlineTimer>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <functional>

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/prctl.h>
#include <sys/wait.h>

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
    SampleTraffic m_traffic{kMeasured};
};

/// The least work of a forwarder that seals, in a process of its own: receiving, the library's call, sending.
class LeastSealer
{
public:
    enum class Calls : std::uint8_t {
        Poll, ///< epoll_wait, recvfrom and sendto, as for several sockets and addresses
        Block ///< recv that waits, and send, as for one socket and one address
    };

    LeastSealer(crypto::SuiteId suite, std::uint16_t to, Calls calls)
    {
        const experiment::BareCall seal = experiment::bareRecord(suite, experiment::RecordOperation::Seal);
        const int in = socketOfLoopback();
        sockaddr_in address{};
        socklen_t length = sizeof address;
        ::getsockname(in, reinterpret_cast<sockaddr *>(&address), &length);
        m_port = ntohs(address.sin_port);
        m_process = ::fork();
        if (m_process == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);
            address.sin_port = htons(to);
            calls == Calls::Poll ? runPolling(in, address, seal) : runBlocking(in, address, seal);
        }
        ::close(in);
    }
    ~LeastSealer()
    {
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
    }
    LeastSealer(const LeastSealer &) = delete;
    LeastSealer &operator=(const LeastSealer &) = delete;

    qint64 process() const { return m_process; }
    std::uint16_t port() const { return m_port; }

private:
    static int socketOfLoopback()
    {
        const int out = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        sockaddr_in any{};
        any.sin_family = AF_INET;
        any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (out < 0 || ::bind(out, reinterpret_cast<const sockaddr *>(&any), sizeof any) != 0)
            std::abort();
        return out;
    }

    static constexpr std::size_t kOverhead = 22; ///< of a record

    [[noreturn]] static void runPolling(int in, const sockaddr_in &to, const experiment::BareCall &seal)
    {
        const int out = socketOfLoopback(), poll = ::epoll_create1(0);
        epoll_event event{};
        event.events = EPOLLIN;
        ::epoll_ctl(poll, EPOLL_CTL_ADD, in, &event);
        std::array<std::uint8_t, 2048> bytes{};
        for (;;) {
            if (::epoll_wait(poll, &event, 1, -1) != 1)
                continue;
            const ssize_t size = ::recvfrom(in, bytes.data(), bytes.size() - kOverhead, 0, nullptr, nullptr);
            if (size <= 0)
                continue;
            seal(static_cast<std::size_t>(size));
            ::sendto(out, bytes.data(), static_cast<std::size_t>(size) + kOverhead, 0, reinterpret_cast<const sockaddr *>(&to),
                     sizeof to);
        }
    }

    [[noreturn]] static void runBlocking(int in, const sockaddr_in &to, const experiment::BareCall &seal)
    {
        const int out = socketOfLoopback();
        ::fcntl(in, F_SETFL, 0);
        ::connect(out, reinterpret_cast<const sockaddr *>(&to), sizeof to);
        std::array<std::uint8_t, 2048> bytes{};
        for (;;) {
            const ssize_t size = ::recv(in, bytes.data(), bytes.size() - kOverhead, 0);
            if (size <= 0)
                continue;
            seal(static_cast<std::size_t>(size));
            ::send(out, bytes.data(), static_cast<std::size_t>(size) + kOverhead, 0);
        }
    }

    pid_t m_process = -1;
    std::uint16_t m_port = 0;
};

std::size_t datagramsOf(BareSocket &socket)
{
    std::size_t sum = 0;
    while (const std::size_t count = socket.receive())
        sum += count;
    return sum;
}

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
    void costOfAFrame_data();
    void costOfAFrame();

private:
    QString m_router = qEnvironmentVariable("SKYSEAL_MAVLINK_ROUTERD");
    std::unique_ptr<Flight> m_flight;
    std::unique_ptr<BareEnd> m_ground;
    BareSocket m_behindRouter, m_behindLeast;
    std::unique_ptr<LeastSealer> m_polling, m_blocking;
    std::unique_ptr<Program> m_agent, m_routing;
    std::unique_ptr<Forwarder> m_byAgent, m_byRouter, m_byPolling, m_byBlocking;
};

void RouterCostTest::initTestCase()
{
    SKYSEAL_REQUIRES("mavlink_router");
    QVERIFY(crypto::initCrypto());
    const QString suite = qEnvironmentVariable("SKYSEAL_SUITE", QStringLiteral("chacha20-poly1305"));
    const auto suiteId = crypto::suiteFromName(suite.toStdString());
    QVERIFY(suiteId);
    m_polling = std::make_unique<LeastSealer>(*suiteId, m_behindLeast.port(), LeastSealer::Calls::Poll);
    m_blocking = std::make_unique<LeastSealer>(*suiteId, m_behindLeast.port(), LeastSealer::Calls::Block);
    const auto through = [this](const LeastSealer &least) {
        return std::make_unique<Forwarder>(
            least.process(), least.port(), [this](Duration most) { m_behindLeast.waitReadable(most); },
            [this] { return datagramsOf(m_behindLeast); });
    };
    m_byPolling = through(*m_polling);
    m_byBlocking = through(*m_blocking);
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
    arguments << QStringLiteral("--suites") << suite;
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
        [this] { return datagramsOf(m_behindRouter); });
    BareSocket probe;
    const SampleTraffic one(1);
    QVERIFY(eventually([&] { // until it listens
        probe.send(port, one.frames());
        return m_behindRouter.receive() > 0;
    }));
    for (Forwarder *side : {m_byAgent.get(), m_byRouter.get(), m_byPolling.get(), m_byBlocking.get()})
        side->forward(kMeasured, 1, std::chrono::milliseconds(1)); // the first frames meet addresses that are not known yet
}

void RouterCostTest::costOfAFrame_data()
{
    QTest::addColumn<int>("together");
    QTest::addColumn<int>("apartMicroseconds");
    QTest::addColumn<double>("most"); // of the agent, relative to the router: as measured at -O1, with a margin for noise
    QTest::addRow("one at a time, 100 a second") << 1 << 10'000 << 3.2;
    QTest::addRow("one at a time, 2000 a second") << 1 << 500 << 2.2;
    QTest::addRow("eight at a time, 2000 a second") << 8 << 4'000 << 1.5;
}

/// In rounds of about a second for each, so that all meet the same machine and their own work of each second.
void RouterCostTest::costOfAFrame()
{
    QFETCH(int, together);
    QFETCH(int, apartMicroseconds);
    QFETCH(double, most);
    const Duration apart = std::chrono::microseconds(apartMicroseconds);
    const std::size_t frames = static_cast<std::size_t>(together) * static_cast<std::size_t>(1'000'000 / apartMicroseconds);
    const int rounds = qEnvironmentVariableIsSet("SKYSEAL_ROUNDS") ? qEnvironmentVariableIntValue("SKYSEAL_ROUNDS") : 11;
    std::vector<double> agent, router, polling, blocking;
    for (int i = 0; i < rounds; ++i) {
        const auto routed = m_byRouter->forward(frames, static_cast<std::size_t>(together), apart);
        QVERIFY2(routed, m_routing->errors());
        router.push_back(*routed);
        const auto sealed = m_byAgent->forward(frames, static_cast<std::size_t>(together), apart);
        QVERIFY2(sealed, m_agent->errors());
        agent.push_back(*sealed);
        for (const auto &[side, costs] : {std::pair{m_byPolling.get(), &polling}, std::pair{m_byBlocking.get(), &blocking}}) {
            const auto bare = side->forward(frames, static_cast<std::size_t>(together), apart);
            QVERIFY(bare);
            costs->push_back(*bare);
        }
    }
    const double ratio = median(agent) / median(router);
    std::printf("%s: mavlink-router %.2f us a frame, agent %.2f, ratio %.2f; the least programs that seal: %.2f with epoll, "
                "%.2f with a recv that waits\n",
                QTest::currentDataTag(), median(router) / 1000, median(agent) / 1000, ratio, median(polling) / 1000,
                median(blocking) / 1000);
    QVERIFY2(ratio < most, qPrintable(QString::number(ratio)));
}

SKYSEAL_TEST(RouterCostTest)
#include "router_cost_test.moc"
