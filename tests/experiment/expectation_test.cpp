// Assertions about a sweep: their values, the errors of the parser, and the verdicts on made-up results.
#include "core/experiment/analysis.h"
#include "core/experiment/verdicts.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

namespace {

double lookup(Metric metric, SuiteId suite, std::optional<experiment::ArmFraming> framing, std::optional<Load> load)
{
    if (metric == Metric::Cpu)
        return (suite == SuiteId::None ? 2.0 : 3.0) * (load == Load::Saturated ? 10 : 1)
            + (framing == experiment::ArmFraming::Inline ? 0.5 : 0);
    if (metric == Metric::Loss)
        return 0.25;
    return std::numeric_limits<double>::quiet_NaN();
}

Results results()
{
    Results out;
    out.plan.arms = {{SuiteId::None, false}, {SuiteId::Aes256Gcm, false}, {SuiteId::Aes256Gcm, true}};
    out.plan.loads = {Load::Natural, Load::Saturated};
    out.plan.repeats = 2;
    unsigned order = 0;
    for (const Run &run : schedule(out.plan)) {
        Sample sample;
        sample.run = run;
        sample.order = order++;
        sample.values[Metric::Cpu] = 10.0 * static_cast<double>(run.load) + static_cast<double>(run.arm) + 0.5 * run.repeat;
        if (run.arm != 0)
            sample.values[Metric::RecordLoss] = 0;
        out.samples.push_back(sample);
    }
    return out;
}

} // namespace

class ExpectationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void values_data();
    void values();
    void errors_data();
    void errors();
    void judgedForEachSuiteThatHasIt();
    void unmeasuredFails();
    void failedSuiteFails();
    void mustFitThePlan();
    void eachFramingIsJudged();
};

void ExpectationTest::values_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("left");
    QTest::addColumn<double>("right");
    QTest::addColumn<bool>("holds");
    const auto row = [](const char *text, double left, double right, bool holds) {
        QTest::newRow(text) << QString::fromUtf8(text) << left << right << holds;
    };
    row("loss<=0.001", 0.25, 0.001, false);
    row("cpu(chacha20-poly1305)<=1.60*cpu(none)", 3, 3.2, true);
    row("cpu(chacha20-poly1305)<=1.10*cpu(none)", 3, 2.2, false);
    row(" cpu ( aes-256-gcm , saturated ) == 30 ", 30, 30, true);
    row("1 >= 2 * cpu(none)", 1, 4, false);
    row("9 != cpu(none)", 9, 2, true);
    row(".5*cpu(none) == 0.25 * cpu ( none )", 1, 0.5, false);
    row("cpu(none) > 1e0", 2, 1, true);
    row("cpu(*,saturated)>29", 30, 29, true);
    row("cpu(chacha20,inline)<=cpu(chacha20,sealed)", 3.5, 3, false);
    row("cpu(chacha20,inline,saturated)==cpu(chacha20,saturated,inline)", 30.5, 30.5, true);
    row("cpu(*,inline)>3", 3.5, 3, true);
}

void ExpectationTest::values()
{
    QFETCH(QString, text);
    QFETCH(double, left);
    QFETCH(double, right);
    QFETCH(bool, holds);
    const auto parsed = Expectation::parse(text.toStdString());
    QVERIFY2(parsed, parsed ? "" : parsed.error().text().c_str());
    const auto outcome = parsed->check({SuiteId::ChaCha20}, lookup);
    QVERIFY(outcome.measured);
    QCOMPARE(outcome.left, left);
    QCOMPARE(outcome.right, right);
    QCOMPARE(outcome.holds, holds);
}

void ExpectationTest::errors_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("message");
    const auto row = [](const QString &text, int column, const char *message) {
        QTest::newRow(qPrintable(text.left(40))) << text << column << QString::fromUtf8(message);
    };
    row(QStringLiteral(""), 1, "instead of end");
    row(QStringLiteral("loss"), 5, "comparison");
    row(QStringLiteral("loss<="), 7, "instead of end");
    row(QStringLiteral("loss=0"), 5, "comparison");
    row(QStringLiteral("los<=0"), 1, "no metric is named 'los'; there are packets, frame_rate, ");
    row(QStringLiteral("loss<=0 and more"), 9, "unexpected 'a'");
    row(QStringLiteral("cpu(des)<1"), 5, "no suite is named 'des'");
    row(QStringLiteral("cpu(none,fast)<1"), 10, "natural, saturated or pps500");
    row(QStringLiteral("cpu(rc4,inline,sealed)<1"), 16, "sealed, inline or bare is expected");
    row(QStringLiteral("cpu(none<1"), 9, "')' is expected");
    row(QStringLiteral("1<2"), 4, "a metric is expected on one side");
    row(QStringLiteral("loss<1x"), 7, "after a number");
    row(QStringLiteral("loss<1e999"), 6, "not a number");
    row(QStringLiteral("loss<0x10"), 7, "after a number");
    row(QStringLiteral("loss<nan"), 6, "no metric is named 'nan'");
    row(QStringLiteral("2cpu<1"), 2, "after a number");
    row(QStringLiteral("2*3<cpu"), 3, "a number or a metric is expected instead of '3'");
    row(QStringLiteral("cpu*2<1"), 4, "comparison");
    row(QStringLiteral("cpu<1+cpu(none)"), 6, "unexpected '+'");
    row(QStringLiteral("(cpu)<1"), 1, "instead of '('");
    row(QStringLiteral("-cpu<1"), 1, "instead of '-'");
    row(QStringLiteral("cpu()<1"), 5, "no suite is named ''");
    row(QString(1001, QLatin1Char(' ')), 1, "longer than");
}

void ExpectationTest::errors()
{
    QFETCH(QString, text);
    QFETCH(int, column);
    QFETCH(QString, message);
    const auto parsed = Expectation::parse(text.toStdString());
    QVERIFY(!parsed);
    QVERIFY2(QString::fromStdString(parsed.error().message.text()).contains(message), parsed.error().message.text().c_str());
    QCOMPARE(parsed.error().column, static_cast<std::size_t>(column));
}

void ExpectationTest::judgedForEachSuiteThatHasIt()
{
    const auto verdicts = judge(*Expectation::parse("record_loss<=0.001"), results());
    QCOMPARE(verdicts.size(), std::size_t(2)); // plain MAVLink has no records, the repeated arm is not asked; two loads
    QCOMPARE(verdicts[0].suite, std::string("aes-256-gcm"));
    QVERIFY(verdicts[0].outcome.holds);

    const auto cpu = judge(*Expectation::parse("cpu<=1"), results());
    QCOMPARE(cpu.size(), std::size_t(4));
    QCOMPARE(cpu[0].outcome.left, 0.25); // the mean of 0 and 0.5, under the first load
    QVERIFY(cpu[0].outcome.holds && !cpu[1].outcome.holds && !cpu[2].outcome.holds && !cpu[3].outcome.holds);
    QCOMPARE(verdictText(cpu[0], results().plan), std::string("cpu<=1 [none] [natural]: 0.25 against 1: holds"));
    QCOMPARE(verdictText(cpu[2], results().plan), std::string("cpu<=1 [none] [saturated]: 10.2 against 1: FAILS"));
    // One that names a load is about what it names.
    QCOMPARE(judge(*Expectation::parse("cpu(none)<cpu(none,saturated)"), results()).size(), std::size_t(1));
    QCOMPARE(judge(*Expectation::parse("cpu(none,saturated)==10.25"), results()).at(0).outcome.holds, true);
}

void ExpectationTest::unmeasuredFails()
{
    const auto verdicts = judge(*Expectation::parse("latency(none)<1"), results());
    QCOMPARE(verdicts.size(), std::size_t(2));
    QVERIFY(!verdicts[0].outcome.measured && !verdicts[0].outcome.holds);
    QVERIFY(verdictText(verdicts[0], results().plan).find("was not measured") != std::string::npos);
    for (const Verdict &verdict : judge(*Expectation::parse("latency<1"), results()))
        QVERIFY(!verdict.outcome.holds);
}

void ExpectationTest::failedSuiteFails()
{
    Results failed = results();
    for (Sample &sample : failed.samples) {
        if (sample.run.arm == 0 && sample.run.load == 1) {
            sample.values = {};
            sample.problem = "no vehicle was heard";
        }
    }
    const auto verdicts = judge(*Expectation::parse("cpu<=100"), failed);
    QCOMPARE(verdicts.size(), std::size_t(4));
    QVERIFY(verdicts[0].outcome.holds && verdicts[1].outcome.holds && verdicts[3].outcome.holds);
    QCOMPARE(verdictText(verdicts[2], failed.plan), std::string("cpu<=100 [none] [saturated]: was not measured: FAILS"));
    // Its runs under the other load are none of those that were asked for.
    for (const char *text : {"cpu(*,saturated)<=100", "cpu<=100*cpu(*,saturated)"}) {
        const auto named = judge(*Expectation::parse(text), failed);
        QCOMPARE(named.size(), std::size_t(2));
        QVERIFY2(!named[0].outcome.measured && !named[0].outcome.holds && named[1].outcome.holds, text);
        QCOMPARE(named[0].suite, std::string("none"));
    }
    QCOMPARE(judge(*Expectation::parse("record_loss(*,saturated)<=0.001"), failed).size(), std::size_t(2));
    QCOMPARE(judge(*Expectation::parse("record_loss(*,natural)<=0.001"), failed).size(), std::size_t(1));
}

void ExpectationTest::mustFitThePlan()
{
    Plan plan = results().plan;
    QVERIFY(fits(*Expectation::parse("cpu(aes-256-gcm,saturated)<1"), plan));
    QVERIFY(!fits(*Expectation::parse("cpu(rc4)<1"), plan));
    plan.loads = {Load::Natural};
    QVERIFY(!fits(*Expectation::parse("cpu(none,saturated)<1"), plan));
    QVERIFY(!fits(*Expectation::parse("cpu(aes-256-gcm,inline)<1"), plan));
}

void ExpectationTest::eachFramingIsJudged()
{
    Results both;
    both.plan.arms = armsOf({SuiteId::None, SuiteId::Aes256Gcm, SuiteId::ChaCha20},
                            {experiment::ArmFraming::Sealed, experiment::ArmFraming::Inline}, false);
    both.plan.repeats = 1;
    for (const Run &run : schedule(both.plan)) {
        Sample sample;
        sample.run = run;
        const SweepArm &arm = both.plan.arms[run.arm];
        sample.values[Metric::Cpu] = arm.suite == SuiteId::None ? 1 : arm.framing == experiment::ArmFraming::Inline ? 7 : 4;
        both.samples.push_back(sample);
    }
    const auto each = judge(*Expectation::parse("cpu<=4"), both);
    QCOMPARE(each.size(), std::size_t(4)); // AES-256-GCM is not inline, so it is not asked there
    QCOMPARE(each[3].suite, std::string("chacha20 inline"));
    QVERIFY(each[0].outcome.holds && each[1].outcome.holds && each[2].outcome.holds && !each[3].outcome.holds);
    QCOMPARE(judge(*Expectation::parse("cpu(chacha20,inline)==1.75*cpu(chacha20)"), both).at(0).outcome.holds, true);
    const auto inlineOnly = judge(*Expectation::parse("cpu(*,inline)>=1"), both);
    QCOMPARE(inlineOnly.size(), std::size_t(2)); // plain MAVLink beside the one suite
}

SKYSEAL_TEST_APPLESS(ExpectationTest)
#include "expectation_test.moc"
