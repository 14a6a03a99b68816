// A saturated load that cannot be one: the link loses so much that the generator, which waits for answers as TCP does, never
// uses up the core of an end. Such a run is repeated, then marked, and is in no comparison.
#include "core/experiment/load_check.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

class UnsaturatedSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void loadBelowSaturationIsNotValid();
};

void UnsaturatedSweepTest::loadBelowSaturationIsNotValid()
{
    QTemporaryDir folder;
    const RunResult run = runProgram("skyseal-cli",
                                     words("sweep --launches 1 --repeats 1 --seconds 0.5 --warm-up 0.1 --suites "
                                           "none,chacha20-poly1305 --load saturated --impair "
                                           "loss=0.3,delay=150 --no-noise --json --out")
                                         << folder.path(),
                                     {}, 400000);
    QVERIFY2(run.status == 1, run.err.constData());
    QFile file(folder.filePath(QStringLiteral("sweep.json")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
    const QJsonArray samples = report[QLatin1String("samples")].toArray();
    QCOMPARE(samples.size(), 2);
    for (const QJsonValue sample : samples) {
        const QJsonValue values = sample[QLatin1String("values")];
        const QByteArray text = QJsonDocument(sample.toObject()).toJson();
        QVERIFY2(sample[QLatin1String("problem")].isUndefined(), text.constData());
        QVERIFY2(values[QLatin1String("packets")].toDouble() > 0, text.constData());
        for (const char *part : {"line_load", "cpu", "agent_cpu"}) // held below, by the readings themselves
            QVERIFY2(values[QLatin1String(part)].toDouble() < skyseal::experiment::kUsedUp, text.constData());
        QVERIFY2(!sample[QLatin1String("valid")].toBool(true), text.constData());
        QVERIFY2(sample[QLatin1String("invalid")].toString().startsWith(QLatin1String("not saturated: ")), text.constData());
    }
    QCOMPARE(samples.first()[QLatin1String("attempts")].toInt(), 3); // repeated, before it was given up
    for (const QJsonValue one : report[QLatin1String("comparisons")].toArray())
        QVERIFY(one[QLatin1String("ratio")].isNull() || one[QLatin1String("ratio")].isUndefined());
    QVERIFY2(run.err.contains("not saturated"), run.err.constData());
}

SKYSEAL_TEST(UnsaturatedSweepTest)
#include "unsaturated_sweep_test.moc"
