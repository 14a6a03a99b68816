// The command line that a sweep records, read by a shell and by the program's own parser: the same plan, whatever stands in it.
#include "app/cli/sweep_options.h"
#include "app/common/sweep_command_line.h"
#include "app/common/sweep_setting.h"
#include "core/experiment/setting.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::app;
using experiment::Load;
using experiment::Plan;

Q_DECLARE_METATYPE(Plan)

class SweepCommandLineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void argumentsRepeatTheSweep_data();
    void argumentsRepeatTheSweep();
    void planOfTheWindowIsRepeated_data();
    void planOfTheWindowIsRepeated();
    void settingHasTheProgramThatMeasures();

private:
    /// The words that a shell makes of the text, in an empty folder, which stays empty.
    static void readByShell(const QString &text, QStringList &words);
    static void compare(const Plan &one, const Plan &two);
};

static QStringList given(std::initializer_list<const char *> words)
{
    QStringList out;
    for (const char *word : words)
        out << QString::fromUtf8(word);
    return out;
}

void SweepCommandLineTest::readByShell(const QString &text, QStringList &words)
{
    QTemporaryDir folder;
    QProcess shell;
    shell.setWorkingDirectory(folder.path());
    shell.start(QStringLiteral("sh"), {QStringLiteral("-c"), QStringLiteral("printf '%s\\0' ") + text});
    QVERIFY(shell.waitForFinished(test::kDeadlineMs));
    QCOMPARE(shell.readAllStandardError(), QByteArray());
    QCOMPARE(shell.exitCode(), 0);
    QVERIFY(QDir(folder.path()).isEmpty());
    words = QString::fromUtf8(shell.readAllStandardOutput()).split(QChar(u'\0'));
    words.removeLast();
}

void SweepCommandLineTest::compare(const Plan &one, const Plan &two)
{
    QVERIFY(one.arms == two.arms);
    QVERIFY(one.loads == two.loads);
    QCOMPARE(one.conditions.size(), two.conditions.size());
    for (std::size_t i = 0; i < one.conditions.size(); ++i)
        QCOMPARE(one.conditions[i].name, two.conditions[i].name);
    QVERIFY(one.measure == two.measure && one.warmUp == two.warmUp);
    QCOMPARE(one.launches, two.launches);
    QCOMPARE(one.repeats, two.repeats);
    QCOMPARE(one.flight, two.flight);
    QCOMPARE(one.phases, two.phases);
    QCOMPARE(one.seed, two.seed);
    QCOMPARE(one.margin, two.margin);
}

void SweepCommandLineTest::argumentsRepeatTheSweep_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("none") << QStringList();
    QTest::newRow("natural load") << given({"--load", "natural", "--launches", "2"});
    QTest::newRow("all suites by name") << given({"--suites=all", "--impair", "clean", "--impair", "loss=0.05,delay=20"});
    QTest::newRow("all suites by two words") << given({"--suites", "all", "--seed", "7", "--framing", "all"});
    QTest::newRow("named suites") << given({"--suites", "none,aes-256-gcm", "--pps", "100,500", "--no-noise"});
    QTest::newRow("a flight") << given({"--vehicle", "tcp:127.0.0.1:5760", "--fly",
                                        "mode GUIDED; arm; takeoff 10 | wait alt_rel>=9 60; land; wait armed==0 90"});
    QTest::newRow("assertions") << given(
        {"--load", "natural", "--expect", "cpu(aes-256-gcm)<=1.1*cpu(chacha20)", "--out", "it's $HOME; `ls` > \"x\""});
}

void SweepCommandLineTest::argumentsRepeatTheSweep()
{
    QFETCH(QStringList, arguments);
    SweepOptions first, second;
    QVERIFY(!readSweepOptions(QStringLiteral("sweep"), arguments, first));
    for (const char *name : {"--suites", "--seed", "--impair"}) {
        const auto isIt = [name](const QString &word) { return word.section(QLatin1Char('='), 0, 0) == QLatin1String(name); };
        QVERIFY2(std::any_of(first.repeatedBy.begin(), first.repeatedBy.end(), isIt), name);
    }
    QStringList words;
    readByShell(shellText(first.repeatedBy), words);
    QCOMPARE(words, first.repeatedBy);
    QVERIFY(!words.contains(QStringLiteral("all")) || words.contains(QStringLiteral("--framing")));
    QVERIFY(!readSweepOptions(QStringLiteral("sweep"), words, second));
    compare(first.plan, second.plan);
    QCOMPARE(second.repeatedBy, words); // nothing was left to chance or to this machine
    QCOMPARE(second.folder, first.folder);
    QCOMPARE(second.expectations.size(), first.expectations.size());
    QCOMPARE(second.vehicle.has_value(), first.vehicle.has_value());
}

void SweepCommandLineTest::planOfTheWindowIsRepeated_data()
{
    QTest::addColumn<Plan>("plan");
    const std::vector<crypto::SuiteId> suites{crypto::SuiteId::ChaCha20Poly1305, crypto::SuiteId::Aes256Ctr};
    Plan plan;
    plan.arms = experiment::armsOf(suites, {experiment::ArmFraming::Sealed}, true);
    plan.loads = {Load::Natural, Load::Saturated};
    plan.repeats = 1;
    plan.seed = 4711;
    plan.margin = 0.05;
    plan.measure = std::chrono::milliseconds(2500);
    plan.warmUp = std::chrono::milliseconds(700);
    QTest::newRow("a clean link for a saturated load, one noisy run") << plan;
    plan.arms = experiment::armsOf(suites, {experiment::ArmFraming::Sealed, experiment::ArmFraming::Inline}, false);
    plan.loads = {Load::Natural, Load::paced(500)};
    plan.repeats = 3;
    plan.conditions = {*experiment::parseCondition("clean"), *experiment::parseCondition("loss=0.05,delay=20")};
    QTest::newRow("two framings, links and a paced load") << plan;
}

void SweepCommandLineTest::planOfTheWindowIsRepeated()
{
    QFETCH(Plan, plan);
    QStringList words;
    readByShell(shellText(sweepArguments(plan)), words);
    SweepOptions read;
    QVERIFY(!readSweepOptions(QStringLiteral("sweep"), words, read));
    compare(plan, read.plan);
    QCOMPARE(read.repeatedBy, words);
}

/// The window measures with its own station.
void SweepCommandLineTest::settingHasTheProgramThatMeasures()
{
    const experiment::Setting setting = describeSetting("1", QString());
    const std::string key = "sha256_" + QFileInfo(QCoreApplication::applicationFilePath()).fileName().toStdString();
    const auto found = std::find_if(setting.begin(), setting.end(), [&](const auto &entry) { return entry.first == key; });
    QVERIFY(found != setting.end());
    QCOMPARE(found->second.size(), std::size_t(64));
}

SKYSEAL_TEST(SweepCommandLineTest)
#include "sweep_command_line_test.moc"
