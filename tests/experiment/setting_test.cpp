// The description of the machine and the build that measured, and the benchmark's report of AES instructions, are correct
// for any value of OpenSSL's capability mask.
#include "core/experiment/setting.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

#include <algorithm>
#include <array>

#include <unistd.h>

using namespace skyseal::experiment;
using skyseal::test::RunResult;

class SettingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesTheBuild();
    void namesTheProcessorsState();
    void busyMachineIsWarnedOf();
    void slowBuildIsWarnedOf();
    void readsWhatOpensslSaysOfItself();
    void benchSaysWhatItUsed_data();
    void benchSaysWhatItUsed();
};

void SettingTest::namesTheBuild()
{
    const Setting setting = machineSetting();
    for (const char *key : {"memory", "build", "build_type", "build_flags", "commit", "load_average_at_start"}) {
        const auto found = std::find_if(setting.begin(), setting.end(),
                                        [key](const auto &entry) { return entry.first == key; });
        QVERIFY2(found != setting.end(), key);
        qInfo("%s: %s", key, found->second.c_str());
        QVERIFY2(!found->second.empty(), key);
    }
}

/// As far as this kernel tells; "unknown" where it does not.
void SettingTest::namesTheProcessorsState()
{
    const Setting setting = machineSetting();
    const auto entry = [&setting](const char *key) {
        const auto found = std::ranges::find(setting, key, [](const auto &one) { return one.first; });
        return found == setting.end() ? QString() : QString::fromStdString(found->second);
    };
    const auto lineOf = [](const char *path) {
        QFile file(QString::fromLatin1(path));
        return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.readLine()).trimmed() : QString();
    };
    const auto orUnknown = [](const QString &text) { return text.isEmpty() ? QStringLiteral("unknown") : text; };
    QCOMPARE(entry("frequency_governor"), orUnknown(lineOf("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")));
    QCOMPARE(entry("clock_source"), lineOf("/sys/devices/system/clocksource/clocksource0/current_clocksource"));
    QFile processor(QStringLiteral("/proc/cpuinfo"));
    QVERIFY(processor.open(QIODevice::ReadOnly));
    const QString cpuinfo = QString::fromLatin1(processor.readAll());
    static const QRegularExpression kMicrocode(QStringLiteral("^microcode\\s*: *(.+)$"), QRegularExpression::MultilineOption);
    QCOMPARE(entry("microcode"), orUnknown(kMicrocode.match(cpuinfo).captured(1)));
    const QString noTurbo = lineOf("/sys/devices/system/cpu/intel_pstate/no_turbo"),
                  boost = lineOf("/sys/devices/system/cpu/cpufreq/boost");
    const bool isOn = noTurbo == QLatin1String("0") || (noTurbo.isEmpty() && boost == QLatin1String("1"));
    QCOMPARE(entry("turbo"),
             noTurbo.isEmpty() && boost.isEmpty() ? QStringLiteral("unknown") : QString::fromLatin1(isOn ? "on" : "off"));
    for (const char *key : {"processor", "cores", "hypervisor", "kernel", "compiler", "libsodium", "openssl"})
        QVERIFY2(!entry(key).isEmpty(), key);
    std::array<char, 64> running{};
    QVERIFY(::confstr(_CS_GNU_LIBC_VERSION, running.data(), running.size()) > 0); // "glibc 2.36"
    QCOMPARE(entry("libc"), QString::fromLatin1(running.data()));
}

void SettingTest::busyMachineIsWarnedOf()
{
    QVERIFY(busyWarning(0.3, 2).empty() && busyWarning(1.0, 2).empty());
    const std::string warning = busyWarning(8.57, 2).text();
    QVERIFY2(warning.find("8.57 on 2 cores") != std::string::npos, warning.c_str());
}

void SettingTest::slowBuildIsWarnedOf()
{
    for (const char *fast : {"-O3 -DNDEBUG", "-O2 -g1", "-g -O2 -ffile-prefix-map=/a=. -O3"})
        QVERIFY2(buildWarning(fast).empty(), fast);
    for (const char *forTests : {"-O1 -g1 -DNDEBUG", "-O3 -Os", "-O"})
        QVERIFY2(buildWarning(forTests).text().find("as for tests") != std::string::npos, forTests);
    for (const char *none : {"", "-g", "-O2 -O0"})
        QVERIFY2(buildWarning(none).text().starts_with("not optimised"), none);

    const Setting setting = machineSetting();
    QVERIFY(warningsOf(setting).size() <= 1); // a key of sweep.json
    const auto flags = std::find_if(setting.begin(), setting.end(),
                                    [](const auto &entry) { return entry.first == "build_flags"; });
    const std::string built = buildWarning(flags->second).text();
    for (const Reason &warning : warningsOf(setting))
        QCOMPARE(warning.text().find("this build is " + built) == 0, !built.empty());
    QVERIFY(built.empty() || !warningsOf(setting).empty());
}

void SettingTest::readsWhatOpensslSaysOfItself()
{
    QCOMPARE(opensslUsesAes("CPUINFO: OPENSSL_ia32cap=0xfffa3203078bffff:0x405fc6f1bf07ab"), std::optional(true));
    QCOMPARE(opensslUsesAes("CPUINFO: OPENSSL_ia32cap=0xfcfa3201078bffff:0x405fc6f1bf01ab env:~0x200000200000000"),
             std::optional(false));
    QCOMPARE(opensslUsesAes("CPUINFO: OPENSSL_armcap=0x7d"), std::optional(true));
    QCOMPARE(opensslUsesAes("CPUINFO: OPENSSL_armcap=0x1"), std::optional(false));
    QCOMPARE(opensslUsesAes("CPUINFO: N/A"), std::optional<bool>());
}

void SettingTest::benchSaysWhatItUsed_data()
{
    QTest::addColumn<QByteArray>("mask");
    QTest::newRow("nothing set") << QByteArray();
    QTest::newRow("all on") << QByteArray("~0x0");
    QTest::newRow("AES off") << QByteArray("~0x200000200000000");
}

void SettingTest::benchSaysWhatItUsed()
{
    QFETCH(QByteArray, mask);
    const char *name = "OPENSSL_ia32cap";
    if (mask.isEmpty())
        qunsetenv(name);
    else
        qputenv(name, mask);
    const RunResult run = skyseal::test::runProgram("skyseal-cli",
                                                    {QStringLiteral("bench"), QStringLiteral("--suites"),
                                                     QStringLiteral("aes-256-gcm"), QStringLiteral("--sizes"),
                                                     QStringLiteral("64"), QStringLiteral("--json")});
    qunsetenv(name);
    QVERIFY2(run.status == 0, run.err.constData());
    QList<bool> used;
    for (const QByteArray &line : run.out.split('\n')) {
        const QJsonObject event = QJsonDocument::fromJson(line).object();
        if (event[QLatin1String("event")] != QLatin1String("setting"))
            continue;
        used << event[QLatin1String("aes_instructions")].toBool();
        QCOMPARE(std::optional(used.last()), opensslUsesAes(event[QLatin1String("openssl_cpu")].toString().toStdString()));
        for (const char *key : {"skyseal", "time", "command_line", "commit"})
            QVERIFY2(!event[QLatin1String(key)].toString().isEmpty(), key);
    }
    QCOMPARE(used.size(), 2);
    QCOMPARE(used[0], opensslUsesAes().value_or(false)); // this process has no mask
    QCOMPARE(used[1], false);
}

SKYSEAL_TEST(SettingTest)
#include "setting_test.moc"
