// skyseal-cli param beside a vehicle whose gimbal and camera have parameters, too, with whole numbers that no float can hold.
#include "tests/support/free_port.h"
#include "tests/support/run_program.h"
#include "tests/support/scripted_vehicle.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <bit>

using namespace skyseal;
using namespace skyseal::test;

class ComponentParametersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void valuesOfAllComponentsAreListed();
    void singleOnesAreReadAndWritten();
    void filesNameTheComponent();
    void plainFilesAreTheAutopilots();
    void missingComponentIsSaid();
    void mavlink1IsSpokenToo();

private:
    RunResult run(const QStringList &arguments);
    QString write(const char *name, const QByteArray &content);
    QByteArray read(const QString &name) const;

    QTemporaryDir m_folder;
    quint16 m_port = 0;
    std::unique_ptr<ScriptedVehicle> m_vehicle;
};

namespace {

ScriptedVehicle::Value whole(std::uint8_t component, const char *name, std::int64_t value,
                             std::uint8_t type = mavlink::MAV_PARAM_TYPE_INT32)
{
    return {component, name, std::bit_cast<float>(static_cast<std::uint32_t>(value)), type};
}

} // namespace

void ComponentParametersTest::init()
{
    m_port = freeUdpPort();
    m_vehicle = std::make_unique<ScriptedVehicle>(
        m_port,
        std::vector<ScriptedVehicle::Value>{{1, "RTL_ALT", 1500, mavlink::MAV_PARAM_TYPE_REAL32},
                                            whole(1, "CAL_ID", 16777217),
                                            whole(1, "LEAST", -2147483648),
                                            whole(1, "MINUS", -1),
                                            whole(1, "MASK", 4294967295, mavlink::MAV_PARAM_TYPE_UINT32),
                                            whole(100, "CAM_MODE", 1),
                                            {154, "G_PAN", 0.5f, mavlink::MAV_PARAM_TYPE_REAL32},
                                            {154, "RTL_ALT", 3, mavlink::MAV_PARAM_TYPE_REAL32}});
}

/// Lets the vehicle answer meanwhile.
RunResult ComponentParametersTest::run(const QStringList &arguments)
{
    QProcess process;
    const QStringList link{QStringLiteral("--link"),   QStringLiteral("udpin:127.0.0.1:%1").arg(m_port),
                           QStringLiteral("--secure"), QStringLiteral("off"),
                           QStringLiteral("--sysid"),  QStringLiteral("1")};
    process.start(QStringLiteral(SKYSEAL_BIN_DIR "/skyseal-cli"), QStringList{QStringLiteral("param")} + arguments + link);
    if (!eventually([&process] { return process.state() == QProcess::NotRunning; })) {
        process.kill();
        process.waitForFinished(kDeadlineMs);
        return {};
    }
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

QString ComponentParametersTest::write(const char *name, const QByteArray &content)
{
    QFile file(m_folder.filePath(QLatin1String(name)));
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName() : QString();
}

QByteArray ComponentParametersTest::read(const QString &name) const
{
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void ComponentParametersTest::valuesOfAllComponentsAreListed()
{
    const RunResult list = run(words("list"));
    QVERIFY2(list.status == 0, list.err.constData());
    QCOMPARE(list.out,
             QByteArray("CAL_ID 16777217\nLEAST -2147483648\nMASK 4294967295\nMINUS -1\nRTL_ALT 1500\n"
                        "100:CAM_MODE 1\n154:G_PAN 0.5\n154:RTL_ALT 3\n"));
    const RunResult json = run(words("list --json"));
    QVERIFY2(json.out.contains(R"("compid":154,"name":"RTL_ALT","value":3)"), json.out.constData());
    QVERIFY2(json.out.contains(R"("compid":1,"name":"CAL_ID","value":16777217)"), json.out.constData());
}

void ComponentParametersTest::singleOnesAreReadAndWritten()
{
    const RunResult set = run(words("set 154:RTL_ALT=4 CAL_ID=16777216 MASK=4294967294 LEAST=-2147483647 100:CAM_MODE=2"));
    QVERIFY2(set.status == 0, set.err.constData());
    QCOMPARE(set.out, QByteArray("154:RTL_ALT 4\nCAL_ID 16777216\nMASK 4294967294\nLEAST -2147483647\n100:CAM_MODE 2\n"));
    QCOMPARE(m_vehicle->find(154, "RTL_ALT")->raw, 4.f);
    QCOMPARE(m_vehicle->find(1, "RTL_ALT")->raw, 1500.f);
    QCOMPARE(std::bit_cast<std::int32_t>(m_vehicle->find(1, "CAL_ID")->raw), 16777216);
    const RunResult get = run(words("get RTL_ALT 154:RTL_ALT 1:RTL_ALT"));
    QVERIFY2(get.status == 0, get.err.constData());
    QCOMPARE(get.out, QByteArray("RTL_ALT 1500\n154:RTL_ALT 4\nRTL_ALT 1500\n"));
}

/// What was saved is loaded to the same components, and not a digit is lost.
void ComponentParametersTest::filesNameTheComponent()
{
    const QString file = m_folder.filePath(QStringLiteral("all.params"));
    const RunResult saved = run({QStringLiteral("save"), file, QStringLiteral("--format"), QStringLiteral("qgc")});
    QVERIFY2(saved.status == 0, saved.err.constData());
    const QByteArray text = read(file);
    QCOMPARE(text,
             QByteArray("# Vehicle-Id Component-Id Name Value Type\n"
                        "1\t1\tCAL_ID\t16777217\t6\n1\t1\tLEAST\t-2147483648\t6\n1\t1\tMASK\t4294967295\t5\n"
                        "1\t1\tMINUS\t-1\t6\n1\t1\tRTL_ALT\t1500\t9\n1\t100\tCAM_MODE\t1\t6\n"
                        "1\t154\tG_PAN\t0.5\t9\n1\t154\tRTL_ALT\t3\t9\n"));
    const RunResult same = run({QStringLiteral("diff"), file});
    QVERIFY2(same.status == 0 && same.err.contains("8 parameters, no difference"), same.err.constData());

    const auto change = [this](std::uint8_t component, std::string_view name, float raw) {
        std::ranges::find_if(m_vehicle->values, [&](const ScriptedVehicle::Value &value) {
            return value.component == component && value.name == name;
        })->raw = raw;
    };
    change(154, "RTL_ALT", 9);
    change(1, "CAL_ID", std::bit_cast<float>(std::int32_t{16777216})); // the same number as a float
    change(1, "MINUS", 0);
    const RunResult loaded = run({QStringLiteral("load"), file});
    QVERIFY2(loaded.status == 0, loaded.err.constData());
    QCOMPARE(loaded.out, QByteArray("CAL_ID 16777217\nMINUS -1\n154:RTL_ALT 3\n"));
    QCOMPARE(m_vehicle->writes, 3);
    QCOMPARE(m_vehicle->find(1, "RTL_ALT")->raw, 1500.f);
}

void ComponentParametersTest::plainFilesAreTheAutopilots()
{
    const QString file = m_folder.filePath(QStringLiteral("plain.param"));
    const RunResult saved = run({QStringLiteral("save"), file});
    QVERIFY2(saved.status == 0, saved.err.constData());
    QVERIFY2(saved.err.contains("5 parameters") && saved.err.contains("3 parameters of other components left out"),
             saved.err.constData());
    QCOMPARE(read(file), QByteArray("CAL_ID,16777217\nLEAST,-2147483648\nMASK,4294967295\nMINUS,-1\nRTL_ALT,1500\n"));
    const RunResult loaded = run({QStringLiteral("load"), write("one.param", "RTL_ALT,1600\nCAL_ID,16777217\n")});
    QVERIFY2(loaded.status == 0, loaded.err.constData());
    QCOMPARE(loaded.out, QByteArray("RTL_ALT 1600\n"));
    QCOMPARE(m_vehicle->find(154, "RTL_ALT")->raw, 3.f);
}

void ComponentParametersTest::missingComponentIsSaid()
{
    const RunResult loaded = run(
        {QStringLiteral("load"), write("other.params", "1\t190\tRTL_ALT\t2500\t4\n1\t1\tMINUS\t-2\t6\n")});
    QCOMPARE(loaded.status, 1);
    QVERIFY2(loaded.err.contains("190:RTL_ALT: the vehicle has no such parameter"), loaded.err.constData());
    QCOMPARE(loaded.out, QByteArray("MINUS -2\n"));
    QCOMPARE(m_vehicle->find(1, "RTL_ALT")->raw, 1500.f);
}

void ComponentParametersTest::mavlink1IsSpokenToo()
{
    m_vehicle->version = 1;
    const RunResult set = run(words("set RTL_ALT=1700 154:RTL_ALT=5"));
    QVERIFY2(set.status == 0, set.err.constData());
    QCOMPARE(set.out, QByteArray("RTL_ALT 1700\n154:RTL_ALT 5\n"));
    QCOMPARE(m_vehicle->heardIn(2), 0);
}

SKYSEAL_TEST(ComponentParametersTest)
#include "component_parameters_test.moc"
