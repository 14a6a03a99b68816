// A thousand frames a second through vehicle, agent, gateway, stations and broker, while each of them is killed or asked to
// end, stops for a while, changes its address, and while garbage arrives and the link is cut. After each disturbance
// everything works again; while there is none, or one that concerns others, the client receives every frame as it was sent.
// Prints its seed, and what it measured.
#include "tests/integration/soak_figures.h"
#include "tests/support/record_counters.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>

#include <csignal>
#include <random>

using namespace skyseal;
using namespace skyseal::test;

namespace {

struct Disturbance
{
    QByteArray name;
    /// Returns what went wrong, empty: nothing. It is over when it returns.
    std::function<QString()> act;
    bool seamless = false; ///< no frame of the vehicle is lost on its way to the client
    bool forges = false;   ///< counters of forged records may grow
    std::optional<Part> ends = {};
};

/// The frames that were sent since both trails began, and those that were received, compared.
QString difference(SoakChain &chain)
{
    const std::vector<std::uint64_t> sent = chain.sent().marks();
    if (sent.empty())
        return QStringLiteral("nothing was sent");
    std::vector<std::uint64_t> received;
    std::size_t first = 0;
    const bool arrived = eventually([&] {
        chain.client().receive();
        received = chain.client().received.marks();
        first = std::size_t(std::ranges::find(received, sent[0]) - received.begin()); // the earlier ones were on their way
        return received.size() >= first + sent.size();
    });
    if (!arrived)
        return QStringLiteral("of %1 frames, %2 arrived").arg(sent.size()).arg(received.size());
    const auto wrong = std::ranges::mismatch(sent, std::span(received).subspan(first, sent.size())).in1 - sent.begin();
    return wrong == std::ptrdiff_t(sent.size())
        ? QString()
        : QStringLiteral("frame %1 of %2 did not arrive as it was sent").arg(wrong).arg(sent.size());
}

/// The counters of a report that stay as they are while nothing disturbs the chain.
QJsonObject faults(const QJsonObject &report)
{
    QJsonObject out = receivedRecords(report[QLatin1String("channel")]);
    for (const char *moving : {"good", "opened_bytes"})
        out.remove(QLatin1String(moving));
    const QJsonValue mavlink = report[QLatin1String("mavlink")];
    for (const char *name : {"lost", "late", "duplicate", "bad_crc"})
        out[QLatin1String("frames_") + QLatin1String(name)] = mavlink[QLatin1String(name)];
    return out;
}

QString text(const QJsonObject &object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

} // namespace

class SoakTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void everythingWorksAgain();
    void cleanup()
    {
        m_figures.print(); // also after a failure
        m_chain.reset();
    }

private:
    int random(int least, int most) { return std::uniform_int_distribution(least, most)(m_random); }
    bool chance() { return random(0, 1) == 1; }
    Bytes noise();
    void hold(int milliseconds);

    std::vector<Disturbance> disturbances(int longestOutage);
    QString end(Part part, bool kill);
    QString stop(Part part);
    void cut(int longest);
    void sendGarbage();

    QString disturb(const Disturbance &disturbance);
    QString calm(bool forges);

    std::mt19937_64 m_random;
    std::unique_ptr<SoakChain> m_chain;
    SoakFigures m_figures;
    BareSocket m_stranger;
    QElapsedTimer m_clock;
    std::uint64_t m_compared = 0;
    int m_switches = 0, m_switchesFailed = 0;
};

void SoakTest::initTestCase()
{
    SKYSEAL_REQUIRES("mosquitto");
}

Bytes SoakTest::noise()
{
    Bytes out(std::size_t(random(1, 1300)));
    std::ranges::generate(out, [this] { return std::uint8_t(random(0, 255)); });
    return out;
}

/// A disturbance lasts so long.
void SoakTest::hold(int milliseconds)
{
    static_cast<void>(QTest::qWaitFor(
        [this] {
            m_chain->client().receive();
            return false;
        },
        milliseconds));
}

std::vector<Disturbance> SoakTest::disturbances(int longestOutage)
{
    std::vector<Disturbance> out;
    for (const Part part : kParts) {
        const bool seamless = part == Part::UdpStation || part == Part::TcpStation || part == Part::Broker;
        for (const bool kill : {true, false})
            out.push_back({QByteArray(nameOf(part)) + (kill ? " killed" : " ended"),
                           [this, part, kill] { return end(part, kill); }, seamless, false, part});
    }
    for (const Part part : {Part::Agent, Part::Gateway, Part::Vehicle})
        out.push_back({QByteArray(nameOf(part)) + " stopped for a while", [this, part] { return stop(part); }});
    const auto add = [&out](const char *name, auto act, bool seamless, bool forges = false) {
        out.push_back({name,
                       [act] {
                           act();
                           return QString();
                       },
                       seamless,
                       forges,
                       {}});
    };
    add(
        "agent at another address", [this] { m_chain->toGateway().move(); }, true);
    add(
        "vehicle at another address", [this] { m_chain->toAgent().move(); }, true);
    add(
        "client at another address", [this] { m_chain->client().move(); }, false);
    add(
        "garbage", [this] { sendGarbage(); }, true, true);
    add(
        "link cut", [this, longestOutage] { cut(longestOutage); }, false);
    return out;
}

QString SoakTest::end(Part part, bool kill)
{
    if (!m_chain->end(part, kill))
        return QLatin1String(nameOf(part)) + QStringLiteral(" did not end: ") + QString::fromUtf8(m_chain->errors(part));
    if (chance())
        hold(random(100, 5000));
    m_chain->start(part);
    return {};
}

QString SoakTest::stop(Part part)
{
    const auto pid = pid_t(m_chain->pid(part));
    ::kill(pid, SIGSTOP);
    hold(random(500, 5000));
    ::kill(pid, SIGCONT);
    return {};
}

void SoakTest::cut(int longest)
{
    const bool onward = chance(), back = !onward || chance();
    m_chain->toGateway().setOpen(!onward, !back);
    hold(random(1000, longest));
    m_chain->toGateway().setOpen(true, true);
}

/// Noise, damaged and repeated datagrams of the session, from strangers and from the addresses of both ends.
void SoakTest::sendGarbage()
{
    const std::vector<Bytes> heard = m_chain->heard();
    const int count = random(50, 400);
    for (int i = 0; i < count; ++i) {
        Bytes datagram = noise();
        if (const int kind = random(0, 3); kind == 0) {
            datagram[0] = std::uint8_t(random(0x50, 0x5f));
        } else if (kind > 1) {
            datagram = heard[std::size_t(random(0, int(heard.size()) - 1))];
            if (kind == 2)
                datagram[std::size_t(random(0, int(datagram.size()) - 1))] ^= std::uint8_t(1 << random(0, 7));
        }
        const ByteView view(datagram);
        switch (random(0, 4)) {
        case 0: m_stranger.send(m_chain->gatewayPort(), {&view, 1}); break;
        case 1: m_chain->toGateway().inject(UdpWire::Way::Onward, datagram); break;
        case 2: m_chain->toGateway().inject(UdpWire::Way::Back, datagram); break;
        case 3: m_chain->toAgent().inject(UdpWire::Way::Onward, noise()); break;
        default: m_stranger.send(m_chain->servedPort(), {&view, 1}); break;
        }
    }
}

QString SoakTest::disturb(const Disturbance &disturbance)
{
    SoakChain &chain = *m_chain;
    chain.client().received.begin();
    chain.sent().begin();
    if (const QString problem = disturbance.act(); !problem.isEmpty())
        return problem;
    chain.client().receive();
    const std::uint64_t before = chain.client().received.frames();
    chain.mark();
    QElapsedTimer since;
    since.start();
    double firstFrame = -1;
    QString missing;
    const bool works = eventually([&] {
        missing = chain.missing();
        if (firstFrame < 0 && chain.client().received.frames() > before)
            firstFrame = double(since.elapsed()) / 1000;
        return missing.isEmpty();
    });
    if (!works)
        return missing;
    m_figures.noteRecovery(disturbance.name, firstFrame, double(since.elapsed()) / 1000);
    if (!disturbance.seamless) {
        chain.client().received.begin();
        chain.sent().begin();
    }
    return calm(disturbance.forges);
}

QString SoakTest::calm(bool forges)
{
    SoakChain &chain = *m_chain;
    chain.mark();
    constexpr std::array kSealing{Part::Agent, Part::Gateway};
    const auto haveReported = [&](std::size_t times) {
        return eventually([&] {
            chain.client().receive();
            return std::ranges::all_of(kSealing, [&](Part part) { return chain.stats(part).size() >= times; });
        });
    };
    if (!haveReported(1))
        return QStringLiteral("no reports");
    if (chance()) {
        const QStringList suites = GatewayFlight::suites();
        const QString suite = suites[random(0, int(suites.size()) - 1)];
        RunResult result;
        // The peer does not answer while a lossy epoch may still have records on their way, for longer after a long silence.
        const bool switched = eventually([&] {
            ++m_switches;
            result = chain.gateway().control({QStringLiteral("switch"), suite});
            chain.client().receive();
            m_switchesFailed += result.status != 0;
            return result.status == 0;
        });
        if (!switched)
            return QStringLiteral("not switched: ") + QString::fromUtf8(result.err);
    }
    hold(random(0, 2000));
    if (!haveReported(chain.stats(Part::Agent).size() + 1))
        return QStringLiteral("no further reports");
    if (const QString problem = difference(chain); !problem.isEmpty())
        return problem;
    m_compared += chain.sent().marks().size();
    for (const Part part : kSealing) {
        const std::vector<QJsonObject> reports = chain.stats(part);
        const QJsonObject first = faults(reports.front()), last = faults(reports.back());
        if (first != last && !forges)
            return QLatin1String(nameOf(part)) + QStringLiteral(" counted ") + text(first) + QStringLiteral(", then ")
                + text(last);
    }
    return {};
}

void SoakTest::everythingWorksAgain()
{
    const int asked = qEnvironmentVariableIntValue("SKYSEAL_SOAK_SECONDS");
    const double seconds = asked > 0 ? asked : 20;
    bool given = false;
    const quint64 number = qEnvironmentVariable("SKYSEAL_SOAK_SEED").toULongLong(&given);
    const quint64 seed = given ? number : std::random_device()();
    qInfo("SKYSEAL_SOAK_SECONDS=%.0f SKYSEAL_SOAK_SEED=%llu", seconds, seed);
    m_random.seed(seed);
    m_chain = std::make_unique<SoakChain>();
    EVENTUALLY2(m_chain->missing().isEmpty(), qPrintable(m_chain->missing()));
    m_clock.start();
    const auto now = [this] { return double(m_clock.elapsed()) / 1000; };

    std::vector<Disturbance> left;
    int done = 0;
    while (now() < seconds) {
        if (left.empty()) {
            left = disturbances(int(std::clamp(seconds * 50, 3000.0, 20000.0)));
            std::ranges::shuffle(left, m_random);
        }
        const Disturbance next = left.back();
        left.pop_back();
        // In one third of the time each, gateway and agent live on, so that they show what they hold on to.
        const int third = int(3 * now() / seconds);
        if ((third == 1 && next.ends == Part::Gateway) || (third == 2 && next.ends == Part::Agent))
            continue;
        qInfo("%.1f s: %s", now(), next.name.constData());
        const QString problem = disturb(next);
        QVERIFY2(
            problem.isEmpty(),
            qPrintable(QStringLiteral("%1, the %2th disturbance: %3").arg(QLatin1String(next.name)).arg(done).arg(problem)));
        ++done;
        m_figures.noteProcesses(*m_chain, now());
    }

    const RunResult status = m_chain->gateway().control({QStringLiteral("status"), QStringLiteral("--json")});
    const QJsonObject state = QJsonDocument::fromJson(status.out)[QLatin1String("status")].toObject();
    QCOMPARE(state[QLatin1String("sessions")].toArray().size(), qsizetype(1));
    qInfo("%.0f s, %d disturbances; %d switches of the suite were tried, %d not confirmed", now(), done, m_switches,
          m_switchesFailed);
    qInfo("%llu frames were sent, %llu compared one by one", qulonglong(m_chain->sent().frames()), qulonglong(m_compared));
    for (const Part part : kParts)
        QVERIFY2(m_chain->end(part, false), m_chain->errors(part).constData());
    const KeyUses uses = m_chain->keyUses();
    qInfo("%lld records, %d sessions", uses.records, uses.sessions);
    QVERIFY(uses.records > 0);
    QCOMPARE(uses.repeated, 0);
#ifndef SKYSEAL_SANITIZED
    QVERIFY2(m_figures.growth().isEmpty(), qPrintable(m_figures.growth()));
#endif
}

SKYSEAL_TEST(SoakTest)
#include "soak_test.moc"
