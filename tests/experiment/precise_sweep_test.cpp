// Sweeps that go on until the ratios are known as exactly as wanted (--until), and pilots that say how long it takes (--plan),
// by the real programs. How exactly they are known is computed again from the sweep's own file.
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QRegularExpression>
#include <QtCore/QTemporaryDir>

#include <algorithm>
#include <cmath>

using namespace skyseal::test;

namespace {

constexpr int kMs = 600'000;
constexpr const char *kShort = "sweep --suites none,aes-256-gcm --no-noise --load natural --seconds 0.3 --warm-up 0.1 --out";

QJsonObject reportIn(const QTemporaryDir &folder)
{
    QFile file(folder.filePath(QStringLiteral("sweep.json")));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

/// Half of the widest interval of the ratios by CPU time per frame, per cent.
double precisionIn(const QJsonObject &report)
{
    double out = 0;
    int ratios = 0;
    for (const QJsonValue one : report[QLatin1String("comparisons")].toArray()) {
        if (!one[QLatin1String("metric")].toString().endsWith(QLatin1String("cpu_per_frame")))
            continue;
        const double half = std::log(one[QLatin1String("ci95_high")].toDouble() / one[QLatin1String("ci95_low")].toDouble())
            / 2;
        out = std::max(out, 100 * std::expm1(half));
        ++ratios;
    }
    return ratios == 2 ? out : std::nan(""); // both ends
}

int launchesIn(const QJsonObject &report)
{
    return report[QLatin1String("plan")][QLatin1String("launches")].toInt();
}

} // namespace

class PreciseSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void untilTheGoalIsReached();
    void outOfReachIsSaid();
    void planSaysHowLong();
};

/// A goal that is easy, so that the tenth launch is the last one wherever this runs.
void PreciseSweepTest::untilTheGoalIsReached()
{
    QTemporaryDir folder;
    const RunResult run = runProgram("skyseal-cli", words(kShort) << folder.path() << words("--until 50 --launches 14"), {},
                                     kMs);
    const QJsonObject report = reportIn(folder);
    const double precision = precisionIn(report);
    QVERIFY(std::isfinite(precision));
    const int launches = launchesIn(report);
    QVERIFY(launches >= 10 && launches <= 14);
    QCOMPARE(report[QLatin1String("samples")].toArray().size(), 2 * launches);
    QVERIFY2(run.status == (precision <= 50 ? 0 : 1), run.err.constData());
    QCOMPARE(launches < 14, precision <= 50);
    QVERIFY(
        run.err.contains(QByteArray("after ") + QByteArray::number(launches) + " launches the ratios by CPU time per frame"));
}

void PreciseSweepTest::outOfReachIsSaid()
{
    QTemporaryDir folder;
    const RunResult run = runProgram("skyseal-cli", words(kShort) << folder.path() << words("--until 0.1 --launches 10"), {},
                                     kMs);
    QCOMPARE(run.status, 1);
    QCOMPARE(launchesIn(reportIn(folder)), 10);
    QVERIFY2(run.err.contains("out of reach within 10 launches"), run.err.constData());
}

void PreciseSweepTest::planSaysHowLong()
{
    QTemporaryDir folder;
    const RunResult run = runProgram("skyseal-cli", words(kShort) << folder.path() << words("--plan --launches 2 --until 5"),
                                     {}, kMs);
    QVERIFY2(run.status == 0, run.err.constData());
    const QJsonObject report = reportIn(folder);
    QCOMPARE(launchesIn(report), 2);
    static const QRegularExpression kForecast(
        QStringLiteral("known to ([\\d.,]+) %; 5 % takes about ([\\d,]+) launches, ([\\d.,]+) minutes"));
    const QRegularExpressionMatch said = kForecast.match(QString::fromUtf8(run.err));
    QVERIFY2(said.hasMatch(), run.err.constData());
    const auto number = [&](int group) { return said.captured(group).remove(QLatin1Char(',')).toDouble(); };
    const double precision = precisionIn(report);
    QVERIFY(std::abs(number(1) - precision) <= 0.01 * precision + 0.5);
    QVERIFY(number(2) >= 10 && (precision <= 5 || number(2) > 2));
    const double minutes = number(2) * report[QLatin1String("duration")].toDouble() / 2 / 60;
    QVERIFY(std::abs(number(3) - minutes) <= 0.01 * minutes + 0.5);
}

SKYSEAL_TEST(PreciseSweepTest)
#include "precise_sweep_test.moc"
