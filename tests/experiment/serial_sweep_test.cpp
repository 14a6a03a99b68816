// A sweep beside an autopilot at a serial port, by the real programs: each launch opens the port anew, flies and lands, and
// nothing of its keys remains.
#include "tests/experiment/flown_vehicle.h"
#include "tests/support/null_modem.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QTemporaryDir>

using namespace skyseal::test;

class SerialSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void launchesFlyOverTheLine();
};

void SerialSweepTest::launchesFlyOverTheLine()
{
    auto line = std::make_unique<NullModem>();
    const auto port = [&line](std::size_t end) { return QStringLiteral("serial:%1:57600").arg(line->device(end)); };
    const QString agentPort = port(1);
    FlownVehicle vehicle(port(0), agentPort);
    QTemporaryDir folder, temporary;
    qputenv("TMPDIR", QFile::encodeName(temporary.path()));
    Program sweep(QStringLiteral("skyseal-cli"),
                  vehicle.sweep(QLatin1String(kToFiveMetres),
                                "--suites none,aes-256-gcm --launches 2 --seconds 1 --warm-up 0.3 --no-noise --out")
                      + QStringList{folder.path()});
    qunsetenv("TMPDIR");
    const auto keys = [&temporary] {
        int out = 0;
        QDirIterator walk(temporary.path(), {QStringLiteral("*.key")}, QDir::Files, QDirIterator::Subdirectories);
        for (; walk.hasNext(); walk.next())
            ++out;
        return out;
    };
    EVENTUALLY2(keys() > 0, sweep.errors().constData());
    QVERIFY2(sweep.waitForExit(4 * kDeadlineMs) == 0, sweep.errors().constData());
    QVERIFY(line->carried[0] > 1000 && line->carried[1] > 100);
    line.reset(); // nothing reads the vehicle's end any longer
    EVENTUALLY(vehicle.isDown());
    QCOMPARE(vehicle.landings(), 2);
    QCOMPARE(QDir(temporary.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden), QStringList());

    QFile file(folder.filePath(QStringLiteral("sweep.json")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
    QVERIFY(report[QLatin1String("complete")].toBool());
    const QString source = report[QLatin1String("source")].toString();
    QVERIFY2(source.startsWith(QStringLiteral("the autopilot on %1, whose process is not known").arg(agentPort)),
             qPrintable(source));
    QVERIFY2(source.contains(QLatin1String("system 1 is ArduCopter")), qPrintable(source));
    const QJsonArray samples = report[QLatin1String("samples")].toArray();
    QCOMPARE(samples.size(), 4);
    for (const QJsonValue sample : samples) {
        const QJsonValue values = sample[QLatin1String("values")];
        QVERIFY2(sample[QLatin1String("problem")].isUndefined(), qPrintable(sample[QLatin1String("problem")].toString()));
        QVERIFY2(sample[QLatin1String("valid")].toBool(), qPrintable(sample[QLatin1String("invalid")].toString()));
        QVERIFY(values[QLatin1String("packets")].toDouble() > 0);
        QVERIFY(values[QLatin1String("agent_cpu")].toDouble() > 0);
        QVERIFY(values[QLatin1String("autopilot_cpu")].isNull());
    }
}

SKYSEAL_TEST(SerialSweepTest)
#include "serial_sweep_test.moc"
