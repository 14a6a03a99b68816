// The simulated copter holds the same conversation as a real ArduCopter 3.6.7 did, and gives the same facts: messages, rates,
// answers and their order, ranges of fields. What differs on purpose stands in tables here, with the reason; an entry that is
// no longer a difference fails as well.
#include "tests/sim/reference_conversation.h"
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtTest/QTest>

#include <set>

using namespace skyseal;
using namespace skyseal::sim;

namespace {

using Reasons = std::map<std::string, const char *>;

// The simulator behaves like ArduCopter 4.5, the reference is 3.6.
const Reasons kOtherMessages{
    {"AHRS2", "the simulator has one estimator"},
    {"AHRS3", "of 3.6 only"},
    {"HWSTATUS", "of 3.6 only"},
    {"SCALED_IMU3", "the simulator has two inertial sensors"},
    {"SENSOR_OFFSETS", "of 3.6 only"},
    {"SIMSTATE", "a station must not know the true state"},
    {"TERRAIN_REPORT", "TERRAIN_ENABLE is 0"},
    {"TERRAIN_REQUEST", "TERRAIN_ENABLE is 0"},
    {"TIMESYNC", "requests of the vehicle would mix with those that measure the link (--saturate)"},
    {"WIND", "of 4.x"},
};

const Reasons kOtherAnswers{
    {"item 0", "MIS_TOTAL is told when the whole list is stored; MISSION_REQUEST_INT since 4.0"},
    {"item 1", "as item 0"},
    {"item 1 again", "MISSION_REQUEST_INT since 4.0"},
    {"item 2", "as item 0"},
    {"item 2 instead of 1", "MISSION_REQUEST_INT since 4.0"},
    {"item 3 again", "an acknowledgement that was lost is repeated"},
    {"list the fence", "3.6 has fences only as FENCE_POINT, and ignores the type"},
    {"list the rally points", "3.6 has rally points only as RALLY_POINT, and ignores the type"},
    {"message interval", "since 4.0"},
    {"ping", "measures the link with tools that use it"},
    {"read an item beyond the end", "4.x says what was wrong"},
    {"request message", "since 4.0"},
    {"set a fraction of an integer", "RTL_ALT has 32 bits since 4.0"},
    {"set an unknown mode by SET_MODE", "FAILED since 4.0"},
    {"set an unknown mode by command", "FAILED since 4.0"},
    {"upload a mission", "MISSION_REQUEST_INT since 4.0"},
};

const Reasons kOtherRanges{
    {"GPS_RAW_INT.fix_type", "the receiver of the simulator is no RTK receiver"},
    {"RC_CHANNELS.chancount", "its transmitter has eight channels"},
};

/// How far beyond the range of the reference a value may be; nothing for what is not listed.
const std::map<std::string, double> kTolerances{
    {"ATTITUDE.pitch", 0.01},
    {"ATTITUDE.roll", 0.01},
    {"ATTITUDE.yaw", 0.03},
    {"EKF_STATUS_REPORT.compass_variance", 0.1},
    {"EKF_STATUS_REPORT.pos_horiz_variance", 0.1},
    {"EKF_STATUS_REPORT.pos_vert_variance", 0.1},
    {"EKF_STATUS_REPORT.velocity_variance", 0.1},
    {"GLOBAL_POSITION_INT.alt", 400},          // mm
    {"GLOBAL_POSITION_INT.hdg", 150},          // centidegrees
    {"GLOBAL_POSITION_INT.lat", 100},          // 1e-7 degrees
    {"GLOBAL_POSITION_INT.lon", 100},          // 1e-7 degrees
    {"GLOBAL_POSITION_INT.relative_alt", 400}, // mm
    {"GLOBAL_POSITION_INT.vx", 5},             // cm/s
    {"GLOBAL_POSITION_INT.vy", 5},
    {"GLOBAL_POSITION_INT.vz", 5},
    {"GPS_RAW_INT.eph", 60},
    {"GPS_RAW_INT.epv", 100},
    {"GPS_RAW_INT.satellites_visible", 5},
    {"POWER_STATUS.Vcc", 100}, // mV
    {"RAW_IMU.xacc", 10},      // 1/1000 g
    {"RAW_IMU.yacc", 10},
    {"RAW_IMU.zacc", 10},
    {"RAW_IMU.xmag", 20}, // milligauss
    {"RAW_IMU.ymag", 20},
    {"RAW_IMU.zmag", 20},
    {"SCALED_PRESSURE.press_abs", 0.2}, // hPa
    {"SYS_STATUS.battery_remaining", 2},
    {"SYS_STATUS.voltage_battery", 100}, // mV
    {"VFR_HUD.airspeed", 0.2},
    {"VFR_HUD.alt", 0.4},
    {"VFR_HUD.climb", 0.1},
    {"VFR_HUD.groundspeed", 0.1},
    {"VFR_HUD.heading", 2},
};

class SimulatedPeer : public ReferencePeer
{
public:
    void send(ByteView frame) override
    {
        m_station.deliver(frame);
        take();
    }
    bool run(double seconds) override
    {
        m_station.run(seconds);
        take();
        return true;
    }

private:
    void take()
    {
        received.insert(received.end(), m_station.received.begin(), m_station.received.end());
        m_station.forget();
    }

    TestStation m_station;
};

QString joined(const std::vector<std::string> &lines)
{
    QString out;
    for (const std::string &line : lines)
        out += QString::fromStdString(line) + QLatin1String("; ");
    return out;
}

} // namespace

class SimReferenceTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void sendsTheSameMessagesAtTheSameRates();
    void givesTheSameAnswersInTheSameOrder();
    void fieldsAreInTheSameRanges();

private:
    ReferenceFacts m_real, m_simulated;
};

void SimReferenceTest::initTestCase()
{
    QFile file(QStringLiteral(SKYSEAL_SOURCE_DIR "/tests/data/arducopter/conversation.txt"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    m_real = ReferenceFacts::fromText(file.readAll().toStdString());
    QVERIFY(m_real.rates.size() > 25 && m_real.answers.size() > 45 && m_real.ranges.size() > 45);
    SimulatedPeer peer;
    std::string problem;
    m_simulated = holdConversation(peer, problem);
    QCOMPARE(problem, std::string());
}

void SimReferenceTest::sendsTheSameMessagesAtTheSameRates()
{
    std::set<std::string> names;
    for (const auto &entry : m_real.rates)
        names.insert(entry.first);
    for (const auto &entry : m_simulated.rates)
        names.insert(entry.first);
    for (const std::string &name : names) {
        const double real = m_real.rates.contains(name) ? m_real.rates.at(name) : 0;
        const double simulated = m_simulated.rates.contains(name) ? m_simulated.rates.at(name) : 0;
        const bool same = std::abs(real - simulated) <= 0.1 * real;
        QVERIFY2(same != kOtherMessages.contains(name),
                 qPrintable(
                     QStringLiteral("%1: %2 Hz, simulated %3 Hz").arg(QString::fromStdString(name)).arg(real).arg(simulated)));
    }
    // Before a request, the real one sends heartbeats only. The simulated one streams (SR0_ of 4 Hz), so that something is seen
    // without a station that requests anything.
    QCOMPARE(m_real.silentRates.at("HEARTBEAT"), m_simulated.silentRates.at("HEARTBEAT"));
    QVERIFY(!m_real.silentRates.contains("ATTITUDE"));
    QCOMPARE(m_simulated.silentRates.at("ATTITUDE"), 4.0);
}

void SimReferenceTest::givesTheSameAnswersInTheSameOrder()
{
    QCOMPARE(m_simulated.answers.size(), m_real.answers.size());
    for (const auto &[step, real] : m_real.answers) {
        QVERIFY2(m_simulated.answers.contains(step), step.c_str());
        const auto &simulated = m_simulated.answers.at(step);
        QVERIFY2((real == simulated) != kOtherAnswers.contains(step),
                 qPrintable(
                     QStringLiteral("%1: %2simulated: %3").arg(QString::fromStdString(step), joined(real), joined(simulated))));
    }
}

void SimReferenceTest::fieldsAreInTheSameRanges()
{
    for (const auto &[field, real] : m_real.ranges) {
        QVERIFY2(m_simulated.ranges.contains(field), field.c_str());
        const auto &[least, most] = m_simulated.ranges.at(field);
        const auto tolerance = kTolerances.find(field);
        const double beyond = tolerance == kTolerances.end() ? 0 : tolerance->second;
        const bool within = least >= real.first - beyond && most <= real.second + beyond;
        QVERIFY2(within != kOtherRanges.contains(field),
                 qPrintable(QStringLiteral("%1: %2 to %3, simulated %4 to %5")
                                .arg(QString::fromStdString(field))
                                .arg(real.first, 0, 'g', 10)
                                .arg(real.second, 0, 'g', 10)
                                .arg(least, 0, 'g', 10)
                                .arg(most, 0, 'g', 10)));
    }
}

SKYSEAL_TEST_APPLESS(SimReferenceTest)
#include "reference_test.moc"
