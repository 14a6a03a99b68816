// What the agent takes from its host: little memory, and one folder that it can write.
#include "tests/support/flight.h"
#include "tests/support/pairing_people.h"
#include "tests/support/process_figures.h"
#include "tests/support/run_program.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtTest/QTest>

#include <memory>
#include <set>

using namespace skyseal::test;

namespace {

#ifdef SKYSEAL_SANITIZED
constexpr qint64 kMostKilobytes = 1024 * 1024; // shadow memory
#else
constexpr qint64 kMostKilobytes = 32 * 1024;
#endif

/// Runs its arguments behind the first one with every disk read-only except for the folder that the first one names.
constexpr const char *kReadOnlyExcept = R"(
set -e
mount --make-rprivate /
mount --bind "$1" "$1"
while read -r device place kind rest; do
    case "$kind:$place" in proc:*|*:"$1") ;; *) mount -o remount,bind,ro "$place" 2>/dev/null || true ;; esac
done < /proc/self/mounts
! touch "$1/../elsewhere" 2>/dev/null
shift
exec "$@"
)";

/// Arguments of unshare(1).
QStringList onReadOnlyRoot(const QString &folder, const QString &program, const QStringList &arguments)
{
    return QStringList{QStringLiteral("-m"),
                       QStringLiteral("sh"),
                       QStringLiteral("-c"),
                       QLatin1String(kReadOnlyExcept),
                       QStringLiteral("sh"),
                       folder,
                       program}
    + arguments;
}

/// Lists the vehicles of an agent in the stations' list of peers: without, a peer may have only a few.
bool listVehicles(const QString &peers, int vehicles)
{
    QByteArrayList systems;
    for (int id = 1; id <= vehicles; ++id)
        systems << QByteArray::number(id);
    QFile file(peers);
    if (!file.open(QIODevice::ReadWrite))
        return false;
    QByteArray list = file.readAll();
    const bool isOpen = list.contains(" any ");
    list.replace(" any ", ' ' + systems.join(',') + ' ');
    return isOpen && file.resize(0) && file.seek(0) && file.write(list) == list.size();
}

} // namespace

class AgentHostTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void memoryAfterAFlight_data();
    void memoryAfterAFlight();
    void readOnlyRoot();
};

void AgentHostTest::memoryAfterAFlight_data()
{
    QTest::addColumn<int>("stations");
    QTest::addColumn<int>("vehicles");
    QTest::newRow("4 stations, one vehicle") << 4 << 1;
    QTest::newRow("8 stations, 20 vehicles") << 8 << 20;
}

/// One of the stations flies while it switches the suites.
void AgentHostTest::memoryAfterAFlight()
{
    QFETCH(int, stations);
    QFETCH(int, vehicles);
    Flight flight;
    QVERIFY(flight.ready() && listVehicles(flight.path(QStringLiteral("ground.peers")), vehicles));
    QStringList arguments = flight.airArguments();
    std::vector<std::unique_ptr<Program>> observers;
    for (int i = 1; i < stations; ++i) {
        const quint16 port = freeUdpPort();
        arguments << QStringLiteral("--ground") << QStringLiteral("udpout:127.0.0.1:%1").arg(port);
        const QString key = flight.path(QStringLiteral("observer%1.key").arg(i));
        QCOMPARE(
            runProgram("skyseal-cli", {QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), key}).status, 0);
        Program show(QStringLiteral("skyseal-cli"),
                     {QStringLiteral("keys"), QStringLiteral("show"), key, QStringLiteral("--json")});
        const QString publicKey = show.waitFor(QStringLiteral("key"))[QLatin1String("public")].toString();
        QCOMPARE(
            runProgram("skyseal-cli",
                       {QStringLiteral("keys"), QStringLiteral("peers"), QStringLiteral("add"), QStringLiteral("--peers"),
                        flight.path(QStringLiteral("air.peers")), QStringLiteral("--name"), QStringLiteral("observer%1").arg(i),
                        QStringLiteral("--role"), QStringLiteral("observer"), publicKey})
                .status,
            0);
        QStringList monitor = flight.monitorArguments({QStringLiteral("--no-record")});
        monitor[monitor.indexOf(QStringLiteral("--link")) + 1] = QStringLiteral("udpin:127.0.0.1:%1").arg(port);
        monitor[monitor.indexOf(QStringLiteral("--identity")) + 1] = key;
        observers.push_back(std::make_unique<Program>(QStringLiteral("skyseal-cli"), monitor));
    }
    Program sim(QStringLiteral("skyseal-sim"), flight.simArguments({QStringLiteral("--vehicles"), QString::number(vehicles)}));
    Program air(QStringLiteral("skyseal-air"), arguments);
    Program pilot(
        QStringLiteral("skyseal-cli"),
        flight.monitorArguments({QStringLiteral("--no-record"), QStringLiteral("--switch-to"), allSuites(),
                                 QStringLiteral("--switch-every"), QStringLiteral("1"), QStringLiteral("--do"),
                                 QStringLiteral("wait ekf_ok==1 60; mode GUIDED; arm; takeoff 5; wait alt_rel>=4.5 60; "
                                                "land; wait armed==0 90")}));
    for (const auto &observer : observers)
        QVERIFY2(!observer->waitFor(QStringLiteral("session"), stateIs("up")).isEmpty(), observer->errors().constData());
    QVERIFY2(pilot.waitForExit(2 * kDeadlineMs) == 0, pilot.errors().constData());
    std::set<int> heard;
    for (const QJsonObject &vehicle : pilot.events(QStringLiteral("vehicle")))
        heard.insert(vehicle[QLatin1String("sysid")].toInt());
    QCOMPARE(heard.size(), std::size_t(vehicles));
    const qint64 peak = statusKilobytes(air.pid(), "VmHWM");
    qInfo("VmHWM %lld kB", peak);
    QVERIFY(peak > 0);
    QVERIFY2(peak <= kMostKilobytes, qPrintable(QString::number(peak)));
}

/// It starts, makes its list, is paired, flies and starts again.
void AgentHostTest::readOnlyRoot()
{
    SKYSEAL_REQUIRES("mounts");
    const QString unshare(QStringLiteral("/usr/bin/unshare"));
    QTemporaryDir folder;
    const QString state = folder.filePath(QStringLiteral("state"));
    QVERIFY(QDir().mkpath(state));
    QCOMPARE(runToItsEnd(unshare, onReadOnlyRoot(state, QStringLiteral("/bin/true"), {})).status, 0);
    QVERIFY(runToItsEnd(unshare, onReadOnlyRoot(state, QStringLiteral("/bin/touch"), {folder.filePath(QStringLiteral("no"))}))
                .status
            != 0);

    const QString key = state + QStringLiteral("/air.key"), peers = state + QStringLiteral("/air.peers");
    const QString groundKey = folder.filePath(QStringLiteral("ground.key"));
    const QString groundPeers = folder.filePath(QStringLiteral("ground.peers"));
    for (const QString &file : {key, groundKey})
        QCOMPARE(
            runProgram("skyseal-cli", {QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), file}).status,
            0);
    const quint16 vehiclePort = freeUdpPort(), groundPort = freeUdpPort();
    const QStringList arguments = onReadOnlyRoot(
        state, QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-air"),
        {QStringLiteral("--vehicle"), QStringLiteral("udpin:127.0.0.1:%1").arg(vehiclePort), QStringLiteral("--ground"),
         QStringLiteral("udpout:127.0.0.1:%1").arg(groundPort), QStringLiteral("--identity"), key, QStringLiteral("--peers"),
         peers, QStringLiteral("--json")});
    auto air = std::make_unique<Program>(unshare, arguments);
    QVERIFY2(!air->waitFor(QStringLiteral("stats")).isEmpty(), air->errors().constData());
    QVERIFY(QFile::exists(peers));
    QVERIFY2(!air->errors().contains("no pairing"), air->errors().constData());

    const QStringList station{QStringLiteral("--link"),     QStringLiteral("udpin:127.0.0.1:%1").arg(groundPort),
                              QStringLiteral("--identity"), groundKey,
                              QStringLiteral("--peers"),    groundPeers,
                              QStringLiteral("--json")};
    {
        Program desk(QStringLiteral("skyseal-air"),
                     {QStringLiteral("--pair"), QStringLiteral("--json"), QStringLiteral("--as"), QStringLiteral("ground"),
                      QStringLiteral("--identity"), key});
        Program ground(
            QStringLiteral("skyseal-cli"),
            QStringList{QStringLiteral("keys"), QStringLiteral("pair"), QStringLiteral("--as"), QStringLiteral("air-1")}
                + station);
        QVERIFY2(confirmAtBoth(ground, desk), ground.errors().constData());
    }
    Program sim(QStringLiteral("skyseal-sim"),
                {QStringLiteral("--link"), QStringLiteral("udpout:127.0.0.1:%1").arg(vehiclePort)});
    for (const bool again : {false, true}) {
        if (again) {
            air->kill();
            air = std::make_unique<Program>(unshare, arguments);
        }
        const QString flies(QStringLiteral("wait ekf_ok==1 60; mode GUIDED; arm; takeoff 3; wait alt_rel>=2.5 60; land; "
                                           "wait armed==0 90"));
        Program pilot(QStringLiteral("skyseal-cli"),
                      QStringList{QStringLiteral("monitor"), QStringLiteral("--no-record"), QStringLiteral("--secure"),
                                  QStringLiteral("required"), QStringLiteral("--do"), flies}
                          + station);
        QVERIFY2(pilot.waitForExit(2 * kDeadlineMs) == 0, pilot.errors().constData());
    }
    QVERIFY(air->events(QStringLiteral("counter_storage")).empty());
    QCOMPARE(air->terminate(), 0);
}

SKYSEAL_TEST(AgentHostTest)
#include "agent_host_test.moc"
