// The arm of the paper's own setting, a cipher without HMAC, by the real programs: it is measured in one block with the others,
// and what another key decrypts is no figure.
#include "core/crypto/system_random.h"
#include "core/experiment/sweep_runner.h"
#include "core/keys/file_io.h"
#include "tests/support/eventually.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <array>
#include <cmath>
#include <map>
#include <set>

using namespace skyseal;
using namespace skyseal::experiment;
using namespace skyseal::test;
using crypto::SuiteId;

class BareSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bareStandsBesideTheOthers();
    void theKeyDecides_data();
    void theKeyDecides();
};

void BareSweepTest::bareStandsBesideTheOthers()
{
    QTemporaryDir folder;
    const RunResult run = runProgram("skyseal-cli",
                                     words("sweep --suites aes-256-ctr,chacha20,none --framing all --launches 1 --load natural "
                                           "--seconds 2 --warm-up 0.3 --repeats 2 --no-noise --expect loss<=0 --out")
                                         + QStringList{folder.path()},
                                     {}, 240000);
    QVERIFY2(run.status == 0, run.err.constData());
    QFile file(folder.filePath(QStringLiteral("sweep.json")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
    std::map<QString, int> measured, answered;
    std::map<int, std::set<QString>> blocks;
    for (const QJsonValue sample : report[QLatin1String("samples")].toArray()) {
        const QString arm = sample[QLatin1String("suite")].toString() + QLatin1Char(' ')
            + sample[QLatin1String("framing")].toString();
        ++measured[arm];
        blocks[sample[QLatin1String("repeat")].toInt()].insert(arm);
        const QJsonObject values = sample[QLatin1String("values")].toObject();
        QVERIFY2(sample[QLatin1String("problem")].toString().isEmpty() && sample[QLatin1String("valid")].toBool(),
                 qPrintable(arm));
        QVERIFY(values[QLatin1String("packets")].toDouble() >= 20);
        QCOMPARE(values[QLatin1String("loss")].toDouble(-1), 0.0);
        // The vehicle answers five times a second, and the answers are decrypted. A busy machine may delay those of one run.
        const QJsonValue latency = values[QLatin1String("latency")];
        QVERIFY(latency.isNull() || latency.toDouble() > 0);
        answered[arm] += latency.toDouble() > 0;
        if (!arm.endsWith(QLatin1String("bare")))
            continue;
        for (const char *none : {"record_loss", "open_p50", "cpu_suite", "agent_cpu_suite"})
            QVERIFY2(values[QLatin1String(none)].isNull(), none);
        QVERIFY(std::abs(values[QLatin1String("overhead")].toDouble(1)) < 1e-9); // not a byte more than plain MAVLink
    }
    const std::map<QString, int> expected{{QStringLiteral("none plain"), 2},         {QStringLiteral("aes-256-ctr sealed"), 2},
                                          {QStringLiteral("aes-256-ctr inline"), 2}, {QStringLiteral("aes-256-ctr bare"), 2},
                                          {QStringLiteral("chacha20 sealed"), 2},    {QStringLiteral("chacha20 inline"), 2},
                                          {QStringLiteral("chacha20 bare"), 2}};
    QCOMPARE(measured, expected);
    for (const auto &[arm, runs] : expected)
        QVERIFY2(answered[arm] > 0, qPrintable(arm));
    QCOMPARE(blocks.size(), std::size_t(2));
    for (const auto &[repeat, arms] : blocks)
        QCOMPARE(arms.size(), expected.size());
}

void BareSweepTest::theKeyDecides_data()
{
    QTest::addColumn<bool>("isRight");
    QTest::newRow("the vehicle's key") << true;
    QTest::newRow("another key is a failed run") << false;
}

void BareSweepTest::theKeyDecides()
{
    QFETCH(bool, isRight);
    crypto::SystemRandom random;
    const QString programs = QStringLiteral(SKYSEAL_BIN_DIR "/");
    auto lab = Lab::create({programs + QStringLiteral("skyseal-sim"), programs + QStringLiteral("skyseal-air"),
                            programs + QStringLiteral("skyseal-cli")},
                           random);
    QVERIFY2(lab, lab ? "" : lab.error().text().c_str());
    QTemporaryDir folder;
    SweepConfig config;
    config.plan.arms = {{SuiteId::None},
                        {SuiteId::Aes256Ctr},
                        {SuiteId::Aes256Ctr, false, ArmFraming::Inline},
                        {SuiteId::Aes256Ctr, false, ArmFraming::Bare},
                        {SuiteId::ChaCha20, false, ArmFraming::Bare}};
    config.plan.repeats = 1;
    config.plan.warmUp = std::chrono::milliseconds(200);
    config.plan.measure = std::chrono::seconds(1);
    config.lab = lab->get();
    config.link = *link::LinkUrl::parse("udpin:127.0.0.1:" + std::to_string((*lab)->groundPort()));
    config.station.keys = (*lab)->stationKeys();
    config.station.policy.suites = channel::defaultSuites();
    config.station.policy.allowResearch = config.station.policy.allowPlain = true;
    config.bareKey = (*lab)->bareKey();
    if (!isRight) {
        config.bareKey = folder.filePath(QStringLiteral("other.key")).toStdString();
        QVERIFY(keys::createFile(config.bareKey, Bytes(32, 7)));
    }
    SweepRunner runner(std::move(config));
    Reason problem;
    bool over = false;
    connect(&runner, &SweepRunner::finished, this, [&](bool, const Reason &said) {
        over = true;
        problem = said;
    });
    runner.start();
    QVERIFY(QTest::qWaitFor([&] { return over; }, 2 * kDeadlineMs)); // the link changes for each run
    QCOMPARE(problem.text(), std::string());
    QCOMPARE(runner.results().samples.size(), runner.results().plan.arms.size());
    std::array<int, 2> answered{};
    for (const Sample &sample : runner.results().samples) {
        const SweepArm &arm = runner.results().plan.arms[sample.run.arm];
        const bool fails = !isRight && arm.framing == ArmFraming::Bare;
        QVERIFY2(sample.problem == (fails ? Reason(MeasuredLink::kUnreadable) : Reason()),
                 (fullName(arm) + ": " + sample.problem.text()).c_str());
        QCOMPARE(std::isnan(sample.values[Metric::Packets]), fails);
        if (fails)
            continue;
        QVERIFY(sample.values[Metric::Packets] >= 10);
        QCOMPARE(sample.values[Metric::Loss], 0.0);
        // The vehicle answers five times a second, and the answers are decrypted. A busy machine may delay those of one run.
        QVERIFY(std::isnan(sample.values[Metric::Latency]) || sample.values[Metric::Latency] > 0);
        answered[arm.framing == ArmFraming::Bare] += sample.values[Metric::Latency] > 0;
    }
    QVERIFY(answered[false] > 0);
    QCOMPARE(answered[true] > 0, isRight);
}

SKYSEAL_TEST(BareSweepTest)
#include "bare_sweep_test.moc"
