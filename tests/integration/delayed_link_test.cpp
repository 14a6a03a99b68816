// Real programs over a slow link: with the defaults a flight goes on over 0.6 s each way; when the delay grows beyond the
// limit, the agent ignores commands, and both ends report it.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"
#include "tests/support/udp_attacker.h"

#include <QtCore/QTimer>

#include <random>

using namespace skyseal::test;

namespace {

/// Delays the datagrams of both directions by `milliseconds` ± `jitter`.
class SlowLink
{
public:
    explicit SlowLink(quint16 groundPort) : m_path(groundPort)
    {
        m_path.passes = [this](const UdpAttacker::Seen &datagram) {
            const auto late = std::uniform_int_distribution<>(milliseconds - jitter, milliseconds + jitter)(m_random);
            QTimer::singleShot(late, Qt::PreciseTimer, &m_context, [this, datagram] {
                datagram.toGround ? m_path.toGround(datagram.bytes) : m_path.toAgent(datagram.bytes);
            });
            m_path.seen.clear();
            return false;
        };
    }
    quint16 port() const { return m_path.port(); }

    int milliseconds = 1200;
    int jitter = 300;

private:
    UdpAttacker m_path;
    QObject m_context;
    std::mt19937 m_random{1};
};

bool isLate(const QJsonObject &refused)
{
    return refused[QLatin1String("reason")] == QLatin1String("late");
}

} // namespace

class DelayedLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fliesWithTheDefaultsAndRefusesWhatIsTooOld();
};

void DelayedLinkTest::fliesWithTheDefaultsAndRefusesWhatIsTooOld()
{
    Flight flight;
    QVERIFY(flight.ready());
    SlowLink link(flight.groundPort);
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments());
    Program air(QStringLiteral("skyseal-air"), flight.airArguments(link.port()));
    Program monitor(QStringLiteral("skyseal-cli"),
                    flight.monitorArguments({QStringLiteral("--do"),
                                             QStringLiteral("wait ekf_ok==1 60; mode GUIDED; arm; takeoff 3; "
                                                            "wait alt_rel>=2.5 60; sleep 20; land"),
                                             QStringLiteral("--duration"), QStringLiteral("240")}));
    const auto isStep = [](const char *step) {
        return [step](const QJsonObject &command) {
            return command[QLatin1String("step")].toString().startsWith(QLatin1String(step));
        };
    };
    const QJsonObject takeOff = monitor.waitFor(QStringLiteral("command"), isStep("takeoff"));
    QVERIFY2(!takeOff.isEmpty(), monitor.errors() + air.errors());
    QCOMPARE(takeOff[QLatin1String("result")].toString(), QStringLiteral("accepted"));
    QVERIFY(!monitor.waitFor(QStringLiteral("command"), isStep("wait alt_rel")).isEmpty());
    QVERIFY(monitor.events(QStringLiteral("commands_late")).empty());
    QVERIFY(air.events(QStringLiteral("frames_refused")).empty());
    const auto isOnItsWay = [](const QJsonObject &stats) {
        const QJsonObject freshness = stats[QLatin1String("freshness")].toObject();
        return freshness[QLatin1String("age_ms")].toDouble() >= 900 && freshness[QLatin1String("age_ms")].toDouble() < 5000
            && freshness[QLatin1String("age_limit_ms")].toInt() == 5000
            && freshness[QLatin1String("overtaken_limit_ms")].toInt() == 1000;
    };
    QVERIFY2(!air.waitFor(QStringLiteral("stats"), isOnItsWay).isEmpty(), "the agent shows age and limits");

    link.milliseconds = 6000;
    const QJsonObject late = monitor.waitFor(QStringLiteral("commands_late"));
    QVERIFY2(late[QLatin1String("age_ms")].toDouble() > 5000, monitor.errors());
    QCOMPARE(late[QLatin1String("age_limit_ms")].toInt(), 5000);
    const QJsonObject refused = air.waitFor(QStringLiteral("frames_refused"), isLate);
    QVERIFY2(!refused.isEmpty(), air.errors());
    const QJsonObject land = monitor.waitFor(QStringLiteral("command"), isStep("land"));
    QVERIFY(land[QLatin1String("result")].toString() != QLatin1String("accepted"));
}

SKYSEAL_TEST(DelayedLinkTest)
#include "delayed_link_test.moc"
