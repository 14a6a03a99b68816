// Counters on disk never repeat, with killed processes and with several processes.
#include "core/crypto/init_crypto.h"
#include "core/keys/counter_file.h"
#include "tests/support/test_runner.h"

#include "tests/keys/temporary_folder.h"

#include <QtTest/QTest>

#include <csignal>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::keys;

class CounterFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }
    void countsOverRestarts();
    void twoProgramsNeverShareANumber();
    void killedInTheMiddleNeverRepeats();
    void skipsAhead();
    void remembersPeers();
    void refusesDamagedFiles();
    void survivesAFullOrReadOnlyDisk();

private:
    test::TemporaryFolder m_folder;
};

void CounterFileTest::countsOverRestarts()
{
    const std::string path = m_folder.path("counters");
    std::uint64_t last = 0;
    for (int run = 0; run < 5; ++run) {
        const auto store = FileCounterStore::open(path);
        QVERIFY(store.has_value());
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t number = (*store)->next();
            QVERIFY(number > last);
            last = number;
        }
    }
    QCOMPARE(last, std::uint64_t(15));
    QCOMPARE((*FileCounterStore::open(m_folder.path("later"), 1000))->next(), std::uint64_t(1000));
    QCOMPARE((*FileCounterStore::open(path, 1000))->next(), std::uint64_t(1000)); // at least the given start
}

void CounterFileTest::twoProgramsNeverShareANumber()
{
    const std::string path = m_folder.path("shared");
    const auto one = FileCounterStore::open(path);
    const auto other = FileCounterStore::open(path);
    std::uint64_t last = 0;
    for (int i = 0; i < 20; ++i) {
        for (const auto *store : {&one, &other}) {
            const std::uint64_t number = (**store)->next();
            QVERIFY(number > last);
            last = number;
        }
    }
    channel::PublicKey peer{};
    QVERIFY((*one)->remember(peer, 5) && (*other)->remember(peer, 3));
    QCOMPARE((*FileCounterStore::open(path))->lastSeen(peer), std::uint64_t(5));
}

/// A child process counts and reports each number through a pipe until SIGKILL; later numbers must be greater.
void CounterFileTest::killedInTheMiddleNeverRepeats()
{
    const std::string path = m_folder.path("killed");
    std::uint64_t last = 0;
    for (int round = 0; round < 20; ++round) {
        int ends[2];
        QCOMPARE(::pipe(ends), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            const auto store = FileCounterStore::open(path);
            while (store) {
                const std::uint64_t number = (*store)->next();
                if (::write(ends[1], &number, sizeof number) != sizeof number)
                    break;
            }
            ::_exit(1);
        }
        ::close(ends[1]);
        std::uint64_t number = 0;
        for (int i = 0; i <= round % 7; ++i) {
            QCOMPARE(::read(ends[0], &number, sizeof number), ssize_t(sizeof number));
            QVERIFY(number > last);
            last = number;
        }
        ::kill(child, SIGKILL);
        while (::read(ends[0], &number, sizeof number) == ssize_t(sizeof number)) { // numbers reported before the kill
            QVERIFY(number > last);
            last = number;
        }
        ::close(ends[0]);
        QCOMPARE(::waitpid(child, nullptr, 0), child);
    }
    const auto store = FileCounterStore::open(path);
    QVERIFY2(store.has_value(), store ? "" : store.error().text().c_str());
    QVERIFY((*store)->next() > last);
}

void CounterFileTest::skipsAhead()
{
    const std::string path = m_folder.path("skipping");
    auto store = std::move(*FileCounterStore::open(path));
    QVERIFY(store->skipTo(1000));
    QCOMPARE(store->next(), std::uint64_t(1001));
    QVERIFY(store->skipTo(5)); // never decreases
    QCOMPARE(store->next(), std::uint64_t(1002));
    QCOMPARE((*FileCounterStore::open(path))->next(), std::uint64_t(1003));
}

void CounterFileTest::remembersPeers()
{
    const std::string path = m_folder.path("seen");
    channel::PublicKey one{};
    channel::PublicKey other{};
    other[0] = 1;
    {
        const auto store = FileCounterStore::open(path);
        QCOMPARE((*store)->lastSeen(one), std::uint64_t(0));
        QVERIFY((*store)->remember(one, 17) && (*store)->remember(other, ~std::uint64_t(0)));
        QVERIFY((*store)->remember(one, 4));
        QCOMPARE((*store)->lastSeen(one), std::uint64_t(17)); // never decreases
    }
    const auto store = FileCounterStore::open(path);
    QCOMPARE((*store)->lastSeen(one), std::uint64_t(17));
    QCOMPARE((*store)->lastSeen(other), ~std::uint64_t(0));
}

void CounterFileTest::refusesDamagedFiles()
{
    const std::string key(64, 'a');
    const std::string good = "skyseal-counters-v1\nnext 12\nseen " + key + " 34\n";
    QVERIFY(Counters::parse(good, "f").has_value());
    QCOMPARE(Counters::parse(good, "f")->text(), good);
    for (std::size_t size = 0; size < good.size(); ++size) {
        const auto cut = Counters::parse(good.substr(0, size), "f");
        QVERIFY2(!cut || good.substr(0, size).ends_with("next 12\n"), std::to_string(size).c_str());
    }
    for (const char *bad :
         {"next -1", "next 18446744073709551616", "next 1x", "next ", "next 1\nnext 2", "seen 12 3", "what 1"})
        QVERIFY2(!Counters::parse(std::string("skyseal-counters-v1\n") + bad + "\n", "f"), bad);
    const auto refused = FileCounterStore::open(m_folder.write("damaged", "skyseal-counters-v1\nnext 1\nseen\n"));
    QVERIFY(!refused && refused.error().line == 3);
    QVERIFY(!FileCounterStore::open(m_folder.path("no/such/folder")));
}

void CounterFileTest::survivesAFullOrReadOnlyDisk()
{
    if (::geteuid() == 0)
        QSKIP("root may write everywhere");
    const std::string path = m_folder.path("frozen");
    const auto store = FileCounterStore::open(path);
    const std::uint64_t before = (*store)->next();
    ::chmod(m_folder.path(".").c_str(), 0500);
    const std::uint64_t after = (*store)->next();
    const bool remembered = (*store)->remember({}, 1);
    ::chmod(m_folder.path(".").c_str(), 0700);
    QVERIFY(after > before);
    QVERIFY(!remembered && !(*store)->lastError().message.empty());
}

SKYSEAL_TEST_APPLESS(CounterFileTest)
#include "counter_file_test.moc"
