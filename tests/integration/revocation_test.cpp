// The peers file changes while real programs use it: a removed peer loses its session at once, at either end, changed roles
// apply at once, and an invalid edit changes nothing. That the session ends without delay:
// HandshakeTest::revokedPeerLosesItsSession.
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

bool is(const QJsonObject &event, const char *key, const char *value)
{
    return event[QLatin1String(key)].toString() == QLatin1String(value);
}

Program::Predicate sessionIs(const char *state)
{
    return [state](const QJsonObject &event) { return is(event, "state", state); };
}

} // namespace

class RevocationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void revokedByTheAgent();
    void revokedByTheStation();
    void backAgainWhenAddedAgain();
    void badEditChangesNothing();
    void missingFileChangesNothing();
    void unusablePresharedKeyKeepsNobodyElse();
    void roleIsObeyedAtOnce();

private:
    int peers(const QStringList &arguments) const
    {
        Program program(QStringLiteral("skyseal-cli"),
                        QStringList{QStringLiteral("keys"), QStringLiteral("peers")} + arguments);
        return program.waitForExit();
    }
    int revoke(const char *file, const char *name) const
    {
        return peers(
            {QStringLiteral("revoke"), QStringLiteral("--peers"), m_flight->path(QLatin1String(file)), QLatin1String(name)});
    }
    QByteArray read(const char *file) const
    {
        QFile in(m_flight->path(QLatin1String(file)));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    /// In place, as some editors write.
    void write(const char *file, const QByteArray &content) const
    {
        QFile out(m_flight->path(QLatin1String(file)));
        QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
        out.write(content);
    }
    QJsonObject stats() const { return m_monitor->waitFor(QStringLiteral("stats")); }

    std::unique_ptr<Flight> m_flight;
    std::unique_ptr<Program> m_sim, m_air, m_monitor;
};

void RevocationTest::init()
{
    m_flight = std::make_unique<Flight>();
    QVERIFY(m_flight->ready());
    m_sim = std::make_unique<Program>(QStringLiteral("skyseal-sim"), m_flight->simArguments());
    m_air = std::make_unique<Program>(QStringLiteral("skyseal-air"), m_flight->airArguments());
    m_monitor = std::make_unique<Program>(QStringLiteral("skyseal-cli"), m_flight->monitorArguments());
    QVERIFY(!m_monitor->waitFor(QStringLiteral("session"), sessionIs("up")).isEmpty());
    QVERIFY(!m_air->waitFor(QStringLiteral("session"), sessionIs("up")).isEmpty());
}

void RevocationTest::cleanup()
{
    m_monitor.reset();
    m_air.reset();
    m_sim.reset();
    m_flight.reset();
}

void RevocationTest::revokedByTheAgent()
{
    QCOMPARE(revoke("air.peers", "ground"), 0);
    const QJsonObject down = m_air->waitFor(QStringLiteral("session"), sessionIs("down"));
    QVERIFY2(is(down, "reason", "revoked"), m_air->errors().constData());
    QVERIFY(!m_monitor->waitFor(QStringLiteral("session"), sessionIs("down")).isEmpty());
    // The station tries again and is refused, and receives no more frames of the vehicle.
    QVERIFY(!m_air->waitFor(QStringLiteral("refused"), [](const QJsonObject &e) { return is(e, "reason", "unknown-peer"); })
                 .isEmpty());
    m_monitor->skipReceivedEvents();
    const QJsonObject before = stats();
    const auto frames = [](const QJsonObject &event) {
        return event[QLatin1String("mavlink")].toObject()[QLatin1String("frames")].toInteger();
    };
    QVERIFY(!before.isEmpty());
    QCOMPARE(frames(stats()), frames(before));
    QVERIFY(m_air->running() && m_monitor->running());
}

void RevocationTest::revokedByTheStation()
{
    QCOMPARE(revoke("ground.peers", "air-1"), 0);
    QVERIFY(is(m_monitor->waitFor(QStringLiteral("session"), sessionIs("down")), "reason", "revoked"));
    QVERIFY(!m_air->waitFor(QStringLiteral("session"), sessionIs("down")).isEmpty());
}

void RevocationTest::backAgainWhenAddedAgain()
{
    const QByteArray known = read("air.peers");
    QCOMPARE(revoke("air.peers", "ground"), 0);
    QVERIFY(!m_air->waitFor(QStringLiteral("session"), sessionIs("down")).isEmpty());
    m_monitor->skipReceivedEvents();
    write("air.peers", known);
    QVERIFY(!m_air->waitFor(QStringLiteral("session"), sessionIs("up")).isEmpty());
    QVERIFY(!m_monitor->waitFor(QStringLiteral("session"), sessionIs("up")).isEmpty());
}

void RevocationTest::badEditChangesNothing()
{
    write("air.peers", "ground captain any skyseal:nonsense\n");
    const QJsonObject refused = m_air->waitFor(QStringLiteral("peers"));
    const QString problem = refused[QLatin1String("problem")].toString();
    QVERIFY2(problem.contains(QLatin1String("air.peers:1: ")) && problem.contains(QLatin1String("captain")),
             qPrintable(problem));
    QVERIFY(m_air->events(QStringLiteral("session")).size() == 1); // the one that went up
    QVERIFY(!stats().isEmpty());

    QFile::setPermissions(m_flight->path(QStringLiteral("ground.peers")),
                          QFile::ReadOwner | QFile::WriteOwner | QFile::WriteOther);
    QVERIFY(m_monitor->waitFor(QStringLiteral("peers"))[QLatin1String("problem")].toString().contains(
        QLatin1String("other users")));
    QCOMPARE(m_monitor->events(QStringLiteral("session")).size(), std::size_t(1));
}

void RevocationTest::missingFileChangesNothing()
{
    QVERIFY(QFile::remove(m_flight->path(QStringLiteral("air.peers"))));
    const QString problem = m_air->waitFor(QStringLiteral("peers"))[QLatin1String("problem")].toString();
    QVERIFY2(problem.contains(QLatin1String("does not exist")), qPrintable(problem));
    QCOMPARE(m_air->events(QStringLiteral("session")).size(), std::size_t(1));
    // The agent notices that the file is there again, as an empty list.
    write("air.peers", "");
    QVERIFY(!m_air->waitFor(QStringLiteral("session"), sessionIs("down")).isEmpty());
    QCOMPARE(m_air->waitFor(QStringLiteral("peers"))[QLatin1String("count")].toInt(-1), 0);
}

void RevocationTest::unusablePresharedKeyKeepsNobodyElse()
{
    // The other peer's pre-shared key file is missing. A revoked peer loses its session all the same.
    QByteArray other = read("ground.peers").trimmed();
    other.replace("air-1 ", "other ");
    write("air.peers", read("air.peers") + other + " psk=missing.psk\n");
    const QJsonObject added = m_air->waitFor(QStringLiteral("peers"));
    QCOMPARE(added[QLatin1String("count")].toInt(), 1);
    const QString problem = added[QLatin1String("problem")].toString();
    QVERIFY2(problem.contains(QLatin1String("missing.psk")) && problem.contains(QLatin1String("\"other\"")),
             qPrintable(problem));
    QCOMPARE(m_air->events(QStringLiteral("session")).size(), std::size_t(1));

    QCOMPARE(revoke("air.peers", "ground"), 0);
    QVERIFY(is(m_air->waitFor(QStringLiteral("session"), sessionIs("down")), "reason", "revoked"));
    QCOMPARE(m_air->waitFor(QStringLiteral("peers"))[QLatin1String("count")].toInt(-1), 0);
}

void RevocationTest::roleIsObeyedAtOnce()
{
    const auto refused = [](const QJsonObject &event) {
        return event[QLatin1String("forwarded")].toObject()[QLatin1String("observer_refused")].toInteger() > 0;
    };
    QCOMPARE(peers({QStringLiteral("role"), QStringLiteral("--peers"), m_flight->path(QStringLiteral("air.peers")),
                    QStringLiteral("ground"), QStringLiteral("observer")}),
             0);
    QCOMPARE(m_air->waitFor(QStringLiteral("peers"))[QLatin1String("count")].toInt(), 1);
    // The station's heartbeats are dropped, and its session stays up.
    QVERIFY(!m_air->waitFor(QStringLiteral("stats"), refused).isEmpty());
    QCOMPARE(m_air->events(QStringLiteral("session")).size(), std::size_t(1));
}

SKYSEAL_TEST(RevocationTest)
#include "revocation_test.moc"
