// A sweep at fixed rates by the real programs: the load is that of the schedule, its misses are counted, the
// cost is fitted.
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>

#include <map>
#include <numeric>

using namespace skyseal::test;

class PacedSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// On a machine with much other work runs may miss more than they may, and then say so.
    void ratesAreThoseOfTheSchedule()
    {
        QTemporaryDir folder;
        const RunResult run = runProgram("skyseal-cli",
                                         words("sweep --suites none,aes-256-gcm --pps 50,200,1000 --launches 1 --repeats 2 "
                                               "--seconds 1 --warm-up 0.3 --no-noise --out")
                                             + QStringList{folder.path()},
                                         {}, 4 * kDeadlineMs);
        const bool missed = run.err.contains("the generator missed");
        QVERIFY2(run.status == (missed ? 1 : 0), run.err.constData());
        QFile file(folder.filePath(QStringLiteral("sweep.json")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(report[QLatin1String("plan")][QLatin1String("loads")].toArray(),
                 QJsonArray({QStringLiteral("pps50"), QStringLiteral("pps200"), QStringLiteral("pps1000")}));
        const QJsonArray samples = report[QLatin1String("samples")].toArray();
        QCOMPARE(samples.size(), 12);
        std::map<double, QList<double>> received;
        for (const QJsonValue sample : samples) {
            QVERIFY2(sample[QLatin1String("problem")].isUndefined(), qPrintable(sample[QLatin1String("problem")].toString()));
            const double rate = sample[QLatin1String("load")].toString().mid(3).toDouble();
            const QJsonValue values = sample[QLatin1String("values")];
            const double misses = values[QLatin1String("missed_sends")].toDouble(-1);
            QVERIFY(misses >= 0);
            QCOMPARE(sample[QLatin1String("valid")].toBool(),
                     misses <= 0.01 * rate * sample[QLatin1String("seconds")].toDouble());
            if (sample[QLatin1String("valid")].toBool())
                received[rate].append(values[QLatin1String("frame_rate")].toDouble());
        }
        // The natural load comes on top. A pause of the machine at the end of a run delays what is counted of that run.
        for (const auto &[rate, rates] : received) {
            const double mean = std::accumulate(rates.begin(), rates.end(), 0.0) / static_cast<double>(rates.size());
            const QByteArray text = QByteArray::number(mean) + " at " + QByteArray::number(rate);
            QVERIFY2(mean > 0.8 * rate && mean < 1.2 * rate + 200, text.constData());
        }
        const QJsonArray models = report[QLatin1String("cost_models")].toArray();
        QVERIFY(missed || models.size() == 4); // two suites, two ends
        for (const QJsonValue model : models) {
            QVERIFY(model[QLatin1String("per_frame")][QLatin1String("ci95_low")].toDouble()
                    < model[QLatin1String("per_frame")][QLatin1String("ci95_high")].toDouble());
            QCOMPARE(model[QLatin1String("df")].toInt() + 3, int(model[QLatin1String("residuals")].toArray().size()));
        }
        QFile page(folder.filePath(QStringLiteral("report.html")));
        QVERIFY(page.open(QIODevice::ReadOnly) && page.readAll().contains("<h2>Cost against rate</h2>"));
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("figures/cpu-pps1000.svg"))));
    }
};

SKYSEAL_TEST(PacedSweepTest)
#include "paced_sweep_test.moc"
