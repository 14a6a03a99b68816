// The sentences for events: each alternative of the variants has one, and the station and the agent share those of the channel.
#include "core/base/printable.h"
#include "core/engine/text/agent_event_text.h"
#include "core/engine/text/event_text.h"
#include "core/engine/text/pairing_text.h"
#include "core/engine/text/state_text.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <set>
#include <utility>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

template<typename... T> std::integral_constant<std::size_t, sizeof...(T)> countOf(const std::variant<T...> &);

/// One default value of each alternative.
template<typename Variant> std::vector<Variant> samples()
{
    std::vector<Variant> out;
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        (out.push_back(Variant(std::in_place_index<I>)), ...);
    }
    (std::make_index_sequence<decltype(countOf(std::declval<Variant>()))::value>());
    return out;
}

void checkForm(const EventText &text)
{
    QVERIFY(!text.sentence.isEmpty());
    QVERIFY2(text.sentence.front().isUpper(), qPrintable(text.sentence));
    QVERIFY2(!text.sentence.endsWith(QLatin1Char('.')), qPrintable(text.sentence));
    QVERIFY2(!text.sentence.contains(QLatin1Char('%')), qPrintable(text.sentence));
    QVERIFY(text.severity <= 7);
}

const channel::SessionId kTextSession{7};

} // namespace

class EventTextTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachStationEventHasASentence();
    void eachAgentEventHasASentence();
    void channelEventsReadTheSameAtBothEnds();
    void hostileTextsSteerNoLabel_data();
    void hostileTextsSteerNoLabel();
    void unknownAgeOfCommandsIsNamed();
    void eachReasonHasItsOwnText();
    void eachMissionTransferHasItsOwnTexts();
    void failedReadOfParametersHasNoName();
    void vehicleThatWaitsForApprovalIsNotCalledRefused();
    void systemOfAnotherPeerNamesItsOwner();
    void numbersAgreeWithTheirNouns();
    void vehicleIsNamedInALine();
    void switchTimesAreRounded();
    void peerNameIsKeptToTheEndOfItsSession();
};

void EventTextTest::eachStationEventHasASentence()
{
    for (Event event : samples<Event>()) {
        if (auto *text = std::get_if<vehicle::TextReceived>(&event))
            text->text.text = "PreArm: Compass"; // the vehicle's own words
        checkForm(eventText(event, {}));
    }
}

void EventTextTest::eachAgentEventHasASentence()
{
    for (const AgentEvent &event : samples<AgentEvent>()) {
        if (!std::holds_alternative<channel::PairingEvent>(event))
            checkForm(agentEventText(event, {}));
    }
    for (const channel::Event &event : samples<channel::Event>())
        checkForm(agentEventText(event, {}));
    for (const channel::PairingEvent &event : samples<channel::PairingEvent>())
        QVERIFY(agentEventText(event, {}).isRoutine);
}

void EventTextTest::channelEventsReadTheSameAtBothEnds()
{
    PeerNames names;
    names.note(channel::Event(channel::SessionUp{kTextSession, {}, "air-1", crypto::SuiteId::Aes256Gcm, {}}));
    const channel::ForgeryAlarm alarm{kTextSession, 3, 4};
    const EventText text = eventText(alarm, names);
    QCOMPARE(text.sentence,
             QStringLiteral("Under attack: refused 3 forged and 4 replayed records that claim to come from air-1"));
    QCOMPARE(int(text.severity), 2);
    QCOMPARE(agentEventText(channel::Event(alarm), names).sentence, text.sentence);
}

void EventTextTest::hostileTextsSteerNoLabel_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("escape sequence") << QByteArray("\x1b]0;owned\x07\x1b[2J");
    QTest::newRow("new lines") << QByteArray("one\r\ntwo");
    QTest::newRow("reversed direction") << QByteArray("\xe2\x80\xaeoff");
    QTest::newRow("no UTF-8") << QByteArray("\xc3\x28\xff");
}

/// Of a vehicle's texts, names of its parameters, and names of peers: as lines of the log, and on labels.
void EventTextTest::hostileTextsSteerNoLabel()
{
    QFETCH(QByteArray, text);
    const std::string hostile = text.toStdString();
    QVERIFY(!isPrintable(hostile));
    PeerNames names;
    names.note(channel::Event(channel::SessionUp{kTextSession, {}, hostile, crypto::SuiteId::Aes256Gcm, {}}));
    vehicle::TextReceived received;
    received.text.text = hostile;
    vehicle::ParameterResult parameter;
    parameter.parameter.name = hostile;
    parameter.reason = hostile;
    vehicle::CommandResult command;
    command.reason = hostile;
    for (const Event &event :
         {Event(received), Event(parameter), Event(command), Event(channel::ForgeryAlarm{kTextSession, 1, 1}),
          Event(channel::SessionUp{kTextSession, {}, hostile, crypto::SuiteId::Aes256Gcm, {}})}) {
        const EventText shown = eventText(event, names);
        QVERIFY2(isPrintable(shown.sentence.toStdString()), qPrintable(shown.sentence));
        QVERIFY2(isPrintable(shown.line().toStdString()), qPrintable(shown.line()));
    }
}

void EventTextTest::unknownAgeOfCommandsIsNamed()
{
    PeerNames names;
    names.note(channel::Event(channel::SessionUp{kTextSession, {}, "air-1", crypto::SuiteId::Aes256Gcm, {}}));
    channel::CommandsLate late{kTextSession, 4, {}};
    late.report.limitMilliseconds = 5000;
    late.report.ageMicroseconds = channel::FreshnessReport::kUnknownAge;
    QCOMPARE(eventText(late, names).sentence,
             QStringLiteral("air-1 cannot determine the delay of commands and ignores any that may be older than 5.0 s: it "
                            "ignored 4 messages"));
    late.report.limitMilliseconds = 0; // no limit: others overtook them
    QVERIFY(eventText(late, names).sentence.contains(QStringLiteral("overtaken")));
}

void EventTextTest::eachReasonHasItsOwnText()
{
    const auto distinct = [](auto last, auto textOf) {
        std::set<QString> texts;
        for (int i = 0; i <= int(last); ++i)
            texts.insert(textOf(static_cast<decltype(last)>(i)));
        return int(texts.size()) == int(last) + 1 && !texts.count(QString());
    };
    QVERIFY(distinct(channel::DownReason::Closed, downReasonText));
    QVERIFY(distinct(channel::SwitchFailure::SessionEnded, switchFailureText));
    QVERIFY(distinct(channel::RefusalReason::Flood, refusalText));
    QVERIFY(distinct(LinkPhase::Failed, linkPhaseText));
    QVERIFY(distinct(channel::PairingEnd::Guessed, [](channel::PairingEnd end) {
        return end == channel::PairingEnd::Paired ? QStringLiteral("paired") : pairingEndText(end);
    }));
}

void EventTextTest::eachMissionTransferHasItsOwnTexts()
{
    using vehicle::MissionTransfer;
    const auto sentence = [](MissionTransfer transfer, bool ok) {
        return eventText(vehicle::MissionResult{.systemId = 1, .transfer = transfer, .ok = ok, .reason = "denied"}, {})
            .sentence;
    };
    QCOMPARE(sentence(MissionTransfer::Upload, true), QStringLiteral("Mission sent"));
    QCOMPARE(sentence(MissionTransfer::Download, true), QStringLiteral("Mission read"));
    QCOMPARE(sentence(MissionTransfer::Clear, true), QStringLiteral("Mission cleared"));
    QCOMPARE(sentence(MissionTransfer::Upload, false), QStringLiteral("Mission not sent: denied"));
    QCOMPARE(sentence(MissionTransfer::Download, false), QStringLiteral("Mission not read: denied"));
    QCOMPARE(sentence(MissionTransfer::Clear, false), QStringLiteral("Mission not cleared: denied"));
    QCOMPARE(eventText(vehicle::MissionResult{.type = vehicle::MissionType::Fence, .ok = true}, {}).sentence,
             QStringLiteral("Fence sent"));
    QCOMPARE(eventText(vehicle::MissionResult{.type = vehicle::MissionType::Rally, .reason = "denied"}, {}).sentence,
             QStringLiteral("Rally points not sent: denied"));
    const auto moved = eventText(vehicle::MissionResult{.ok = true, .remark = "home was inserted"}, {});
    QCOMPARE(moved.sentence, QStringLiteral("Mission sent: home was inserted"));
    QVERIFY(moved.severity < eventText(vehicle::MissionResult{.ok = true}, {}).severity);
}

void EventTextTest::failedReadOfParametersHasNoName()
{
    QCOMPARE(
        eventText(vehicle::ParameterResult{.systemId = 1, .reason = "no answer", .action = vehicle::ParameterAction::ReadList},
                  {})
            .sentence,
        QStringLiteral("Parameters not read: no answer"));
    QCOMPARE(eventText(vehicle::ParameterResult{.systemId = 1, .parameter = {.name = "SYSID_MYGCS"}, .reason = "no answer"}, {})
                 .sentence,
             QStringLiteral("Parameter SYSID_MYGCS not written: no answer"));
}

void EventTextTest::vehicleThatWaitsForApprovalIsNotCalledRefused()
{
    const EventText pending = eventText(PlaintextRefused{1, "10.0.0.9:14550", 3, "air-1, air-2"}, {});
    QVERIFY2(pending.sentence.contains(QStringLiteral("waiting for approval")), qPrintable(pending.sentence));
    QVERIFY(pending.sentence.contains(QStringLiteral("10.0.0.9:14550")));
    QVERIFY(pending.sentence.contains(QStringLiteral("air-1 or air-2")));
    QVERIFY(!pending.sentence.contains(QStringLiteral("efused")));
    QCOMPARE(pending.remedy, EventText::Remedy::AllowPlaintext);
    const EventText refused = eventText(PlaintextRefused{1, "10.0.0.9:14550", 3, {}}, {});
    QVERIFY(refused.sentence.startsWith(QStringLiteral("Refused 3 plain frames from 10.0.0.9:14550")));
    QCOMPARE(refused.remedy, EventText::Remedy::None);
}

void EventTextTest::systemOfAnotherPeerNamesItsOwner()
{
    const auto sentence = [](const char *owner) { return eventText(SystemRefused{1, "air-2", owner, 3}, {}).sentence; };
    QCOMPARE(
        sentence(""),
        QStringLiteral(
            "Refused 3 frames from air-2, which may not send as this vehicle. If air-2 is its agent, bind the system ID to "
            "air-2 in the list of peers"));
    QCOMPARE(
        sentence("air-1"),
        QStringLiteral(
            "Refused 3 frames from air-2, which sends as this vehicle although its system ID belongs to air-1. If air-2 is "
            "a new agent of the same vehicle, remove air-1 from the list of peers or bind the system ID to air-2"));
}

void EventTextTest::numbersAgreeWithTheirNouns()
{
    const auto refused = [](std::uint64_t frames) {
        return agentEventText(FramesRefused{FramesRefused::Reason::Observer, "vm", 76, "COMMAND_LONG", 400, frames}, {})
            .sentence;
    };
    QCOMPARE(refused(1), QStringLiteral("Refused one frame from vm, which is an observer: COMMAND_LONG 400"));
    QCOMPARE(refused(4), QStringLiteral("Refused 4 frames from vm, which is an observer: most recently COMMAND_LONG 400"));
    QCOMPARE(eventText(EventsDropped{1}, {}).sentence,
             QStringLiteral("Dropped one event because this program did not keep up"));
    QVERIFY(eventText(PlaintextRefused{1, "10.0.0.9:14550", 1, {}}, {})
                .sentence.startsWith(
                    QStringLiteral("Refused one plain frame from 10.0.0.9:14550 with the system ID of this sealed vehicle")));
    QVERIFY(
        eventText(SystemRefused{1, "air-2", "", 1}, {}).sentence.startsWith(QStringLiteral("Refused one frame from air-2,")));
}

void EventTextTest::vehicleIsNamedInALine()
{
    QCOMPARE(eventText(VehicleLost{3}, {}).line(), QStringLiteral("Vehicle 3: Link to the vehicle lost"));
    QCOMPARE(eventText(OtherSystemsHeard{"air-1", {51, 255}, {}, 9}, {}).sentence,
             QStringLiteral("Other systems behind air-1: 51, 255"));
    QCOMPARE(eventText(OtherSystemsHeard{"air-1", {7, 51}, {7}, 9}, {}).sentence,
             QStringLiteral(
                 "Other systems behind air-1: 7, 51. To show vehicle 7, bind its system ID to air-1 in the list of peers"));
    QCOMPARE(eventText(OwnIdClaimed{255, 1, "10.0.0.9:14550"}, {}).sentence,
             QStringLiteral("A vehicle at 10.0.0.9:14550 is not shown: it has the system ID 255, which is this station's own. "
                            "Change one of the two"));
    QCOMPARE(eventText(VehicleFound{.systemId = 3, .type = 2, .autopilot = 3, .recorded = true}, {}).line(),
             QStringLiteral("Vehicle 3: Found: quadrotor"));
    QCOMPARE(eventText(VehicleFound{3, 2, 3, false}, {}).line(), QStringLiteral("Vehicle 3: Found: quadrotor, not sealed"));
    LinkSnapshot link;
    link.url = "udpin:0.0.0.0:0";
    link.phase = LinkPhase::Listening;
    link.localAddress = "0.0.0.0:14550";
    QCOMPARE(linkText(link).line(), QStringLiteral("Link udpin:0.0.0.0:0: listening on 0.0.0.0:14550"));
}

void EventTextTest::switchTimesAreRounded()
{
    using std::chrono::microseconds;
    QCOMPARE(switchTimeText(microseconds(430)), QStringLiteral("0.4 ms"));
    QCOMPARE(switchTimeText(microseconds(9'960)), QStringLiteral("10 ms"));
    QCOMPARE(switchTimeText(microseconds(42'300)), QStringLiteral("42 ms"));
}

void EventTextTest::peerNameIsKeptToTheEndOfItsSession()
{
    PeerNames names;
    names.note(Event(channel::SessionUp{kTextSession, {}, "air-1", crypto::SuiteId::Aes256Gcm, {}}));
    names.note(Event(VehicleLost{1}));
    QCOMPARE(names.of(kTextSession), std::string("air-1"));
    const Event down = channel::SessionDown{kTextSession, channel::DownReason::TimedOut, {}};
    names.note(down);
    QCOMPARE(eventText(down, names).sentence, QStringLiteral("Sealed link to air-1 ended: silent for too long"));
    names.note(Event(VehicleBack{1}));
    QCOMPARE(names.of(kTextSession), std::string());
}

SKYSEAL_TEST(EventTextTest)
#include "event_text_test.moc"
