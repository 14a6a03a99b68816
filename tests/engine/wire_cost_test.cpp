// The cost of sealing on a 57,600-baud radio, in bytes that are really written to a serial device, and how long frames are
// coalesced there. The clock is simulated, the device is a pseudo-terminal, and the far end reads and opens what arrives.
#include "core/channel/endpoint.h"
#include "core/crypto/init_crypto.h"
#include "core/engine/common/carrier_reader.h"
#include "core/engine/common/channel_driver.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/stream_parser.h"
#include "tests/engine/bare_end.h"
#include "tests/support/test_runner.h"

#include <QtCore/QCoreApplication>
#include <QtTest/QTest>

#include <random>

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::engine;
using namespace skyseal::test;
using namespace std::chrono_literals;

namespace {

constexpr std::uint64_t kSeed = 20261121;

/// A telemetry radio's usual load from a copter: how often, and how long the payload is with its trailing zeros cut.
struct Stream
{
    std::uint32_t id;
    int hertz;
    std::size_t least, most;
};
constexpr Stream kMix[] = {
    {30, 10, 27, 28}, // ATTITUDE
    {33, 6, 26, 28},  // GLOBAL_POSITION_INT
    {74, 6, 18, 20},  // VFR_HUD
    {24, 4, 28, 31},  // GPS_RAW_INT, most of its extensions zero
    {1, 4, 22, 31},   // SYS_STATUS
    {27, 4, 22, 26},  // RAW_IMU
    {29, 4, 11, 14},  // SCALED_PRESSURE
    {36, 4, 12, 21},  // SERVO_OUTPUT_RAW
    {65, 4, 34, 42},  // RC_CHANNELS
    {62, 4, 22, 26},  // NAV_CONTROLLER_OUTPUT
    {42, 2, 1, 3},    // MISSION_CURRENT
    {163, 2, 22, 28}, // AHRS
    {2, 2, 9, 12},    // SYSTEM_TIME
    {125, 2, 2, 6},   // POWER_STATUS
    {193, 2, 21, 22}, // EKF_STATUS_REPORT
    {0, 1, 9, 9},     // HEARTBEAT
    {147, 1, 36, 41}, // BATTERY_STATUS
};

constexpr int perSecond()
{
    int sum = 0;
    for (const Stream &stream : kMix)
        sum += stream.hertz;
    return sum;
}
static_assert(perSecond() == 62);

struct TimedFrame
{
    TimePoint at;
    Bytes bytes;
};

/// Each stream with a phase of its own, served in the autopilot's loop of 400 Hz.
std::vector<TimedFrame> telemetry(TimePoint from, Duration span)
{
    std::mt19937_64 random(kSeed);
    std::vector<TimedFrame> out;
    std::uint8_t sequence = 0;
    for (const Stream &stream : kMix) {
        const Duration period = Duration(1s) / stream.hertz;
        const auto tick = Duration(2500us);
        for (Duration at = period * static_cast<long>(random() % 1000) / 1000; at < span; at += period)
            out.push_back({from + at / tick * tick, {static_cast<std::uint8_t>(&stream - kMix)}});
    }
    std::stable_sort(out.begin(), out.end(), [](const TimedFrame &a, const TimedFrame &b) { return a.at < b.at; });
    for (TimedFrame &frame : out) {
        const Stream &stream = kMix[frame.bytes[0]];
        const mavlink::MessageInfo *info = mavlink::Dialect::builtin().find(stream.id);
        Bytes payload(stream.least + random() % (stream.most - stream.least + 1));
        for (auto &byte : payload)
            byte = static_cast<std::uint8_t>(random() % 255 + 1);
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        const auto bytes = mavlink::writeFrame(buffer, 2, sequence++, 1, 1, stream.id, info->crcExtra, info->minLength,
                                               payload);
        frame.bytes.assign(bytes.begin(), bytes.end());
    }
    return out;
}

class Radio
{
public:
    Radio() : m_fd(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        if (m_fd < 0 || ::grantpt(m_fd) != 0 || ::unlockpt(m_fd) != 0)
            qFatal("no pseudo-terminal");
    }
    ~Radio() { ::close(m_fd); }
    Radio(const Radio &) = delete;
    Radio &operator=(const Radio &) = delete;
    std::string device() const { return ::ptsname(m_fd); }
    MutableByteView read()
    {
        const ssize_t size = ::read(m_fd, m_bytes.data(), m_bytes.size());
        return MutableByteView(m_bytes).first(size > 0 ? static_cast<std::size_t>(size) : 0);
    }

private:
    int m_fd;
    std::array<std::uint8_t, 65536> m_bytes;
};

struct NoListener final : link::LinkListener
{
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
};

/// An agent's driver on the radio, and a station's endpoint at the other end of the air.
class Downlink
{
public:
    Downlink(Carrier carrier, crypto::SuiteId suite)
        : m_carrier(carrier), m_links(m_nobody, [](link::Link &) {}), m_agentSecrets(m_keys.secrets(channel::Role::Agent)),
          m_stationSecrets(m_keys.secrets(channel::Role::Station))
    {
        m_links.carriers().setNode({1, 191});
        m_link = &m_links.open(LinkId{1}, *link::LinkUrl::parse("serial:" + m_radio.device() + ":57600"));
        channel::Endpoint agent(config(channel::Role::Agent, *m_agentSecrets, suite), m_agentSecrets->random,
                                *m_agentSecrets->counters, now);
        m_station.emplace(config(channel::Role::Station, *m_stationSecrets, suite), m_stationSecrets->random,
                          *m_stationSecrets->counters, now);
        m_driver.emplace(std::move(agent), m_links);
    }

    bool usable() const { return m_link->state() == link::LinkState::Connected; }
    ChannelDriver &driver() { return *m_driver; }
    channel::SessionId session() const { return m_session; }
    bool up() const { return m_up && m_station->sessions().size() == 1; }

    /// Everything that is due now, in both directions.
    void turn()
    {
        if (m_driver->endpoint().nextDeadline() <= now)
            m_driver->endpoint().handleDeadline(now);
        if (m_station->nextDeadline() <= now)
            m_station->handleDeadline(now);
        say();
        m_driver->flush(now);
        m_links.flush();
        QCoreApplication::processEvents();
        for (MutableByteView piece = m_radio.read(); !piece.empty(); piece = m_radio.read()) {
            written += piece.size();
            const link::ReceivedBlock block{{LinkId{2}, {}}, piece, now};
            if (m_carrier == Carrier::Serial)
                m_reader.takeCobs(
                    block, [](ByteView) { return false; },
                    [this](const link::ReceivedBlock &message) {
                        take(message);
                        return true;
                    });
            else
                m_parser.feed(piece, [&](const mavlink::ScanItem &item) {
                    if (!CarrierReader::isTunnel(item))
                        return;
                    ++tunnels;
                    if (const auto message = m_reader.takeTunnel(now, block.path, *item.frame, {255, 190}))
                        take(*message);
                });
        }
        say();
        while (const auto event = m_driver->pollEvent()) {
            if (const auto *up = std::get_if<channel::SessionUp>(&*event)) {
                m_session = up->session;
                m_up = true;
            }
        }
        while (m_station->pollEvent()) {}
    }

    /// Of the records that arrived.
    channel::ReceiveCounters received() const { return m_station->stats(m_station->sessions()[0])->rx; }

    TimePoint now{1h};
    std::uint64_t written = 0, records = 0, frames = 0, tunnels = 0;

private:
    channel::Config config(channel::Role role, engine::SecretFiles &secrets, crypto::SuiteId suite) const
    {
        channel::Config out;
        out.role = role;
        out.identity = secrets.identity;
        out.peers = secrets.peers;
        out.policy = {{suite}, false, false};
        out.announceTo = {{LinkId{1}, {}, m_carrier}};
        return out;
    }

    void say()
    {
        while (const auto out = m_station->pollTransmit()) {
            Bytes bytes(out->bytes.begin(), out->bytes.end());
            const Node node = m_carrier == Carrier::Tunnel ? Node{255, 190} : Node{};
            m_driver->receive(now, {LinkId{1}, {}, m_carrier, node}, bytes);
        }
    }

    void take(const link::ReceivedBlock &message)
    {
        if (const auto delivery = m_station->handleDatagram(now, message.path, message.bytes)) {
            ++records;
            mavlink::FrameScanner scanner(delivery->frames, mavlink::Dialect::builtin());
            while (const auto item = scanner.next())
                frames += item->frame.has_value();
        }
    }

    Carrier m_carrier;
    Radio m_radio;
    NoListener m_nobody;
    LinkPool m_links;
    Introduced m_keys;
    std::unique_ptr<engine::SecretFiles> m_agentSecrets, m_stationSecrets;
    link::Link *m_link = nullptr;
    std::optional<ChannelDriver> m_driver;
    std::optional<channel::Endpoint> m_station;
    CarrierReader m_reader;
    mavlink::StreamParser m_parser{mavlink::Dialect::builtin()};
    channel::SessionId m_session{};
    bool m_up = false;
};

void waitForSession(Downlink &link)
{
    for (const TimePoint end = link.now + 10s; !link.up() && link.now < end; link.now += 10ms)
        link.turn();
    // Reports come once a second as soon as the round trip is known.
    for (const TimePoint end = link.now + 5s; link.now < end; link.now += 10ms)
        link.turn();
}

struct Cost
{
    bool complete = false;                       ///< every frame arrived
    double signedPercent = 0, sealedPercent = 0; ///< more bytes than plain
};

Cost measure(Carrier carrier, crypto::SuiteId suite, bool coalesced)
{
    Downlink link(carrier, suite);
    waitForSession(link);
    const Duration span = 120s;
    const auto frames = telemetry(link.now, span);
    std::uint64_t plain = 0;
    link.written = link.records = link.frames = link.tunnels = 0;
    std::size_t next = 0;
    for (const TimePoint end = link.now + span; link.now < end; link.now += 2500us) {
        for (; next < frames.size() && frames[next].at <= link.now; ++next) {
            plain += frames[next].bytes.size();
            link.driver().queue(link.now, link.session(), frames[next].bytes);
            if (!coalesced)
                link.driver().flushAll(link.now);
        }
        link.turn();
    }
    link.driver().flushAll(link.now);
    link.turn();

    const auto percent = [plain](std::uint64_t bytes) { return (double(bytes) / double(plain) - 1) * 100; };
    const Cost cost{link.up() && link.frames == frames.size(), percent(plain + 13 * frames.size()), percent(link.written)};
    qInfo("seed %llu: %zu frames of %.1f bytes; signing +%.1f %%, sealed +%.1f %% with %.2f frames a record, %.0f bytes/s",
          static_cast<unsigned long long>(kSeed), frames.size(), double(plain) / double(frames.size()), cost.signedPercent,
          cost.sealedPercent, double(link.frames) / double(link.records), double(link.written) / seconds(span));
    return cost;
}

} // namespace

class WireCostTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void sealedBytesAreLimited_data();
    void sealedBytesAreLimited();
    void withoutCoalescing();
    void framesAreCoalesced_data() { sealedBytesAreLimited_data(); }
    void framesAreCoalesced();
    void urgentFramesAreSentAtOnce();
    void recordsLeaveInTheOrderOfTheirCounters_data() { sealedBytesAreLimited_data(); }
    void recordsLeaveInTheOrderOfTheirCounters();
};

void WireCostTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
    QVERIFY(Downlink(Carrier::Serial, crypto::SuiteId::ChaCha20Poly1305).usable());
}

void WireCostTest::sealedBytesAreLimited_data()
{
    QTest::addColumn<int>("carrier");
    QTest::addColumn<int>("suite");
    QTest::addColumn<double>("most");
    const auto add = [](const char *name, Carrier carrier, crypto::SuiteId suite, double most) {
        QTest::newRow(name) << static_cast<int>(carrier) << static_cast<int>(suite) << most;
    };
    // Percent of the bytes of plain MAVLink. With padding, the limit is the cost of signing on COBS; TUNNEL adds a frame for
    // each record.
    add("COBS", Carrier::Serial, crypto::SuiteId::ChaCha20Poly1305, 21.3);
    add("COBS, aes-256-cbc", Carrier::Serial, crypto::SuiteId::Aes256Cbc, 37.4);
    add("TUNNEL", Carrier::Tunnel, crypto::SuiteId::ChaCha20Poly1305, 52.4);
    add("TUNNEL, aes-256-cbc", Carrier::Tunnel, crypto::SuiteId::Aes256Cbc, 75);
}

void WireCostTest::sealedBytesAreLimited()
{
    QFETCH(int, carrier);
    QFETCH(int, suite);
    QFETCH(double, most);
    const Cost cost = measure(static_cast<Carrier>(carrier), static_cast<crypto::SuiteId>(suite), true);
    QVERIFY(cost.complete);
    QVERIFY2(cost.sealedPercent <= most, qPrintable(QString::number(cost.sealedPercent)));
}

/// The bytes saved by coalescing.
void WireCostTest::withoutCoalescing()
{
    const Cost alone = measure(Carrier::Serial, crypto::SuiteId::ChaCha20Poly1305, false);
    QVERIFY(alone.complete);
    QVERIFY2(alone.sealedPercent > 55 && alone.sealedPercent < 75, qPrintable(QString::number(alone.sealedPercent)));
}

void WireCostTest::framesAreCoalesced()
{
    QFETCH(int, carrier);
    QFETCH(int, suite);
    Downlink link(static_cast<Carrier>(carrier), static_cast<crypto::SuiteId>(suite));
    waitForSession(link);
    const auto frames = telemetry(link.now, 1s);
    link.records = link.frames = 0;
    const TimePoint begun = link.now;
    link.driver().queue(link.now, link.session(), frames[0].bytes);
    link.turn();
    QCOMPARE(link.driver().flushDue(), begun + ChannelDriver::kCoalesceDelay);
    link.now = begun + 39ms;
    link.driver().queue(link.now, link.session(), frames[1].bytes);
    link.turn();
    QCOMPARE(link.frames, std::uint64_t(0));
    link.now = begun + 40ms;
    link.turn();
    QCOMPARE(link.frames, std::uint64_t(2));
    QCOMPARE(link.records, std::uint64_t(1));
    QCOMPARE(link.driver().flushDue(), kNever);
}

void WireCostTest::urgentFramesAreSentAtOnce()
{
    Downlink link(Carrier::Serial, crypto::SuiteId::ChaCha20Poly1305);
    waitForSession(link);
    const auto frames = telemetry(link.now, 1s);
    mavlink::FrameWriter station(255, 190);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    mavlink::Heartbeat beat;
    beat.type = mavlink::MAV_TYPE_GCS;
    const auto isSentAtOnce = [&](ByteView frame) {
        link.now += 1s;
        link.turn();
        link.frames = 0;
        link.driver().queue(link.now, link.session(), frames[0].bytes);
        link.driver().queue(link.now, link.session(), frame);
        link.turn();
        return link.frames == 2; // the waiting frame is sent with it
    };
    QVERIFY(isSentAtOnce(station.write(mavlink::CommandLong{}, buffer)));
    QVERIFY(isSentAtOnce(station.write(mavlink::CommandInt{}, buffer)));
    QVERIFY(isSentAtOnce(station.write(mavlink::RcChannelsOverride{}, buffer)));
    QVERIFY(isSentAtOnce(station.write(mavlink::ManualControl{}, buffer)));
    QVERIFY(isSentAtOnce(station.write(mavlink::MissionItemInt{}, buffer)));
    QVERIFY(isSentAtOnce(station.write(mavlink::MissionRequestInt{}, buffer)));
    QVERIFY(isSentAtOnce(station.write(beat, buffer)));
    beat.type = mavlink::MAV_TYPE_QUADROTOR;
    QVERIFY(!isSentAtOnce(station.write(beat, buffer)));
    QVERIFY(!isSentAtOnce(station.write(mavlink::ParamValue{}, buffer)));
}

/// Also in a wake-up in which frames are sent beside a report.
void WireCostTest::recordsLeaveInTheOrderOfTheirCounters()
{
    QFETCH(int, carrier);
    QFETCH(int, suite);
    Downlink link(static_cast<Carrier>(carrier), static_cast<crypto::SuiteId>(suite));
    waitForSession(link);
    mavlink::FrameWriter agent(1, 191);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const std::uint64_t before = link.received().good;
    link.frames = 0;
    for (const TimePoint end = link.now + 5s; link.now < end; link.now += 10ms) {
        link.driver().queue(link.now, link.session(), agent.write(mavlink::CommandLong{}, buffer)); // does not wait
        link.turn();
    }
    QVERIFY(link.received().good > before + link.frames); // reports, too
    QCOMPARE(link.received().late, std::uint64_t(0));
    QCOMPARE(link.received().lost, std::uint64_t(0));
}

SKYSEAL_TEST(WireCostTest)
#include "wire_cost_test.moc"
