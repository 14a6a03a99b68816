// The files written by a pairing, and hostile names of unknown devices.
#include "core/base/secret_bytes.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/paired_peer.h"
#include "core/keys/peer_line.h"
#include "core/keys/secret_file.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/seeded_random.h"
#include "tests/keys/temporary_folder.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::keys;
using channel::PeerRole;

class PairedPeerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void init() { m_file = m_folder.path(("peers" + std::to_string(++m_number)).c_str()); }
    void strangerIsAdded();
    void presharedKeyLiesBesideTheList();
    void knownKeyKeepsNameAndSystems();
    void systemOfAnotherAgentIsRefused();
    void changedKeyIsReplacedKnowingly();
    void namesAreMadeToFit_data();
    void namesAreMadeToFit();
    void anyNameFits();

private:
    channel::Peer peer(const char *name, std::uint8_t first, bool withSecret = false)
    {
        channel::Peer out;
        out.key.fill(first);
        out.name = name;
        if (withSecret) {
            Key32 secret;
            m_random.fill(secret.mutableView());
            out.presharedKey = std::make_shared<const Key32>(std::move(secret));
        }
        return out;
    }
    PeersFile list() const { return PeersFile::load(m_file).value(); }

    test::TemporaryFolder m_folder;
    test::SeededRandom m_random{3};
    std::string m_file;
    int m_number = 0;
};

void PairedPeerTest::strangerIsAdded()
{
    QVERIFY(keepPairedPeer(m_file, peer("scout", 1), KeyChange::Refused, SharedIds::Allowed));
    channel::Peer observer = peer("tablet", 2);
    observer.role = PeerRole::Observer;
    observer.systemIds = {254};
    QVERIFY(keepPairedPeer(m_file, observer, KeyChange::Refused, SharedIds::Allowed));
    QCOMPARE(list().entries().size(), std::size_t(2));
    QVERIFY(list().find("tablet")->peer.role == PeerRole::Observer);
    QCOMPARE(list().find("tablet")->peer.systemIds, std::vector<std::uint8_t>{254}); // as the pairing showed it
    QVERIFY(list().find("scout")->presharedKeyFile.empty());
    QCOMPARE(test::modeOf(m_file), mode_t(0600));
}

void PairedPeerTest::presharedKeyLiesBesideTheList()
{
    const channel::Peer paired = peer("scout", 1, true);
    QVERIFY(keepPairedPeer(m_file, paired, KeyChange::Refused, SharedIds::Allowed));
    const PeerEntry entry = *list().find("scout");
    QVERIFY(!entry.presharedKeyFile.starts_with('/')); // the folder can be moved as a whole
    const std::string file = presharedKeyPath(m_file, entry);
    QCOMPARE(test::modeOf(file), mode_t(0600));
    QVERIFY(loadPresharedKey(file)->equals(*paired.presharedKey));
    // Pairing again creates another one.
    const channel::Peer again = peer("scout", 1, true);
    QVERIFY(keepPairedPeer(m_file, again, KeyChange::Refused, SharedIds::Allowed));
    QVERIFY(loadPresharedKey(file)->equals(*again.presharedKey));
    QVERIFY(keepPairedPeer(m_file, peer("scout", 1), KeyChange::Refused, SharedIds::Allowed));
    QVERIFY(list().find("scout")->presharedKeyFile.empty());
}

void PairedPeerTest::knownKeyKeepsNameAndSystems()
{
    PeersFile file;
    PeerEntry known{peer("heron", 1), {}};
    known.peer.systemIds = {4};
    QVERIFY(file.add(known) && file.save(m_file));
    channel::Peer paired = peer("what it calls itself", 1);
    paired.role = PeerRole::Observer;
    paired.systemIds = {9};
    QVERIFY(keepPairedPeer(m_file, paired, KeyChange::Refused, SharedIds::Allowed));
    QCOMPARE(list().entries().size(), std::size_t(1));
    QCOMPARE(list().find("heron")->peer.systemIds, std::vector<std::uint8_t>{4});
    QVERIFY(list().find("heron")->peer.role == PeerRole::Observer);
}

void PairedPeerTest::systemOfAnotherAgentIsRefused()
{
    channel::Peer scout = peer("scout", 1), other = peer("other", 2, true);
    scout.systemIds = other.systemIds = {1};
    QVERIFY(keepPairedPeer(m_file, scout, KeyChange::Refused, SharedIds::Refused));
    const auto kept = keepPairedPeer(m_file, other, KeyChange::Refused, SharedIds::Refused);
    QVERIFY(!kept);
    QVERIFY2(kept.error().text().find("system ID 1 is bound to \"scout\"") != std::string::npos, kept.error().text().c_str());
    QCOMPARE(list().entries().size(), std::size_t(1));
    QVERIFY(keepPairedPeer(m_file, scout, KeyChange::Refused, SharedIds::Refused)); // again
    // Stations may share an id.
    QVERIFY(keepPairedPeer(m_file, other, KeyChange::Refused, SharedIds::Allowed));
    QCOMPARE(list().find("other")->peer.systemIds, std::vector<std::uint8_t>{1});
}

void PairedPeerTest::changedKeyIsReplacedKnowingly()
{
    QVERIFY(keepPairedPeer(m_file, peer("scout", 1, true), KeyChange::Refused, SharedIds::Allowed));
    QVERIFY(!keepPairedPeer(m_file, peer("scout", 2, true), KeyChange::Refused, SharedIds::Allowed));
    QCOMPARE(list().find("scout")->peer.key, peer("", 1).key);
    QVERIFY(keepPairedPeer(m_file, peer("scout", 2), KeyChange::Accepted, SharedIds::Allowed));
    QCOMPARE(list().find("scout")->peer.key, peer("", 2).key);
    QCOMPARE(list().entries().size(), std::size_t(1));
}

void PairedPeerTest::namesAreMadeToFit_data()
{
    QTest::addColumn<QByteArray>("claimed");
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("fit") << QByteArray("scout-1") << QByteArray("scout-1");
    QTest::newRow("blanks") << QByteArray(" my first  drone ") << QByteArray("my-first-drone");
    QTest::newRow("umlaut") << QByteArray("J\xc3\xbcrgen") << QByteArray("J\xc3\xbcrgen");
    QTest::newRow("steers a terminal") << QByteArray("\x1b[31mred") << QByteArray("31mred");
    QTest::newRow("a line more") << QByteArray("x\nmallory pilot any") << QByteArray("x-mallory-pilot-any");
    QTest::newRow("long") << QByteArray(50, 'n') << QByteArray(32, 'n');
    QTest::newRow("invisible") << QByteArray("sc\xe2\x80\x8bout\xe2\x80\xae") << QByteArray("sc-out");
    QTest::newRow("no UTF-8") << QByteArray("J\xfcrgen") << QByteArray("J-rgen");
    QTest::newRow("cut character") << QByteArray(31, 'n') + "\xc3\xbc" << QByteArray(31, 'n');
}

void PairedPeerTest::namesAreMadeToFit()
{
    QFETCH(QByteArray, claimed);
    QFETCH(QByteArray, name);
    QCOMPARE(QByteArray::fromStdString(fitPeerName(claimed.toStdString(), {})), name);
}

void PairedPeerTest::anyNameFits()
{
    for (int i = 0; i < 2000; ++i) {
        const Bytes bytes = m_random.bytes(m_random.number() % 60);
        PeerEntry entry;
        entry.peer.name = fitPeerName(asText(bytes), {});
        QVERIFY(checkPeerEntry(entry).has_value());
    }
    for (const char *nothing : {"", " ", "---", "\x01\x02"}) {
        const std::string name = fitPeerName(nothing, {});
        QVERIFY2(name.starts_with("peer-"), name.c_str());
    }
}

SKYSEAL_TEST_APPLESS(PairedPeerTest)
#include "paired_peer_test.moc"
