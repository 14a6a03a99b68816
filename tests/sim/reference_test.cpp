// The simulated copter holds the same conversation as a real ArduCopter 3.6.7 did, and gives the same facts: messages, rates,
// answers and their order, ranges of fields. What differs on purpose stands in tables here, with the reason; an entry that is
// no longer a difference fails as well.
#include "tests/sim/reference_comparison.h"
#include "tests/sim/test_station.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtTest/QTest>

#include <algorithm>
#include <functional>
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

} // namespace

class SimReferenceTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void sendsTheSameMessagesAtTheSameRates();
    void givesTheSameAnswersInTheSameOrder();
    void fieldsAreInTheSameRanges();
    void eachChangeOfTheFactsIsFound();

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
        const bool same = isSameRate(simulated, real);
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
                 (step + ": " + joined(real) + "; simulated: " + joined(simulated)).c_str());
    }
}

void SimReferenceTest::fieldsAreInTheSameRanges()
{
    for (const auto &[field, real] : m_real.ranges) {
        QVERIFY2(m_simulated.ranges.contains(field), field.c_str());
        const auto &[least, most] = m_simulated.ranges.at(field);
        const bool within = isWithin({least, most}, real, field);
        QVERIFY2(within != kOtherRanges.contains(field),
                 qPrintable(QStringLiteral("%1: %2 to %3, simulated %4 to %5")
                                .arg(QString::fromStdString(field))
                                .arg(real.first, 0, 'g', 10)
                                .arg(real.second, 0, 'g', 10)
                                .arg(least, 0, 'g', 10)
                                .arg(most, 0, 'g', 10)));
    }
}

/// What the comparison with a live ArduCopter says, in reference_measurement_test.
void SimReferenceTest::eachChangeOfTheFactsIsFound()
{
    const auto changesAfter = [this](const std::function<void(ReferenceFacts &)> &change) {
        ReferenceFacts measured = m_real;
        change(measured);
        return changesOf(measured, m_real);
    };
    using Changes = std::vector<std::string>;
    QCOMPARE(changesAfter([](ReferenceFacts &) {}), Changes());
    // It tells of the parameters that it has just set, if the station comes early, and rarely sends TIMESYNC.
    QCOMPARE(changesAfter([](ReferenceFacts &facts) {
                 facts.silentRates["PARAM_VALUE"] = 3;
                 facts.rates.erase("TIMESYNC");
                 facts.rates["PING"] = 0.1;
             }),
             Changes());
    const std::pair<const char *, std::function<void(ReferenceFacts &)>> changes[] = {
        {"silent HEARTBEAT", [](ReferenceFacts &facts) { facts.silentRates["HEARTBEAT"] = 2; }},
        {"silent ATTITUDE", [](ReferenceFacts &facts) { facts.silentRates["ATTITUDE"] = 4; }},
        {"rate VFR_HUD", [](ReferenceFacts &facts) { facts.rates["VFR_HUD"] = 8; }},
        {"rate VFR_HUD", [](ReferenceFacts &facts) { facts.rates.erase("VFR_HUD"); }},
        {"rate WIND", [](ReferenceFacts &facts) { facts.rates["WIND"] = 3; }},
        {"answer turn", [](ReferenceFacts &facts) { facts.answers["turn"].clear(); }},
        {"answer turn", [](ReferenceFacts &facts) { facts.answers.erase("turn"); }},
        {"answer new step", [](ReferenceFacts &facts) { facts.answers["new step"]; }},
        {"answer home", [](ReferenceFacts &facts) { std::ranges::reverse(facts.answers["home"]); }},
        {"range VFR_HUD.throttle", [](ReferenceFacts &facts) { facts.ranges["VFR_HUD.throttle"].second = 1; }},
        {"range VFR_HUD.alt", [](ReferenceFacts &facts) { facts.ranges["VFR_HUD.alt"].first -= 1; }},
        {"range HEARTBEAT.type", [](ReferenceFacts &facts) { facts.ranges.erase("HEARTBEAT.type"); }},
        {"range NEW.field", [](ReferenceFacts &facts) { facts.ranges["NEW.field"]; }},
    };
    for (const auto &[expected, change] : changes) {
        const Changes found = changesAfter(change);
        QVERIFY2(found.size() == 1 && found[0].starts_with(expected), expected);
    }
}

SKYSEAL_TEST_APPLESS(SimReferenceTest)
#include "reference_test.moc"
