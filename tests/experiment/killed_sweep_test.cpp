// A sweep that is killed, by kill -9 in the middle of a run: none of the programs that it started survives it, nor those that
// its launch started; a launch lands its vehicle first.
#include "tests/experiment/flown_vehicle.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#include <algorithm>

using namespace skyseal::test;

class KilledSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void noProgramSurvives_data();
    void noProgramSurvives();
    void launchLandsTheVehicle();

private:
    std::unique_ptr<QTemporaryDir> m_temporary; ///< a killed program cannot remove its keys
};

namespace {

QByteArray processFile(qint64 process, const char *name)
{
    QFile file(QStringLiteral("/proc/%1/%2").arg(process).arg(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

struct Descendant
{
    qint64 process;
    QByteArray name;
};

/// Children of a process, their children, and so on.
std::vector<Descendant> descendantsOf(qint64 process)
{
    std::vector<Descendant> out;
    const QByteArray children = processFile(process,
                                            QByteArray("task/" + QByteArray::number(process) + "/children").constData());
    for (const QByteArray &child : children.simplified().split(' ')) {
        const qint64 id = child.toLongLong();
        if (id == 0)
            continue;
        out.push_back({id, processFile(id, "comm").trimmed()});
        const std::vector<Descendant> further = descendantsOf(id);
        out.insert(out.end(), further.begin(), further.end());
    }
    return out;
}

QByteArrayList namesOf(const std::vector<Descendant> &processes)
{
    QByteArrayList out;
    for (const Descendant &one : processes)
        out << one.name;
    std::sort(out.begin(), out.end());
    return out;
}

/// One that has ended and was not collected by its new parent does not run.
bool runs(const Descendant &one)
{
    const QByteArray status = processFile(one.process, "status");
    return processFile(one.process, "comm").trimmed() == one.name && !status.contains("State:\tZ");
}

QByteArrayList survivorsOf(const std::vector<Descendant> &processes)
{
    std::vector<Descendant> out;
    std::copy_if(processes.begin(), processes.end(), std::back_inserter(out), runs);
    return namesOf(out);
}

} // namespace

void KilledSweepTest::init()
{
    m_temporary = std::make_unique<QTemporaryDir>();
    qputenv("TMPDIR", QFile::encodeName(m_temporary->path()));
}

void KilledSweepTest::cleanup()
{
    qunsetenv("TMPDIR");
}

void KilledSweepTest::noProgramSurvives_data()
{
    QTest::addColumn<int>("launches");
    QTest::newRow("one launch") << 1;
    QTest::newRow("two launches") << 2;
}

/// Agent, simulator and relay; with several launches also the launch. A process that measures memory may be there as well.
void KilledSweepTest::noProgramSurvives()
{
    QFETCH(int, launches);
    Program sweep(
        QStringLiteral("skyseal-cli"),
        words("sweep --suites aes-256-gcm --load natural --impair delay=5 --seconds 600 --warm-up 0.3 --no-noise --json "
              "--launches")
            + QStringList{QString::number(launches)});
    QVERIFY2(!sweep.waitFor(QStringLiteral("begin")).isEmpty(), sweep.errors().constData());
    const std::vector<Descendant> started = descendantsOf(sweep.pid());
    const QByteArrayList running = survivorsOf(started);
    QCOMPARE(running.count("skyseal-air"), 1);
    QCOMPARE(running.count("skyseal-sim"), 1);
    QVERIFY(running.count("skyseal-cli") >= launches);
    sweep.kill();
    EVENTUALLY_EQUAL(survivorsOf(started), QByteArrayList());
}

/// The launch is told by the kernel that the sweep is gone, and ends as if it were cancelled.
void KilledSweepTest::launchLandsTheVehicle()
{
    FlownVehicle vehicle;
    QVERIFY(vehicle.sim.waitUntilListening(QStringLiteral("tcpin")));
    Program sweep(QStringLiteral("skyseal-cli"),
                  vehicle.sweep(QLatin1String(kToFiveMetres), "--suites aes-256-gcm --seconds 600 --no-noise --launches 2"));
    EVENTUALLY2(vehicle.isFlying(), sweep.errors().constData());
    const std::vector<Descendant> started = descendantsOf(sweep.pid());
    const QByteArrayList running = survivorsOf(started);
    QCOMPARE(running.count("skyseal-air"), 1);
    QVERIFY(running.count("skyseal-cli") >= 1);
    sweep.kill();
    EVENTUALLY(vehicle.isDown());
    EVENTUALLY_EQUAL(survivorsOf(started), QByteArrayList());
    QCOMPARE(vehicle.landings(), 1);
    QVERIFY(vehicle.sim.running());                                         // the autopilot is not the sweep's
    QVERIFY(m_temporary->isValid() && QDir(m_temporary->path()).isEmpty()); // the launch has removed its keys
}

SKYSEAL_TEST(KilledSweepTest)
#include "killed_sweep_test.moc"
