// Which core each program of a sweep runs on: the plan for any number of cores, and the affinity that the kernel states of the
// programs that were started.
#include "core/crypto/system_random.h"
#include "core/experiment/lab.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QMap>
#include <QtTest/QTest>

#include <numeric>
#include <set>
#ifdef Q_OS_LINUX
#include <sched.h>
#include <unistd.h>
#endif

using namespace skyseal;
using namespace skyseal::experiment;
using namespace skyseal::test;

class PlacementTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void planOfEachNumberOfCores();
    void startedProgramsRunWhereThePlanSays();
    void startedProgramsRunWhereTheRecordSays();
};

namespace {

QByteArray kernelFile(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Of a process, as the kernel states it: "0-1".
QString coresOf(const QString &process)
{
    for (const QByteArray &line : kernelFile(QStringLiteral("/proc/%1/status").arg(process)).split('\n')) {
        if (line.startsWith("Cpus_allowed_list:"))
            return QString::fromLatin1(line.mid(line.indexOf(':') + 1)).trimmed();
    }
    return {};
}

/// Cores of the children of this process, by the names of their programs.
QMap<QString, QString> coresOfChildren()
{
    QMap<QString, QString> out;
    const QByteArray children = kernelFile(
        QStringLiteral("/proc/self/task/%1/children").arg(QCoreApplication::applicationPid()));
    for (const QByteArray &child : children.simplified().split(' ')) {
        const QString process = QString::fromLatin1(child);
        out[QString::fromLatin1(kernelFile(QStringLiteral("/proc/%1/comm").arg(process)).trimmed())] = coresOf(process);
    }
    return out;
}

std::unique_ptr<Lab> labWith(const Placement &placement)
{
    crypto::SystemRandom random;
    const QString programs = QStringLiteral(SKYSEAL_BIN_DIR "/");
    auto lab = Lab::create({programs + QStringLiteral("skyseal-sim"), programs + QStringLiteral("skyseal-air"),
                            programs + QStringLiteral("skyseal-cli")},
                           random, std::nullopt, placement);
    return lab ? std::move(*lab) : nullptr;
}

/// Cores of simulator, agent and relay once all of them run.
QMap<QString, QString> coresOfPrograms(Lab &lab)
{
    lab.start(Load::Natural, *parseCondition("delay=5"), 1);
    QMap<QString, QString> out;
    const auto areAll = [&out] {
        out = coresOfChildren();
        return out.contains(QStringLiteral("skyseal-sim")) && out.contains(QStringLiteral("skyseal-air"))
            && out.contains(QStringLiteral("skyseal-cli"));
    };
    return eventually(areAll) ? out : QMap<QString, QString>();
}

QString coreName(std::optional<int> core)
{
    return core ? QString::number(*core) : QStringLiteral("none");
}

} // namespace

void PlacementTest::planOfEachNumberOfCores()
{
    for (int count = 0; count <= 16; ++count) {
        std::vector<int> cores(static_cast<std::size_t>(count));
        std::iota(cores.begin(), cores.end(), 10);
        const Placement placed = placementOn(cores);
        QCOMPARE(placed.usable, count);
        const std::set<std::optional<int>> all{placed.station, placed.agent, placed.simulator, placed.relay};
        if (count < 5) {
            QCOMPARE(all, std::set<std::optional<int>>{std::nullopt});
            QVERIFY(placed.text().find(std::to_string(count) + " usable cores are too few") != std::string::npos);
            continue;
        }
        QCOMPARE(all, (std::set<std::optional<int>>{10, 11, 12, 13})); // one each, and one or more for the rest of the machine
        for (const auto &[program, core] : {std::pair("station's I/O thread", placed.station), std::pair("agent", placed.agent),
                                            std::pair("simulator", placed.simulator), std::pair("relay", placed.relay)}) {
            const std::string said = std::string(program) + " on core " + std::to_string(*core);
            QVERIFY2(placed.text().find(said) != std::string::npos, placed.text().c_str());
        }
    }
}

/// Two cores are enough to tell that each program is on the one that is its own.
void PlacementTest::startedProgramsRunWhereThePlanSays()
{
#ifdef Q_OS_LINUX
    const int usable = placementHere().usable;
    cpu_set_t set;
    QCOMPARE(::sched_getaffinity(0, sizeof set, &set), 0);
    std::vector<int> cores;
    for (int core = 0; core < CPU_SETSIZE; ++core) {
        if (CPU_ISSET(core, &set))
            cores.push_back(core);
    }
    for (const auto &[first, second] : {std::pair(cores.front(), cores.back()), std::pair(cores.back(), cores.front())}) {
        Placement placement;
        placement.station = first;
        placement.agent = first;
        placement.simulator = second;
        placement.relay = second;
        placement.usable = usable;
        const auto lab = labWith(placement);
        QVERIFY(lab);
        const QMap<QString, QString> found = coresOfPrograms(*lab);
        QCOMPARE(found[QStringLiteral("skyseal-air")], coreName(first));
        QCOMPARE(found[QStringLiteral("skyseal-sim")], coreName(second));
        QCOMPARE(found[QStringLiteral("skyseal-cli")], coreName(second));
        QVERIFY(lab->placement().text().find("agent on core " + std::to_string(first)) != std::string::npos);
        QVERIFY(usable == 1 || coresOf(QStringLiteral("self")) != coreName(first)); // the station is not the lab's to place
    }
#endif
}

/// On this machine, whatever it has.
void PlacementTest::startedProgramsRunWhereTheRecordSays()
{
#ifdef Q_OS_LINUX
    const auto lab = labWith(placementHere());
    QVERIFY(lab);
    const Placement &recorded = lab->placement();
    const QMap<QString, QString> found = coresOfPrograms(*lab);
    const QString whole = coresOf(QStringLiteral("self"));
    QVERIFY(!whole.isEmpty());
    for (const auto &[program, core] : {std::pair("skyseal-sim", recorded.simulator), std::pair("skyseal-air", recorded.agent),
                                        std::pair("skyseal-cli", recorded.relay)})
        QCOMPARE(found[QLatin1String(program)], core ? coreName(core) : whole);
    QCOMPARE(recorded.text().find("left to the system") == 0, recorded.usable < 5);
#endif
}

SKYSEAL_TEST(PlacementTest)
#include "placement_test.moc"
