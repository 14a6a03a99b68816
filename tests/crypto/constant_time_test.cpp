// No branch and no address depends on a key when records are opened and secrets compared: Valgrind tracks undefined keys
// through the probe. Two cases prove that it detects violations: a comparison that stops early, and RC4, whose tables are
// indexed by its key (one reason for which it is a research suite). Repeated with CPU instructions masked: OpenSSL then uses
// tables in some suites, which must be detected, and must not in the others.
#include "core/crypto/suite.h"
#include "tests/support/eventually.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"

#include <QtCore/QProcess>
#include <QtCore/QStandardPaths>
#include <QtTest/QTest>

#include <algorithm>
#include <array>

using namespace skyseal;
using crypto::SuiteId;

namespace {

/// Whether OPENSSL_ia32cap can hide instructions of the CPU from OpenSSL.
#if defined(__x86_64__)
constexpr bool kCanBeMasked = true;
#else
constexpr bool kCanBeMasked = false;
#endif

// CPU features that are hidden from OpenSSL: bits of CPUID leaf 1, ECX in the upper half.
constexpr const char *kNoAes = "~0x200000000000000";
constexpr const char *kNoAesNorShuffle = "~0x200020000000000";
constexpr const char *kNoCarrylessMultiply = "~0x200000000";

// Suites whose tables are indexed by secrets, always and without AES instructions; secretBranchIsCaught() shows it for each.
constexpr std::array kLeaking{SuiteId::Rc4};
constexpr std::array kLeakingWithoutAes{SuiteId::Rc4, SuiteId::Aes256Gcm, SuiteId::Aes256Cbc};

/// One row for each other suite, unless the mask is not possible, and one for its form for frames sealed in place.
void addSuites(std::span<const SuiteId> leaking, const char *machine, const char *mask)
{
    for (const SuiteId suite : crypto::sealedSuites()) {
        if (std::ranges::find(leaking, suite) != leaking.end() || (*mask && !kCanBeMasked))
            continue;
        const crypto::SuiteInfo &info = crypto::suiteInfo(suite);
        const QString name = QString::fromStdString(std::string(info.name));
        QTest::addRow("open %s%s", qPrintable(name), machine)
            << QStringList{QStringLiteral("open"), name} << QString::fromLatin1(mask);
        if (info.makeInline)
            QTest::addRow("inline %s%s", qPrintable(name), machine)
                << QStringList{QStringLiteral("inline"), name} << QString::fromLatin1(mask);
    }
}

} // namespace

class ConstantTimeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void keysDecideNothing_data();
    void keysDecideNothing();
    void secretBranchIsCaught_data();
    void secretBranchIsCaught();

private:
    static constexpr int kCaught = 99;
    int probe(const QStringList &arguments, const QString &mask);
    QString m_valgrind;
    QByteArray m_output;
};

void ConstantTimeTest::initTestCase()
{
    SKYSEAL_REQUIRES("valgrind");
    m_valgrind = QStandardPaths::findExecutable(QStringLiteral("valgrind"));
}

int ConstantTimeTest::probe(const QStringList &arguments, const QString &mask)
{
    QProcess process;
    if (!mask.isEmpty()) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("OPENSSL_ia32cap"), mask);
        process.setProcessEnvironment(environment);
    }
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(m_valgrind,
                  QStringList{QStringLiteral("-q"), QStringLiteral("--error-exitcode=%1").arg(kCaught),
                              QStringLiteral("--suppressions=" SKYSEAL_SOURCE_DIR "/tests/crypto/constant_time.supp"),
                              QStringLiteral(SKYSEAL_PROBE)}
                      + arguments);
    const bool ended = process.waitForFinished(2 * test::kDeadlineMs) && process.exitStatus() == QProcess::NormalExit;
    m_output = process.readAll();
    return ended ? process.exitCode() : -1;
}

void ConstantTimeTest::keysDecideNothing_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("mask");
    addSuites(kLeaking, "", "");
    addSuites(kLeakingWithoutAes, " without AES instructions", kNoAes);
    QTest::newRow("compare") << QStringList{QStringLiteral("compare")} << QString();
}

void ConstantTimeTest::keysDecideNothing()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, mask);
    const int status = probe(arguments, mask);
    QVERIFY2(status == 0 && m_output.contains("done"), m_output.constData());
}

void ConstantTimeTest::secretBranchIsCaught_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("mask");
    const auto open = [](const char *suite) { return QStringList{QStringLiteral("open"), QLatin1String(suite)}; };
    QTest::newRow("a comparison that stops early") << QStringList{QStringLiteral("self-test")} << QString();
    QTest::newRow("rc4") << open("rc4") << QString();
    if (!kCanBeMasked)
        return;
    // These also prove that the masks work, and show the limits that THREATS.md states.
    QTest::newRow("gcm without AES instructions") << open("aes-256-gcm") << QString::fromLatin1(kNoAes);
    QTest::newRow("cbc without AES instructions") << open("aes-256-cbc") << QString::fromLatin1(kNoAes);
    QTest::newRow("gcm without PCLMULQDQ") << open("aes-256-gcm") << QString::fromLatin1(kNoCarrylessMultiply);
    QTest::newRow("ctr without AES instructions and SSSE3") << open("aes-256-ctr") << QString::fromLatin1(kNoAesNorShuffle);
}

void ConstantTimeTest::secretBranchIsCaught()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, mask);
    QCOMPARE(probe(arguments, mask), kCaught);
    QVERIFY2(m_output.contains("ninitialised value"), m_output.constData());
}

SKYSEAL_TEST(ConstantTimeTest)
#include "constant_time_test.moc"
