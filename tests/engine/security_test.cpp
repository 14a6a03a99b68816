// When the security state is "under attack": for every forged record, and for more copies than a network can make of the
// original records.
#include "core/engine/station/snapshot.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal::engine;

class SecurityTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void attacks_data();
    void attacks();
};

void SecurityTest::attacks_data()
{
    QTest::addColumn<int>("good");
    QTest::addColumn<int>("forged");
    QTest::addColumn<int>("replayed");
    QTest::addColumn<bool>("attacked");
    QTest::newRow("quiet") << 3000 << 0 << 0 << false;
    QTest::newRow("a network that doubles one datagram in five") << 3000 << 0 << 600 << false;
    QTest::newRow("a network that doubles all of them") << 3000 << 0 << 3000 << false;
    QTest::newRow("more copies than originals") << 3000 << 0 << 3001 << true;
    QTest::newRow("replays while the peer is silent") << 0 << 0 << 1 << true;
    QTest::newRow("one forged record") << 3000 << 1 << 0 << true;
}

void SecurityTest::attacks()
{
    QFETCH(int, good);
    QFETCH(int, forged);
    QFETCH(int, replayed);
    QFETCH(bool, attacked);
    Snapshot snapshot;
    SessionSnapshot &session = snapshot.sessions.emplace_back();
    session.goodLastMinute = static_cast<std::uint64_t>(good);
    session.forgedLastMinute = static_cast<std::uint64_t>(forged);
    session.replayedLastMinute = static_cast<std::uint64_t>(replayed);
    QCOMPARE(int(securityOf(snapshot)), int(attacked ? Security::UnderAttack : Security::Sealed));
}

SKYSEAL_TEST_APPLESS(SecurityTest)
#include "security_test.moc"
