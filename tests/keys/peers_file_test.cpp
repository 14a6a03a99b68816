// The file of known peers: lists are read, changed and written, and comments are preserved.
#include "core/crypto/x25519.h"
#include "core/crypto/init_crypto.h"
#include "core/keys/peers_file.h"
#include "core/keys/public_key_text.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include "tests/crypto/seeded_random.h"
#include "tests/keys/error_text.h"
#include "tests/keys/temporary_folder.h"

#include <QtTest/QTest>

#include <thread>

#include <unistd.h>

using namespace skyseal;
using namespace skyseal::keys;
using channel::PeerRole;

class PeersFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void readsAList();
    void listOfAnotherUserIsRefused();
    void keepsRemarks();
    void errorsNameTheLine_data();
    void errorsNameTheLine();
    void addsRefusingDoubles();
    void replacesKnowingly();
    void removes();
    void savesAsAWhole();
    void renames();
    void tellsAChangedKeyFromAStranger();
    void editsUnderALock();
    void longListsAreRefused();

private:
    PeerEntry entry(const char *name, std::size_t key) const { return {{m_keys[key], name, PeerRole::Pilot, {}}, {}}; }
    std::string line(const std::string &front, std::size_t key) const { return front + " " + publicKeyText(m_keys[key]); }

    std::vector<PublicKey> m_keys;
    test::TemporaryFolder m_folder;
};

void PeersFileTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
    test::SeededRandom random(7);
    for (int i = 0; i < 4; ++i)
        m_keys.push_back(crypto::X25519KeyPair::generate(random).publicKey);
}

void PeersFileTest::readsAList()
{
    const auto file = PeersFile::parse(
        line("scout-1\tpilot  1,2,255", 0) + " psk=/etc/a.psk\r\n" + line("  tablet observer any", 1), "f");
    QVERIFY(file.has_value());
    const auto entries = file->entries();
    QCOMPARE(entries.size(), std::size_t(2));
    QCOMPARE(entries[0].peer.name, std::string("scout-1"));
    QCOMPARE(entries[0].peer.role, PeerRole::Pilot);
    QCOMPARE(entries[0].peer.systemIds, (std::vector<std::uint8_t>{1, 2, 255}));
    QCOMPARE(entries[0].peer.key, m_keys[0]);
    QCOMPARE(entries[0].presharedKeyFile, std::string("/etc/a.psk"));
    QCOMPARE(entries[1].peer.role, PeerRole::Observer);
    QVERIFY(entries[1].peer.systemIds.empty() && entries[1].presharedKeyFile.empty());
    QCOMPARE(file->peers().size(), std::size_t(2));
    QVERIFY(PeersFile::parse("", "f")->entries().empty());
}

void PeersFileTest::listOfAnotherUserIsRefused()
{
    SKYSEAL_REQUIRES("superuser");
    const std::string path = m_folder.write("foreign.peers", line("a pilot 1", 0) + "\n");
    QCOMPARE(test::errorOf(loadPeers(path)), std::string());
    QCOMPARE(::chown(path.c_str(), test::kSomebodyElse, 0), 0);
    QVERIFY(test::contains(test::errorOf(loadPeers(path)), "another user"));
}

void PeersFileTest::keepsRemarks()
{
    const std::string text = "# our vehicles\n\n" + line("scout   pilot  1", 0) + "\n   # the tablet is Ann's\n"
        + line("tablet observer any", 1) + "\n";
    auto file = PeersFile::parse(text, "f");
    QCOMPARE(file->text(), text);
    QVERIFY(file->add(entry("third", 2)));
    QVERIFY(file->text().starts_with(text));
    QVERIFY(file->remove("scout"));
    QCOMPARE(file->text(),
             "# our vehicles\n\n   # the tablet is Ann's\n" + line("tablet observer any", 1) + "\n" + line("third pilot any", 2)
                 + "\n");
    // Added entries read back.
    QCOMPARE(PeersFile::parse(file->text(), "f")->entries()[1].peer.key, m_keys[2]);
}

void PeersFileTest::errorsNameTheLine_data()
{
    QTest::addColumn<QString>("bad");
    QTest::addColumn<QString>("part");
    const auto row = [](const char *name, const std::string &bad, const char *part) {
        QTest::newRow(name) << QString::fromStdString(bad) << QString::fromUtf8(part);
    };
    row("few fields", "scout pilot", "here are 2 fields");
    row("many fields", line("scout pilot 1", 0) + " psk=a b", "here are 6 fields");
    row("role", line("scout captain 1", 0), "\"captain\" is not a role");
    row("system ID 0", line("scout pilot 0", 0), "\"0\" is not a list of system IDs");
    row("system ID 256", line("scout pilot 1,256", 0), "\"1,256\" is not a list");
    row("empty id", line("scout pilot 1,", 0), "is not a list");
    row("sign", line("scout pilot -1", 0), "is not a list");
    row("key", "scout pilot 1 skyseal:AAAA", "is not a public key");
    row("psk", line("scout pilot 1", 0) + " key=x", "psk=FILE");
    row("no psk", line("scout pilot 1", 0) + " psk=", "psk=FILE");
    row("name", line("a/b pilot 1", 0), "is not a peer's name");
    row("long name", line(std::string(33, 'n') + " pilot 1", 0), "is not a peer's name");
    row("control character in a name", line("sc\x1b[2Jout pilot 1", 0), "is not a peer's name");
    row("C1 control", line("ab\xc2\x9bz pilot 1", 0), "\"ab?z\" is not a peer's name: character 3 is U+009B, a control");
    row("direction override", line("gp\xe2\x80\xaej pilot 1", 0), "\"gp?j\" is not a peer's name: character 3 is U+202E");
    row("zero width", line("sc\xe2\x80\x8bout pilot 1", 0), "character 3 is U+200B");
    row("blank beyond ASCII", line("sc\xc2\xa0out pilot 1", 0), "character 3 is U+00A0, a blank");
    row("like an option", line("--role pilot 1", 0), "must not begin with \"-\"");
    row("double name", line("first pilot 1", 0), "named \"first\" already");
    row("double key", line("scout pilot 1", 3), "\"first\" has the same key");
    row("control character", line("scout \x1b[31m 1", 0), "\"?[31m\" is not a role");
}

void PeersFileTest::errorsNameTheLine()
{
    QFETCH(QString, bad);
    QFETCH(QString, part);
    const auto file = PeersFile::parse(line("first pilot 1", 3) + "\n# remark\n" + bad.toStdString() + "\n", "peers.txt");
    QVERIFY(!file);
    const QString error = QString::fromStdString(file.error().text());
    QVERIFY2(error.startsWith(QLatin1String("peers.txt:3: ")) && error.contains(part), qPrintable(error));
}

void PeersFileTest::addsRefusingDoubles()
{
    PeersFile file;
    QVERIFY(file.add(entry("a", 0)));
    QVERIFY(!file.add(entry("a", 1)));
    QVERIFY(!file.add(entry("b", 0)));
    QVERIFY(!file.add(entry("", 1)));
    QVERIFY(!file.add(entry("two words", 1)));
    QVERIFY(!file.add(entry("#a", 1)));
    const auto damaged = file.add(entry("J\xfcrgen", 1));
    QVERIFY(!damaged && damaged.error().message.text().find("character 2 is not valid UTF-8") != std::string::npos);
    PeerEntry newline = entry("c", 1);
    newline.presharedKeyFile = "x\nmallory pilot any skyseal:";
    QVERIFY(!file.add(newline));
    QVERIFY(file.add(entry("J\xc3\xbcrgen", 1)));
    QCOMPARE(file.entries().size(), std::size_t(2));
}

void PeersFileTest::replacesKnowingly()
{
    PeersFile file;
    QVERIFY(file.add(entry("a", 0)));
    QVERIFY(file.add(entry("b", 1)));
    PeerEntry changed = entry("a", 2);
    changed.peer.role = PeerRole::Observer;
    changed.peer.systemIds = {9};
    QVERIFY(file.replace(changed));
    QCOMPARE(file.find("a")->peer.key, m_keys[2]);
    QCOMPARE(file.text(), line("a observer 9", 2) + "\n" + line("b pilot any", 1) + "\n");
    QVERIFY(!file.replace(entry("a", 1))); // the key of another peer
    QVERIFY(!file.replace(entry("c", 3)));
}

void PeersFileTest::removes()
{
    PeersFile file;
    QVERIFY(file.add(entry("a", 0)));
    QVERIFY(!file.remove("b"));
    QVERIFY(file.remove("a"));
    QVERIFY(!file.find("a") && file.text().empty());
}

void PeersFileTest::savesAsAWhole()
{
    const std::string path = m_folder.path("peers");
    QVERIFY(!PeersFile::load(path));
    auto file = PeersFile::loadOrEmpty(path);
    QVERIFY(file && file->add(entry("a", 0)));
    QVERIFY(file->save(path));
    QCOMPARE(test::modeOf(path), mode_t(0600));
    ::chmod(path.c_str(), 0644);
    QVERIFY(file->add(entry("b", 1)) && file->save(path));
    QCOMPARE(test::modeOf(path), mode_t(0644));
    QCOMPARE(loadPeers(path)->size(), std::size_t(2));
    QVERIFY(!file->save(m_folder.path("no/such/folder")));
}

void PeersFileTest::renames()
{
    PeersFile file;
    PeerEntry known = entry("a", 0);
    known.peer.role = PeerRole::Observer;
    known.peer.systemIds = {3, 4};
    known.presharedKeyFile = "/etc/a.psk";
    QVERIFY(file.add(known) && file.add(entry("b", 1)));
    QVERIFY(!file.rename("c", "d"));
    QVERIFY(!file.rename("a", "b"));
    QVERIFY(!file.rename("a", "no blanks"));
    QVERIFY(file.rename("a", "c"));
    QVERIFY(file.rename("c", "c")); // its own name
    QCOMPARE(file.text(), line("c observer 3,4", 0) + " psk=/etc/a.psk\n" + line("b pilot any", 1) + "\n");
}

void PeersFileTest::tellsAChangedKeyFromAStranger()
{
    PeersFile file;
    QVERIFY(file.add(entry("a", 0)));
    QVERIFY(file.acquaintance("a", m_keys[0]) == Acquaintance::Known);
    QVERIFY(file.acquaintance("a", m_keys[1]) == Acquaintance::KeyChanged);
    QVERIFY(file.acquaintance("b", m_keys[0]) == Acquaintance::OtherName);
    QVERIFY(file.acquaintance("b", m_keys[1]) == Acquaintance::Stranger);
    QCOMPARE(file.findKey(m_keys[0])->peer.name, std::string("a"));
    QVERIFY(!file.findKey(m_keys[1]));
}

void PeersFileTest::editsUnderALock()
{
    const std::string path = m_folder.path("edited");
    // Two writers add peers repeatedly; none is lost.
    const auto writer = [&](std::size_t first) {
        for (std::size_t i = first; i < 4; i += 2)
            QVERIFY(editPeers(path, [&](PeersFile &file) { return file.add(entry(("p" + std::to_string(i)).c_str(), i)); }));
    };
    std::thread one(writer, 0), two(writer, 1);
    one.join();
    two.join();
    QCOMPARE(loadPeers(path)->size(), std::size_t(4));
    const auto refused = editPeers(path, [&](PeersFile &file) {
        file.remove("p0");
        return file.add(entry("p1", 0));
    });
    QVERIFY(refused.error().text().starts_with(path));
    QCOMPARE(loadPeers(path)->size(), std::size_t(4)); // an edit that fails changes nothing
}

void PeersFileTest::longListsAreRefused()
{
    test::SeededRandom random(8);
    std::string text = "# the longest list\n";
    PublicKey key{};
    for (std::size_t i = 0; i < PeersFile::kMostPeers; ++i) {
        random.fill(key);
        text += "peer-" + std::to_string(i) + " pilot any " + publicKeyText(key) + "\n";
    }
    auto longest = PeersFile::parse(text, "f");
    QVERIFY2(longest.has_value(), longest ? "" : longest.error().text().c_str());
    QCOMPARE(longest->peers().size(), PeersFile::kMostPeers);
    const auto refused = PeersFile::parse(text + line("another pilot any", 0) + "\n", "f");
    QVERIFY(!refused);
    QCOMPARE(refused.error().text(), std::string("f:258: a list has at most 256 peers"));
    QVERIFY(!longest->add(entry("another", 0)));
    PeerEntry changed = longest->entries().back();
    changed.peer.role = PeerRole::Observer;
    QVERIFY(longest->replace(changed)); // one of those that are listed
}

SKYSEAL_TEST_APPLESS(PeersFileTest)
#include "peers_file_test.moc"
