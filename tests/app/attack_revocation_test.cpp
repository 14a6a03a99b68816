// A peer is taken off the list where the system does not notify of the change: its session must not go on.
#include "app/common/peers_watch.h"
#include "tests/app/inotify_double.h"
#include "tests/support/eventually.h"
#include "tests/support/holds.h"
#include "tests/support/test_runner.h"

#include <QtCore/QElapsedTimer>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
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
    // Within two seconds; a machine that stalls may miss that once or twice.
    constexpr int kAttempts = 3, kLimitMs = 2000;
    bool inTime = false;
    for (int attempt = 0; attempt < kAttempts && !inTime; ++attempt) {
        const int before = applied;
        QVERIFY(write(attempt % 2 ? "pilot and thief" : "pilot"));
        QElapsedTimer clock;
        clock.start();
        inTime = QTest::qWaitFor([&] { return applied > before; }, 2 * kLimitMs) && clock.elapsed() <= kLimitMs;
    }
    HOLDS(inTime, "a removed peer loses its session");
}

SKYSEAL_TEST(AttackRevocationTest)
#include "attack_revocation_test.moc"
