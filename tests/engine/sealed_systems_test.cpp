// The file of systems that were heard over sealed links.
#include "core/engine/common/sealed_systems.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <fstream>

using namespace skyseal;
using namespace skyseal::engine;

class SealedSystemsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void missingFileIsEmpty();
    void readsWhatItWrote();
    void damageIsReported_data();
    void damageIsReported();

private:
    std::string path(const char *name) const { return m_folder.filePath(QLatin1String(name)).toStdString(); }
    QTemporaryDir m_folder;
};

void SealedSystemsTest::missingFileIsEmpty()
{
    const auto read = readSealedSystems(path("none"));
    QVERIFY(read);
    QVERIFY(read->empty());
}

void SealedSystemsTest::readsWhatItWrote()
{
    SealedSystems systems;
    for (std::uint8_t number = 1; number < 5; ++number) {
        channel::PublicKey key{};
        key.fill(number);
        systems[key].set(number);
        systems[key].set(255);
    }
    QVERIFY(writeSealedSystems(path("systems"), systems));
    QVERIFY(*readSealedSystems(path("systems")) == systems);
    QVERIFY(writeSealedSystems(path("systems"), {}));
    QVERIFY(readSealedSystems(path("systems"))->empty());
}

void SealedSystemsTest::damageIsReported_data()
{
    QTest::addColumn<QByteArray>("line");
    const QByteArray key(64, 'a');
    QTest::newRow("no key") << QByteArray("1");
    QTest::newRow("short key") << QByteArray("1 abcd");
    QTest::newRow("no system") << " " + key;
    QTest::newRow("system too large") << "256 " + key;
    QTest::newRow("no hex") << "1 " + QByteArray(64, 'x');
    QTest::newRow("more behind") << "1 " + key + " 2";
}

void SealedSystemsTest::damageIsReported()
{
    QFETCH(QByteArray, line);
    std::ofstream(path("damaged")) << "7 " << std::string(64, 'b') << "\n" << line.toStdString() << "\n";
    const auto read = readSealedSystems(path("damaged"));
    QVERIFY(!read);
    QCOMPARE(read.error().line, std::size_t(2));
    QCOMPARE(read.error().source, path("damaged"));
}

SKYSEAL_TEST(SealedSystemsTest)
#include "sealed_systems_test.moc"
