// A peer is taken off the list where the system does not notify of the change: its session must not go on.
#include "app/common/peers_watch.h"
#include "tests/app/inotify_double.h"
#include "tests/support/eventually.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::app;
using namespace skyseal::test;

class AttackRevocationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { inotifyIs = Inotify::Works; }
    void removedWithoutNotification_data();
    void removedWithoutNotification();
};

void AttackRevocationTest::removedWithoutNotification_data()
{
    QTest::addColumn<int>("inotify");
    QTest::newRow("no watches left") << int(Inotify::UsedUp);
    QTest::newRow("silent") << int(Inotify::Silent);
}

void AttackRevocationTest::removedWithoutNotification()
{
    QFETCH(int, inotify);
    inotifyIs = static_cast<Inotify>(inotify);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("peers"));
    const auto write = [&path](const char *content) {
        QFile file(path);
        return file.open(QIODevice::WriteOnly | QIODevice::Truncate) && file.write(content) > 0;
    };
    QVERIFY(write("pilot and thief"));
    int applied = 0;
    const PeersWatch watch(
        path.toStdString(), [] { return Result<keys::UsablePeers, InputError>(keys::UsablePeers{}); },
        [&](const auto &) { ++applied; });
    EVENTUALLY_EQUAL(applied, 1);
    // Within two seconds of the thread that looks: a machine that stalls delays this timer as well.
    constexpr int kTickMs = 100, kLimitTicks = 20;
    QTimer tick;
    int ticks = 0;
    QObject::connect(&tick, &QTimer::timeout, &tick, [&] { ticks += applied > 1 ? 0 : 1; });
    QVERIFY(write("pilot"));
    tick.start(kTickMs);
    EVENTUALLY(applied > 1 || ticks > kLimitTicks);
    HOLDS(ticks <= kLimitTicks, "a removed peer loses its session");
}

SKYSEAL_TEST(AttackRevocationTest)
#include "attack_revocation_test.moc"
