// The samples of the diagnostics: rates are the growth of the counters, and the cost of the first record of a wake-up is kept
// apart from the cost of the records behind it.
#include "core/engine/station/metrics_sampler.h"
#include "core/engine/common/suite_meter.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;
using crypto::SuiteId;

class MetricsSamplerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ratesAndOverheadAreTheGrowthOfTheCounters()
    {
        MetricsSampler sampler;
        MetricsSampler::Reading reading;
        reading.linkUp = true;
        reading.channel.up = true;
        reading.channel.suite = SuiteId::Aes256Gcm;
        reading.channel.roundTrip = 12ms;
        reading.sessions.resize(1);
        MetricsSampler::Session &session = reading.sessions[0];
        session.suite = SuiteId::Aes256Gcm;
        reading.latency = 0.02;
        TimePoint now{};
        for (int i = 0; i <= 8; ++i, now += MetricsSampler::kEvery) {
            const auto n = static_cast<std::uint64_t>(i);
            session.mavlink.frames = 20 * n;
            session.mavlink.lost = 5 * n;
            session.stats.rx.good = 9 * n;
            session.stats.rx.lost = n;
            session.stats.rx.openedBytes = 800 * n;
            session.stats.peerFrames = channel::FrameCounters{17 * n, 3 * n};
            reading.channel.wire = {1000 * n, 800 * n, 300 * n, 200 * n};
            reading.channel.rx.forged = n;
            reading.rxBytes = 1100 * n;
            reading.txBytes = 310 * n;
            sampler.sample(now, seconds(now.time_since_epoch()), reading);
        }
        const MetricsSample &last = sampler.samples().back();
        QCOMPARE(last.number, std::uint64_t(9));
        QCOMPARE(last.openedFramesPerSecond, 80.0);
        QCOMPARE(last.openedBytesPerSecond, 3200.0);
        QCOMPARE(last.rxBytesPerSecond, 4400.0);
        QCOMPARE(last.txBytesPerSecond, 1240.0);
        QCOMPARE(last.lossPercent, 10.0);
        QCOMPARE(last.mavlinkLossPercent, 20.0);
        QCOMPARE(last.peerMavlinkLossPercent, 15.0);
        QCOMPARE(last.rxOverheadPercent, 25.0);
        QCOMPARE(last.txOverheadPercent, 50.0);
        QCOMPARE(last.latency, 0.02);
        QCOMPARE(last.roundTrip, 0.012);
        QCOMPARE(last.refused, std::uint64_t(8));
        QVERIFY(last.residentBytes > 1'000'000);
    }

    void suiteIsNotCreditedWithWhatItDidNotOpen()
    {
        // A vehicle in clear and one under another suite send ten times as much, and lose half of it.
        MetricsSampler sampler;
        MetricsSampler::Reading reading;
        reading.linkUp = reading.channel.up = true;
        reading.channel.suite = SuiteId::ChaCha20;
        for (std::uint64_t i = 0; i < 3; ++i) {
            const SuiteId suite = i == 2 ? SuiteId::Aes256Gcm : SuiteId::ChaCha20;
            reading.sessions.push_back(
                {.id = channel::SessionId{static_cast<std::uint32_t>(i + 1)}, .suite = suite, .cpuPercent = 0.5});
        }
        for (std::uint64_t n = 0; n <= 4; ++n) {
            for (std::size_t i = 0; i < 3; ++i) {
                MetricsSampler::Session &session = reading.sessions[i];
                session.mavlink.frames = i == 2 ? 160 * n : 8 * n;
                session.mavlink.lost = i == 2 ? 160 * n : 0;
                session.stats.rx.good = session.mavlink.frames;
                session.stats.rx.lost = session.mavlink.lost;
                session.stats.rx.openedBytes = 50 * session.mavlink.frames;
            }
            reading.clear = {.frames = 160 * n, .lost = 160 * n, .bytes = 8000 * n};
            sampler.sample(TimePoint{} + static_cast<int>(n) * MetricsSampler::kEvery, 0, reading);
        }
        const MetricsSample &sealed = sampler.samples().back();
        QCOMPARE(sealed.openedFramesPerSecond, 64.0); // both vehicles under ChaCha20
        QCOMPARE(sealed.openedBytesPerSecond, 3200.0);
        QCOMPARE(sealed.mavlinkLossPercent, 0.0);
        QCOMPARE(sealed.lossPercent, 0.0);
        QCOMPARE(sealed.suiteCpuPercent, 1.0);
        reading.channel.up = false;
        reading.channel.suite = SuiteId::None;
        reading.sessions.clear();
        sampler.sample(TimePoint{}, 0, reading);
        QCOMPARE(sampler.samples().back().openedFramesPerSecond, 480.0); // a quarter without a new frame
        QCOMPARE(sampler.samples().back().mavlinkLossPercent, 50.0);
    }

    void costOfWatchingIsTheGrowthOfItsTime()
    {
        MetricsSampler sampler;
        MetricsSampler::Reading reading;
        for (int i = 0; i <= 8; ++i) {
            reading.watchingCpu = i * 1ms; // four a second
            sampler.sample(TimePoint{} + i * MetricsSampler::kEvery, 0, reading);
        }
        QCOMPARE(sampler.samples().back().watchingCpuPercent, 0.4);
    }

    void duplicateClearFramesDoNotHideLosses()
    {
        MetricsSampler sampler;
        MetricsSampler::Reading reading;
        for (int i = 0; i < 5; ++i) {
            reading.clear.frames += 30; // including ten duplicates
            reading.clear.duplicate += 10;
            reading.clear.lost += 5;
            sampler.sample(TimePoint{}, 0, reading);
        }
        QCOMPARE(sampler.samples().back().mavlinkLossPercent, 20.0);
        QVERIFY(std::isnan(sampler.samples().back().peerMavlinkLossPercent)); // no agent reports it
    }

    void powerIsTheGrowthOfTheKernelsCounter()
    {
        QTemporaryDir folder;
        const auto write = [&](const char *file, const char *text) {
            const QString path = folder.filePath(QStringLiteral("class/powercap/") + QLatin1String(file));
            QVERIFY(QDir().mkpath(QFileInfo(path).path()));
            QFile out(path);
            QVERIFY(out.open(QIODevice::WriteOnly) && out.write(text) > 0);
        };
        write("intel-rapl:0/name", "package-0\n");
        write("intel-rapl:0/max_energy_range_uj", "262143328850\n");
        write("intel-rapl:0/energy_uj", "262143000000\n");
        write("intel-rapl:0:0/name", "core\n"); // a part of the package
        write("intel-rapl:0:0/energy_uj", "7\n");
        write("psys/name", "psys\n");
        write("psys/energy_uj", "9\n");
        MetricsSampler sampler(folder.path().toStdString());
        sampler.sample(TimePoint{}, 0, {});
        QVERIFY(std::isnan(sampler.samples().back().powerWatts)); // a single reading
        write("intel-rapl:0/energy_uj", "14671150\n");            // the counter wrapped: 15 J in all
        for (int i = 1; i <= 4; ++i)
            sampler.sample(TimePoint{} + i * 500ms, 0, {});
        QCOMPARE(sampler.samples().back().powerWatts, 7.5);
        MetricsSampler elsewhere("/nonexistent");
        for (int i = 0; i <= 8; ++i)
            elsewhere.sample(TimePoint{} + i * 250ms, 0, {});
        QVERIFY(std::isnan(elsewhere.samples().back().powerWatts));
    }

    void duplicatesAreAnIncidentOnlyIfTheyOutnumberOriginals()
    {
        MetricsSampler sampler;
        MetricsSampler::Reading reading;
        reading.channel.up = true;
        const auto pass = [&](std::uint64_t good, std::uint64_t replayed) {
            for (int i = 0; i < 6; ++i) {
                reading.channel.rx.good += good;
                reading.channel.rx.replayed += replayed;
                sampler.sample(TimePoint{}, 0, reading);
            }
            return sampler.samples().back().refused;
        };
        QCOMPARE(pass(20, 5), std::uint64_t(0)); // a network that delivers twice
        QVERIFY(pass(2, 50) >= 150);             // a replay attack
    }

    void overheadIsZeroOnAPlainLinkAndUnknownOnASilentOne()
    {
        MetricsSampler sampler;
        MetricsSampler::Reading reading;
        for (int i = 0; i < 5; ++i) {
            reading.rxBytes += 100;
            reading.clear.bytes += 90; // the other bytes are announcements of an agent
            sampler.sample(TimePoint{} + i * MetricsSampler::kEvery, i * 0.25, reading);
        }
        QCOMPARE(sampler.samples().back().rxOverheadPercent, 0.0);
        QCOMPARE(sampler.samples().back().openedBytesPerSecond, 360.0);
        QVERIFY(std::isnan(sampler.samples().back().roundTrip));
        reading.channel.up = true; // a session without traffic: no share can be computed
        for (int i = 5; i < 10; ++i)
            sampler.sample(TimePoint{} + i * MetricsSampler::kEvery, i * 0.25, reading);
        QVERIFY(std::isnan(sampler.samples().back().rxOverheadPercent));
    }

    void costOfTheFirstRecordIsKeptApart()
    {
        SuiteMeter meter;
        meter.roll(TimePoint{});
        for (int i = 0; i < 50; ++i) {
            meter.opened(SuiteId::ChaCha20Poly1305, 8000, 40, true);
            meter.opened(SuiteId::ChaCha20Poly1305, 700, 40, false);
        }
        meter.roll(TimePoint{} + 1s);
        QVERIFY(meter.cost().openNsP99 >= 8000);
        QVERIFY(meter.cost().openNextNsP50 >= 700 && meter.cost().openNextNsP99 < 730);
        QCOMPARE(meter.cost().cpuPercent, 50 * 8.7e-6 * 100);
        meter.opened(SuiteId::ChaCha20Poly1305, 8000, 40, true);
        meter.roll(TimePoint{} + 2s);
        QCOMPARE(meter.cost().openNextNsP50, 0.0); // no such record within the last second
    }
};

SKYSEAL_TEST(MetricsSamplerTest)
#include "metrics_sampler_test.moc"
