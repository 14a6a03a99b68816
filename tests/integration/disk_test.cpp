// The real programs on a disk that becomes full or read-only: sessions go on, new ones come up, and both ends say so until the
// disk works again. The disks are mounted in a mount namespace of this process, which nobody else sees.
#include "tests/support/flight.h"
#include "tests/support/json_values.h"
#include "tests/support/run_program.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QJsonArray>
#include <QtTest/QTest>

#include <functional>
#include <memory>

#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

using namespace skyseal::test;

namespace {

/// A tmpfs of 256 kB over a folder.
class SmallDisk
{
public:
    explicit SmallDisk(const QString &folder) : m_folder(folder)
    {
        m_mounted = QDir().mkpath(folder) && ::mount("tmpfs", name(), "tmpfs", 0, "size=256k,mode=700") == 0;
    }
    ~SmallDisk()
    {
        if (m_mounted)
            ::umount2(name(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk &) = delete;
    SmallDisk &operator=(const SmallDisk &) = delete;

    bool isMounted() const { return m_mounted; }
    QString path(const char *file) const { return m_folder + QLatin1Char('/') + QLatin1String(file); }
    bool takes(const QString &file) const
    {
        const QString copy = m_folder + QLatin1Char('/') + QFileInfo(file).fileName();
        return QFile::copy(file, copy) && QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
    }
    /// Until not a byte more fits.
    bool fill() const
    {
        QFile file(path("filler"));
        if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
            return false;
        const QByteArray page(4096, 'x');
        while (file.write(page) == page.size()) {}
        return !QFile(path("one more")).open(QIODevice::WriteOnly) || QFile(path("one more")).size() == 0;
    }
    bool empty() const { return QFile::remove(path("filler")); }
    bool setReadOnly(bool on) const
    {
        return ::mount("tmpfs", name(), nullptr, MS_REMOUNT | (on ? MS_RDONLY : 0), "size=256k") == 0;
    }

private:
    const char *name() const
    {
        m_name = m_folder.toLocal8Bit();
        return m_name.constData();
    }

    QString m_folder;
    mutable QByteArray m_name;
    bool m_mounted = false;
};

QStringList withOption(QStringList arguments, const char *option, const QString &value)
{
    arguments[arguments.indexOf(QLatin1String(option)) + 1] = value;
    return arguments;
}

Program::Predicate works(bool yes)
{
    return [yes](const QJsonObject &event) { return event[QLatin1String("works")].toBool() == yes; };
}

bool hasVehicle(const QJsonObject &stats)
{
    return !stats[QLatin1String("vehicles")].toArray().isEmpty();
}

} // namespace

class DiskTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void fullDisk();
    void readOnlyDisk();
    void stationsDisk();
    void oldFilesStay();

private:
    std::unique_ptr<Program> monitor() const
    {
        return std::make_unique<Program>(QStringLiteral("skyseal-cli"),
                                         m_flight->monitorArguments({QStringLiteral("--no-record")}));
    }
    std::unique_ptr<Program> air(const SmallDisk &disk) const
    {
        const QStringList arguments = withOption(withOption(m_flight->airArguments(), "--identity", disk.path("air.key")),
                                                 "--peers", disk.path("air.peers"));
        return std::make_unique<Program>(QStringLiteral("skyseal-air"), arguments);
    }
    /// An agent whose disk fails by `fail` before its first session, and works again after `mend`.
    void agentsDiskFails(const SmallDisk &disk, const std::function<bool()> &fail, const std::function<bool()> &mend,
                         const char *problem);

    std::unique_ptr<Flight> m_flight;
    std::unique_ptr<Program> m_sim;
};

void DiskTest::initTestCase()
{
    SKYSEAL_REQUIRES("mounts");
    QVERIFY(::unshare(CLONE_NEWNS) == 0 && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0);
}

void DiskTest::init()
{
    m_flight = std::make_unique<Flight>();
    QVERIFY(m_flight->ready());
    m_sim = std::make_unique<Program>(QStringLiteral("skyseal-sim"), m_flight->simArguments());
}

void DiskTest::agentsDiskFails(const SmallDisk &disk, const std::function<bool()> &fail, const std::function<bool()> &mend,
                               const char *problem)
{
    QVERIFY(disk.isMounted() && disk.takes(m_flight->path(QStringLiteral("air.key")))
            && disk.takes(m_flight->path(QStringLiteral("air.peers"))));
    auto agent = air(disk);
    QVERIFY(!agent->waitFor(QStringLiteral("stats")).isEmpty());
    QVERIFY(fail());
    auto station = monitor();
    QVERIFY(!station->waitFor(QStringLiteral("session"), isUp).isEmpty()); // though its counter is not stored
    const QJsonObject alarm = agent->waitFor(QStringLiteral("counter_storage"), works(false));
    QVERIFY2(alarm[QLatin1String("problem")].toString().contains(QLatin1String(problem)),
             qPrintable(alarm[QLatin1String("problem")].toString()));
    QVERIFY(!agent
                 ->waitFor(QStringLiteral("stats"),
                           [](const QJsonObject &stats) { return stats.contains(QLatin1String("storage_problem")); })
                 .isEmpty());
    QVERIFY(!station->waitFor(QStringLiteral("agent_storage"), works(false)).isEmpty());
    QVERIFY(!station->waitFor(QStringLiteral("stats"), hasVehicle).isEmpty()); // the link goes on

    // The agent comes up again on that disk, and another session with it.
    agent->kill();
    agent = air(disk);
    QVERIFY(!agent->waitFor(QStringLiteral("session"), isUp).isEmpty());
    EVENTUALLY(!agent->events(QStringLiteral("counter_storage")).empty()); // before or after that
    QVERIFY(!station->waitFor(QStringLiteral("session"), isUp).isEmpty());
    QVERIFY(!station->waitFor(QStringLiteral("agent_storage"), works(false)).isEmpty());

    QVERIFY(mend());
    QVERIFY(!agent->waitFor(QStringLiteral("counter_storage"), works(true)).isEmpty());
    QVERIFY(!station->waitFor(QStringLiteral("agent_storage"), works(true)).isEmpty());
    QFile counters(disk.path("air.key.counters"));
    QVERIFY(counters.open(QIODevice::ReadOnly) && counters.readAll().contains("seen ")); // stored after all
}

void DiskTest::fullDisk()
{
    const SmallDisk disk(m_flight->path(QStringLiteral("disk")));
    agentsDiskFails(
        disk, [&] { return disk.fill(); }, [&] { return disk.empty(); }, "No space left on device");
}

void DiskTest::readOnlyDisk()
{
    const SmallDisk disk(m_flight->path(QStringLiteral("disk")));
    agentsDiskFails(
        disk, [&] { return disk.setReadOnly(true); }, [&] { return disk.setReadOnly(false); }, "Read-only file system");
}

void DiskTest::stationsDisk()
{
    const SmallDisk disk(m_flight->path(QStringLiteral("disk")));
    QVERIFY(disk.isMounted() && disk.takes(m_flight->path(QStringLiteral("ground.key")))
            && disk.takes(m_flight->path(QStringLiteral("ground.peers"))));
    const Program agent(QStringLiteral("skyseal-air"), m_flight->airArguments());
    const QStringList arguments = withOption(
        withOption(m_flight->monitorArguments({QStringLiteral("--no-record")}), "--identity", disk.path("ground.key")),
        "--peers", disk.path("ground.peers"));
    {
        Program station(QStringLiteral("skyseal-cli"), arguments);
        QVERIFY(!station.waitFor(QStringLiteral("session"), isUp).isEmpty());
        QCOMPARE(station.terminate(), 0);
    }
    QVERIFY(disk.fill());
    Program station(QStringLiteral("skyseal-cli"), arguments);
    QVERIFY(!station.waitFor(QStringLiteral("session"), isUp).isEmpty());
    EVENTUALLY(!station.events(QStringLiteral("counter_storage")).empty()); // before or after that
    QVERIFY(!works(true)(station.last(QStringLiteral("counter_storage"))));
    QVERIFY(!station.waitFor(QStringLiteral("stats"), hasVehicle).isEmpty());
    QVERIFY(disk.empty());
    QVERIFY(!station.waitFor(QStringLiteral("counter_storage"), works(true)).isEmpty());
}

/// A backup that cannot be renewed stays, and the exit status tells it.
void DiskTest::oldFilesStay()
{
    const SmallDisk disk(m_flight->path(QStringLiteral("disk")));
    QVERIFY(disk.isMounted());
    const Program agent(QStringLiteral("skyseal-air"), m_flight->airArguments());
    const QStringList link{QStringLiteral("--link"),     QStringLiteral("udpin:127.0.0.1:%1").arg(m_flight->groundPort),
                           QStringLiteral("--identity"), m_flight->path(QStringLiteral("ground.key")),
                           QStringLiteral("--peers"),    m_flight->path(QStringLiteral("ground.peers"))};
    const auto contentOf = [](const QString &path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
    };
    const QString parameters = disk.path("all.param"), mission = disk.path("flight.waypoints");
    const auto save = [&](const char *command, const QString &file) {
        return runProgram("skyseal-cli", words(command) + QStringList{file} + link);
    };
    const RunResult saved = save("param save", parameters);
    QVERIFY2(saved.status == 0, saved.err.constData());
    const QByteArray good = contentOf(parameters);
    QVERIFY(good.contains("RTL_ALT"));
    QVERIFY(disk.fill());
    const RunResult again = save("param save", parameters);
    QCOMPARE(again.status, 3);
    QVERIFY2(again.err.contains("all.param: cannot be written: No space left on device"), again.err.constData());
    QCOMPARE(contentOf(parameters), good);
    QCOMPARE(save("mission download", mission).status, 3);
    QVERIFY(!QFile::exists(mission));
    QVERIFY(disk.empty());
    QCOMPARE(save("param save", parameters).status, 0);
    QCOMPARE(contentOf(parameters), good);
}

SKYSEAL_TEST(DiskTest)
#include "disk_test.moc"
