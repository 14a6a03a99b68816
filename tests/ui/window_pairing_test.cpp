// The window's pairing when there is no station.
#include "app/skyseal/window_pairing.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/passphrase.h"
#include "core/crypto/system_random.h"
#include "core/keys/secret_file.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::app;

class WindowPairingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(crypto::initCrypto());
        crypto::SystemRandom random;
        m_config.keys = {m_folder.filePath(QStringLiteral("ground.key")).toStdString(),
                         m_folder.filePath(QStringLiteral("ground.peers")).toStdString()};
        QVERIFY(keys::writeNewIdentity(m_config.keys.identity, random));
        QVERIFY(QFile(QString::fromStdString(m_config.keys.peers)).open(QIODevice::WriteOnly));
        m_config.record = false;
    }

    void pairingWithoutAStationFails()
    {
        auto station = engine::Station::create(m_config);
        QVERIFY(station);
        StationAdapter adapter(std::move(*station));
        WindowPairing pairing;
        pairing.use(adapter, m_config.keys.peers);
        engine::StationConfig broken = m_config;
        broken.keys.identity = m_folder.filePath(QStringLiteral("missing.key")).toStdString();
        adapter.exchange(broken);
        QVERIFY(!adapter.isRunning());
        QSignalSpy failed(&pairing, &ui::PairingInterface::failed);
        pairing.open(std::nullopt);
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().contains(QStringLiteral("not running")));
        pairing.confirm({}, QStringLiteral("air-1"), false);
        pairing.refuse();
        pairing.cancel();
    }

private:
    QTemporaryDir m_folder;
    engine::StationConfig m_config;
};

SKYSEAL_TEST_WIDGETS(WindowPairingTest)
#include "window_pairing_test.moc"
