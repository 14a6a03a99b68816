// The load that takes what a link carries, over simulated links: it fills a slow line without losing anything to it, and
// grows where nothing is in its way.
#include "core/impair/impairment.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "core/sim/saturator.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::sim;
using namespace std::chrono_literals;

namespace {

/// A vehicle under load, and a station that answers TIMESYNC behind an impaired link.
class LoadedLink
{
public:
    explicit LoadedLink(const impair::ImpairmentSettings &settings)
        : m_up(settings, 0), m_down(settings, 1), m_vehicle({}, TimePoint()), m_station(255, 190)
    {}

    void run(Duration time)
    {
        for (const TimePoint end = m_now + time; m_now < end; m_now += 1ms) {
            if (m_now >= m_nextHeartbeat) {
                m_nextHeartbeat += 1s;
                say(mavlink::Heartbeat{});
            }
            impair::Impairment::Delivery delivery;
            while (m_down.pop(m_now, delivery)) {
                if (m_connected)
                    hear(delivery.bytes, [this](const mavlink::Frame &frame) { load.handleFrame(m_now, frame); });
            }
            m_vehicle.advance(m_now);
            bool more = true;
            while (more) {
                more = load.advance(m_now, m_vehicle);
                for (ByteView frame = m_vehicle.pollFrame(); !frame.empty(); frame = m_vehicle.pollFrame())
                    m_up.push(m_now, frame);
            }
            while (m_up.pop(m_now, delivery)) {
                if (m_connected)
                    hear(delivery.bytes, [this](const mavlink::Frame &frame) { answer(frame); });
            }
        }
    }

    const impair::Counters &up() const { return m_up.counters(); }
    void setConnected(bool connected) { m_connected = connected; }
    void setSettings(const impair::ImpairmentSettings &settings)
    {
        m_up = impair::Impairment(settings, 0);
        m_down = impair::Impairment(settings, 1);
    }
    Saturator load;

private:
    template<typename Take> static void hear(ByteView bytes, const Take &take)
    {
        if (const auto frame = mavlink::readFrame(bytes, mavlink::Dialect::builtin()))
            take(*frame);
    }

    template<typename Message> void say(const Message &message)
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        m_down.push(m_now, m_station.write(message, buffer));
    }

    void answer(const mavlink::Frame &frame)
    {
        if (frame.messageId() != mavlink::Timesync::kId)
            return;
        auto sync = mavlink::Timesync::decode(frame.payload());
        if (sync.tc1 != 0)
            return;
        sync.tc1 = m_now.time_since_epoch().count() + 1;
        say(sync);
    }

    impair::Impairment m_up, m_down;
    SimulatedVehicle m_vehicle;
    mavlink::FrameWriter m_station;
    TimePoint m_now{}, m_nextHeartbeat{};
    bool m_connected = true;
};

} // namespace

class SaturatorTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void slowLineIsFullAndLosesNothing_data();
    void slowLineIsFullAndLosesNothing();
    void fastLinkIsAskedForAllOfIt();
    void lossMakesItSlower();
    void lossNeverStopsIt_data();
    void lossNeverStopsIt();
    void goesOnAfterAnOutage_data();
    void goesOnAfterAnOutage();
    void longTripsAreLearnt();
};

void SaturatorTest::slowLineIsFullAndLosesNothing_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("delay");
    for (const int baud : {57'600, 115'200, 921'600}) {
        for (const int delay : {0, 20, 200})
            QTest::addRow("%d baud, %d ms", baud, delay) << baud << delay;
    }
}

void SaturatorTest::slowLineIsFullAndLosesNothing()
{
    QFETCH(int, baud);
    QFETCH(int, delay);
    impair::ImpairmentSettings settings;
    settings.baud = static_cast<std::uint64_t>(baud);
    settings.delay = std::chrono::milliseconds(delay);
    LoadedLink link(settings);
    link.run(15s);
    const impair::Counters before = link.up();
    link.run(20s);
    const double share = static_cast<double>(link.up().deliveredBytes - before.deliveredBytes) / (20.0 * baud / 10);
    QVERIFY2(link.up().queueFull == 0,
             qPrintable(QStringLiteral("%1, of these %2 at first").arg(link.up().queueFull).arg(before.queueFull)));
    QVERIFY2(share > 0.97, qPrintable(QString::number(share)));
}

void SaturatorTest::fastLinkIsAskedForAllOfIt()
{
    impair::ImpairmentSettings settings;
    settings.delay = 10ms;
    LoadedLink link(settings);
    link.run(5s);
    QCOMPARE(static_cast<double>(link.load.unanswered()), Saturator::kWidest);
}

void SaturatorTest::lossMakesItSlower()
{
    impair::ImpairmentSettings settings;
    settings.delay = 10ms;
    LoadedLink clean(settings);
    settings.loss = 0.02;
    LoadedLink lossy(settings);
    clean.run(10s);
    lossy.run(10s);
    QVERIFY(lossy.up().offered * 2 < clean.up().offered);
    QVERIFY(lossy.up().offered > 1000);
}

void SaturatorTest::lossNeverStopsIt_data()
{
    QTest::addColumn<double>("loss");
    QTest::addColumn<int>("delay");
    for (const double loss : {0.02, 0.05, 0.1, 0.3}) {
        for (const int delay : {0, 10})
            QTest::addRow("%g, %d ms", loss, delay) << loss << delay;
    }
}

/// More than telemetry, some 70 messages a second, in each second.
void SaturatorTest::lossNeverStopsIt()
{
    QFETCH(double, loss);
    QFETCH(int, delay);
    impair::ImpairmentSettings settings;
    settings.loss = loss;
    settings.delay = std::chrono::milliseconds(delay);
    LoadedLink link(settings);
    link.run(5s);
#ifdef SKYSEAL_SANITIZED
    constexpr int kSeconds = 6; // a simulated minute takes real minutes
#else
    constexpr int kSeconds = 60;
#endif
    for (int second = 0; second < kSeconds; ++second) {
        const auto before = link.up().offered;
        link.run(1s);
        const auto offered = link.up().offered - before;
        QVERIFY2(offered > 400, qPrintable(QStringLiteral("%1 in second %2").arg(offered).arg(second)));
    }
}

void SaturatorTest::goesOnAfterAnOutage_data()
{
    QTest::addColumn<int>("seconds");
    for (const int seconds : {1, 3, 10, 60})
        QTest::addRow("%d s", seconds) << seconds;
}

void SaturatorTest::goesOnAfterAnOutage()
{
    QFETCH(int, seconds);
    LoadedLink link({});
    link.run(5s);
    auto before = link.up().offered;
    link.run(1s);
    const auto usual = link.up().offered - before;
    link.setConnected(false);
    link.run(std::chrono::seconds(seconds));
    link.setConnected(true);
    link.run(500ms);
    before = link.up().offered;
    link.run(1s);
    const auto after = link.up().offered - before;
    QVERIFY2(after * 2 > usual, qPrintable(QStringLiteral("%1 of %2").arg(after).arg(usual)));
}

/// The way becomes a long one: what was given up is answered all the same, and from then on waited for, else burst after
/// burst would be sent into it.
void SaturatorTest::longTripsAreLearnt()
{
    LoadedLink link({});
    link.run(5s);
    impair::ImpairmentSettings slow;
    slow.delay = 700ms;
    link.setSettings(slow);
    link.run(20s);
    const auto before = link.up().offered;
    link.run(20s);
    const double bursts = static_cast<double>(link.up().offered - before) / static_cast<double>(Saturator::kBurst) / 20;
    QVERIFY2(bursts < 4, qPrintable(QString::number(bursts))); // telemetry, and two a trip
}

SKYSEAL_TEST(SaturatorTest)
#include "saturator_test.moc"
