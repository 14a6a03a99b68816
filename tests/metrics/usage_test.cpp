// Rates over a sliding window on a simulated clock; CPU, memory and power readings.
#include "core/metrics/cycle_clock.h"
#include "core/metrics/machine_usage.h"
#include "core/metrics/power_meter.h"
#include "core/metrics/process_usage.h"
#include "core/metrics/rate_meter.h"
#include "core/metrics/work_clock.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <vector>

#include <poll.h>

using namespace skyseal;
using namespace skyseal::metrics;
using std::chrono::milliseconds;

namespace {

/// A folder that stands for /sys.
class Sysfs
{
public:
    std::string path() const { return m_folder.path().toStdString(); }
    void write(const QByteArray &folder, const char *file, const char *text) const
    {
        const QString path = m_folder.filePath(QString::fromUtf8(folder));
        QFile out(path + QLatin1Char('/') + QLatin1String(file));
        if (!QDir().mkpath(path) || !out.open(QIODevice::WriteOnly) || out.write(text) < 0)
            qFatal("%s: %s", qPrintable(out.fileName()), qPrintable(out.errorString()));
    }

private:
    QTemporaryDir m_folder;
};

} // namespace

class UsageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void steadyRateIsExact();
    void rateFallsToZeroInSilence();
    void earlyRateIsNotDiluted();
    void cpuPercentOfOneCore();
    void readsThisProcess();
    void cycleClockAgreesWithCpuTime();
    void preemptionIsNotCountedAsWork();
    void powerIsTheGrowthOfTheEnergyCounter();
    void supplySensorIsAddedUp();
    void throttlingIsCounted();
};

static TimePoint at(int ms)
{
    return TimePoint(std::chrono::seconds(1000) + milliseconds(ms));
}

void UsageTest::steadyRateIsExact()
{
    RateMeter meter;
    for (int ms = 0; ms < 10'000; ms += 5)
        meter.add(at(ms), 3);
    QCOMPARE(meter.perSecond(at(10'000)), 600.0);
    QCOMPARE(meter.total(), std::uint64_t(6000));
}

void UsageTest::rateFallsToZeroInSilence()
{
    RateMeter meter;
    for (int ms = 0; ms < 3000; ms += 10)
        meter.add(at(ms));
    QCOMPARE(meter.perSecond(at(3000)), 100.0);
    QCOMPARE(meter.perSecond(at(3500)), 50.0);
    QCOMPARE(meter.perSecond(at(4100)), 0.0);
    // Amounts of earlier rounds do not reappear.
    meter.add(at(60'000));
    QCOMPARE(meter.perSecond(at(60'100)), 1.0);
}

void UsageTest::earlyRateIsNotDiluted()
{
    RateMeter meter;
    QCOMPARE(meter.perSecond(at(0)), 0.0);
    for (int ms = 0; ms < 500; ms += 10)
        meter.add(at(ms));
    QCOMPARE(meter.perSecond(at(500)), 100.0);
}

void UsageTest::cpuPercentOfOneCore()
{
    CpuSampler sampler;
    QCOMPARE(sampler.sample(at(0), std::chrono::seconds(5)), 0.0);
    QCOMPARE(sampler.sample(at(1000), std::chrono::seconds(5) + milliseconds(250)), 25.0);
    QCOMPARE(sampler.sample(at(1000), std::chrono::seconds(9)), 25.0);
    QCOMPARE(sampler.sample(at(2000), std::chrono::seconds(7) + milliseconds(250)), 200.0);
    QCOMPARE(sampler.percent(), 200.0);
    MemorySampler memory;
    memory.sample(10);
    memory.sample(30);
    memory.sample(20);
    QCOMPARE(memory.bytes(), std::uint64_t(20));
    QCOMPARE(memory.peak(), std::uint64_t(30));
}

void UsageTest::readsThisProcess()
{
    const auto before = residentBytes();
    QVERIFY(before && *before > 1'000'000);
    std::vector<char> ballast(64 << 20, 1);
    const auto after = residentBytes();
    QVERIFY(after && *after > *before + (60u << 20));
    QVERIFY(ballast[ballast.size() / 2] == 1);
}

void UsageTest::cycleClockAgreesWithCpuTime()
{
    using std::chrono::steady_clock;
    const CycleClock clock = CycleClock::measure();
    // Each reading of the cycle counter lies between two of the monotonic clock, wherever the thread is preempted.
    const auto beforeBegin = steady_clock::now();
    const std::uint64_t begin = CycleClock::now();
    const auto afterBegin = steady_clock::now();
    const Duration cpu = threadCpuTime();
    const Duration process = processCpuTime();
    while (threadCpuTime() - cpu < milliseconds(20)) {}
    // The process clock is read slightly later than the thread's clock.
    QVERIFY(processCpuTime() - process >= milliseconds(15));
    const auto beforeEnd = steady_clock::now();
    const std::uint64_t end = CycleClock::now();
    const auto afterEnd = steady_clock::now();
    const auto nanoseconds = [](auto time) { return std::chrono::duration<double, std::nano>(time).count(); };
    const auto measured = static_cast<double>(clock.between(begin, end));
    QVERIFY2(measured > 0.9 * nanoseconds(beforeEnd - afterBegin) && measured < 1.1 * nanoseconds(afterEnd - beforeBegin),
             qPrintable(QString::number(measured)));
    QCOMPARE(clock.between(5, 4), std::uint64_t(0));
}

void UsageTest::preemptionIsNotCountedAsWork()
{
    const auto spin = [](Duration work) {
        const Duration until = threadCpuTime() + work;
        while (threadCpuTime() < until) {}
    };
    WorkClock clock;
    // Before the first piece and between two pieces the thread works and is preempted as well.
    for (int piece = 0; piece < 2; ++piece) {
        spin(milliseconds(1));
        ::poll(nullptr, 0, 40);
        const std::uint64_t begin = clock.begin();
        spin(milliseconds(10));
        ::poll(nullptr, 0, 40);
        spin(milliseconds(10));
        const std::uint64_t worked = clock.between(begin, CycleClock::now());
        QVERIFY2(worked > 19'000'000 && worked < 26'000'000, qPrintable(QString::number(worked)));
    }
    const std::uint64_t next = clock.begin();
    const std::uint64_t brief = clock.between(next, next + 1000);
    QVERIFY(brief > 0 && brief < 1000); // short pieces are taken from the cycle counter
    // The first preemption after them comes unforeseen: the piece counts like the one before it. The next is measured.
    std::uint64_t begin = clock.begin();
    ::poll(nullptr, 0, 40);
    QCOMPARE(clock.between(begin, CycleClock::now()), brief);
    begin = clock.begin();
    spin(milliseconds(10));
    ::poll(nullptr, 0, 40);
    const std::uint64_t worked = clock.between(begin, CycleClock::now());
    QVERIFY2(worked > 9'000'000 && worked < 13'000'000, qPrintable(QString::number(worked)));
}

void UsageTest::powerIsTheGrowthOfTheEnergyCounter()
{
    Sysfs sysfs;
    const auto write = [&](const char *file, const char *text) { sysfs.write("class/powercap/intel-rapl:0", file, text); };
    write("name", "package-0\n");
    write("max_energy_range_uj", "262143328850\n");
    write("energy_uj", "1000000\n");
    PowerMeter meter(sysfs.path());
    meter.sample(at(0));
    QVERIFY(!meter.watts()); // a single reading
    write("energy_uj", "5000000\n");
    meter.sample(at(500));
    QCOMPARE(meter.watts().value(), 8.0);
    meter.sample(at(500));
    QVERIFY(!meter.watts()); // no time has passed
    PowerMeter unreadable("/nonexistent");
    unreadable.sample(at(0));
    unreadable.sample(at(1000));
    QVERIFY(!unreadable.watts());
}

void UsageTest::supplySensorIsAddedUp()
{
    Sysfs sysfs;
    sysfs.write("class/hwmon/hwmon0", "name", "amdgpu\n"); // of no interest
    sysfs.write("class/hwmon/hwmon0", "power1_average", "90000000\n");
    sysfs.write("class/hwmon/hwmon1", "name", "ina226\n");
    sysfs.write("class/hwmon/hwmon1", "power1_input", "2000000\n");
    EnergyMeter meter(sysfs.path());
    QCOMPARE(meter.describe(), std::string("power1 of ina226 (hwmon)"));
    QCOMPARE(meter.microjoules(at(0)).value(), std::uint64_t(0));
    sysfs.write("class/hwmon/hwmon1", "power1_input", "4000000\n");
    QCOMPARE(meter.microjoules(at(500)).value(), std::uint64_t(1'500'000)); // 3 W for half a second

    Sysfs board;
    board.write("bus/iio/devices/iio:device0", "name", "ina3221\n");
    board.write("bus/iio/devices/iio:device0", "in_power0_raw", "10\n"); // a rail of the supply
    board.write("bus/iio/devices/iio:device0", "in_power0_scale", "20.0\n");
    board.write("bus/iio/devices/iio:device0", "in_power1_raw", "100\n");
    board.write("bus/iio/devices/iio:device0", "in_power1_scale", "20.0\n"); // milliwatts a unit
    EnergyMeter supply(board.path());
    QCOMPARE(supply.describe(), std::string("in_power1 of ina3221 (IIO)"));
    supply.microjoules(at(0));
    QCOMPARE(supply.microjoules(at(1000)).value(), std::uint64_t(2'000'000));

    Sysfs server;
    server.write("class/hwmon/hwmon0", "name", "amd_energy\n");
    server.write("class/hwmon/hwmon0", "energy1_input", "7\n");
    server.write("class/hwmon/hwmon0", "energy1_label", "Ecore000\n");
    server.write("class/hwmon/hwmon0", "energy2_input", "1000\n");
    server.write("class/hwmon/hwmon0", "energy2_label", "Esocket0\n");
    EnergyMeter socket(server.path());
    QCOMPARE(socket.describe(), std::string("energy2 of amd_energy (hwmon)"));
    server.write("class/hwmon/hwmon0", "energy2_input", "1600\n");
    QCOMPARE(socket.microjoules(at(0)).value(), std::uint64_t(600));
}

void UsageTest::throttlingIsCounted()
{
    Sysfs sysfs;
    MachineUsage nothing;
    readThrottling(sysfs.path(), nothing);
    QVERIFY(!nothing.throttlings && !nothing.isThrottled);
    for (const char *core : {"0", "1"}) {
        const QByteArray folder = QByteArray("devices/system/cpu/cpu") + core + "/thermal_throttle";
        sysfs.write(folder, "core_throttle_count", core);
        sysfs.write(folder, "package_throttle_count", "5");
    }
    MachineUsage usage;
    readThrottling(sysfs.path(), usage);
    QCOMPARE(usage.throttlings.value(), std::uint64_t(6)); // of the second core and of the package, once
    Sysfs pi;
    pi.write("devices/platform/soc/soc:firmware", "get_throttled", "50000\n"); // earlier
    MachineUsage firmware;
    readThrottling(pi.path(), firmware);
    QVERIFY(firmware.throttlings && !firmware.isThrottled);
    pi.write("devices/platform/soc/soc:firmware", "get_throttled", "50005\n");
    readThrottling(pi.path(), firmware);
    QVERIFY(firmware.isThrottled);
}

SKYSEAL_TEST(UsageTest)
#include "usage_test.moc"
