// The heap figure of a suite does not depend on what the rest of the program allocates meanwhile.
#include "core/crypto/init_crypto.h"
#include "core/experiment/cipher_bench.h"
#include "core/experiment/heap_figures.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <atomic>
#include <thread>
#include <vector>

#include <cerrno>
#include <sys/wait.h>

using namespace skyseal;
using namespace skyseal::experiment;

class HeapFiguresTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areThoseOfTheSuiteAlone();
    void leaveNoZombie();
};

void HeapFiguresTest::areThoseOfTheSuiteAlone()
{
    HeapFigures figures;
    std::atomic<bool> stop{false};
    std::thread other([&stop] {
        std::vector<std::unique_ptr<char[]>> blocks(4096);
        for (std::size_t i = 0; !stop; ++i)
            blocks[i % blocks.size()] = std::make_unique<char[]>(100 + i % 10000);
    });
    std::vector<std::optional<double>> context, session;
    for (const crypto::SuiteInfo &suite : crypto::suites()) {
        context.push_back(figures.context(suite.id));
        session.push_back(figures.session(suite.id));
    }
    stop = true;
    other.join();

    QVERIFY(crypto::initCrypto());
    std::size_t at = 0;
    for (const crypto::SuiteInfo &suite : crypto::suites()) {
        QCOMPARE(context[at].has_value(), contextBytes(suite.id).has_value());
        if (suite.id == crypto::SuiteId::None)
            QVERIFY(!session[at]);
        else if (const auto alone = sessionBytes(suite.id))
            QVERIFY2(
                std::abs(*session[at] - *alone) <= 0.05 * *alone,
                qPrintable(
                    QStringLiteral("%1: %2, alone %3").arg(QLatin1String(suite.name.data())).arg(*session[at]).arg(*alone)));
        ++at;
    }
}

void HeapFiguresTest::leaveNoZombie()
{
    HeapFigures figures;
    EVENTUALLY(figures.collectIfDone());
    QCOMPARE(::waitpid(-1, nullptr, WNOHANG), -1);
    QCOMPARE(errno, ECHILD);
    QCOMPARE(figures.context(crypto::SuiteId::Aes256Gcm).has_value(), contextBytes(crypto::SuiteId::Aes256Gcm).has_value());
}

SKYSEAL_TEST(HeapFiguresTest)
#include "heap_figures_test.moc"
