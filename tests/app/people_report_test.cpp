// The lines of a monitor run for people: the same sentences as in the window, with the command that helps.
#include "app/cli/people_report.h"
#include "core/engine/text/event_text.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::app;

class PeopleReportTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eventsReadAsInTheWindow();
    void routineEventsAreLeftOut();
    void remediesAreCommands();
};

void PeopleReportTest::eventsReadAsInTheWindow()
{
    engine::PeerNames names;
    for (const engine::Event &event : std::initializer_list<engine::Event>{
             channel::SessionUp{channel::SessionId{7}, {}, "air-1", crypto::SuiteId::Rc4, {}}, engine::VehicleLost{2},
             channel::SessionDown{channel::SessionId{7}, channel::DownReason::Revoked, {}}}) {
        names.note(event);
        QCOMPARE(QString::fromStdString(eventLine(event, names)), engine::eventText(event, names).line());
    }
}

void PeopleReportTest::routineEventsAreLeftOut()
{
    QCOMPARE(eventLine(channel::SwitchPending{}, {}), std::string());
    QCOMPARE(eventLine(vehicle::CommandResult{}, {}), std::string());
}

void PeopleReportTest::remediesAreCommands()
{
    const engine::Event unknown = channel::HandshakeRefused{{}, channel::RefusalReason::UnknownPeer, {}};
    const std::string line = eventLine(unknown, {});
    QVERIFY(line.starts_with(engine::eventText(unknown, {}).sentence.toStdString()));
    QVERIFY(line.find("skyseal-air --pair") != line.npos);
    const engine::Event pending = engine::PlaintextRefused{1, "10.0.0.9:14550", 3, "air-1"};
    QVERIFY(eventLine(pending, {}).find("waiting for approval") != std::string::npos);
    QVERIFY(eventLine(pending, {}).find("--secure off") != std::string::npos);
}

SKYSEAL_TEST(PeopleReportTest)
#include "people_report_test.moc"
