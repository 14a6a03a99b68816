// Alerts, the grid of values and aircraft over a real sealed link, by clicks and keys: simulator and agent are processes, and
// what raises an alert happens to them. A limit is exceeded in flight, the cipher switches, another station changes the mode,
// aircraft come near, the agent stands still, and the battery runs low. Pictures are kept in the folder that SKYSEAL_PICTURES
// names.
#include "sealed_window.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/alert_row.h"
#include "ui/alerts/alert_stack.h"
#include "ui/security/suite_actions.h"
#include "ui/values/value_cell.h"
#include "ui/values/values_editor.h"

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include <csignal>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;

class LiveAlertsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { QVERIFY2(!m_failed, "an earlier step of the flight failed"); }
    void cleanup() { m_failed = m_failed || QTest::currentTestFailed(); }
    void cleanupTestCase() { m_it.reset(); }

    void gridShowsWhatTheVehicleSends();
    void limitIsReportedInFlight();
    void switchIsReported();
    void modeByAnotherStationIsReported();
    void aircraftNearAreReported();
    void silentAgentIsReportedUntilItIsBack();
    void lowBatteryEndsTheFlight();

private:
    /// The lines over the map, from above.
    QStringList alerts() const
    {
        QStringList out;
        for (int i = 0; i < AlertStack::kMostShown; ++i) {
            const auto &alert = row(i)->alert();
            if (row(i)->isVisible() && alert)
                out << alert->text;
        }
        return out;
    }
    AlertRow *row(int number) const { return m_it->find<AlertRow>(qPrintable(QStringLiteral("alertRow%1").arg(number))); }
    bool hasAlert(const char *beginning) const
    {
        const QStringList all = alerts();
        return std::ranges::any_of(all, [&](const QString &text) { return text.startsWith(QString::fromUtf8(beginning)); });
    }
    QByteArray shown() const { return alerts().join(QStringLiteral("; ")).toUtf8(); }
    int rowOf(const char *beginning) const
    {
        const QString wanted = QString::fromUtf8(beginning);
        for (int i = 0; i < AlertStack::kMostShown; ++i) {
            const auto &alert = row(i)->alert();
            if (row(i)->isVisible() && alert && alert->text.startsWith(wanted))
                return i;
        }
        return -1;
    }
    /// After so many more snapshots what has not come will not come.
    void waitForSnapshots(std::uint64_t count) const
    {
        const std::uint64_t now = m_it->view().snapshot->number;
        EVENTUALLY(m_it->view().snapshot->number > now + count);
    }
    ValueCell *cell(const char *id) const { return m_it->find<ValueCell>((QByteArray("value_") + id).constData()); }

    std::unique_ptr<SealedWindow> m_it;
    quint16 m_otherPort = test::freeUdpPort(); ///< on which the vehicle hears another station
    bool m_failed = false;
};

void LiveAlertsTest::initTestCase()
{
    m_it = std::make_unique<SealedWindow>();
    QVERIFY(m_it->open({m_it->groundLink()}));
    m_it->startVehicles({QStringLiteral("--rate"), QStringLiteral("2"), QStringLiteral("--link"),
                         QStringLiteral("udpin:127.0.0.1:%1").arg(m_otherPort)});
    m_it->startAgent();
    EVENTUALLY(m_it->isReadyToFly());
}

/// A field of MAVLink and a limit are chosen by keys; the numbers are those of the vehicle.
void LiveAlertsTest::gridShowsWhatTheVehicleSends()
{
    QTest::keyClick(m_it->window, Qt::Key_E, Qt::ControlModifier);
    EVENTUALLY(m_it->window->findChild<ValuesEditor *>());
    auto *editor = m_it->window->findChild<ValuesEditor *>();
    EVENTUALLY(QApplication::activeWindow() == editor);  // else the mnemonics are those of the window
    QTest::keyClick(editor, Qt::Key_H, Qt::AltModifier); // the upper limit of the altitude, which is the first value
    QTest::keyClicks(editor->focusWidget(), QStringLiteral("5"));
    QTest::keyClick(editor, Qt::Key_F, Qt::AltModifier);
    QTest::keyClicks(editor->focusWidget(), QStringLiteral("satellites gps_raw"));
    QTest::keyClick(editor->focusWidget(), Qt::Key_Return);
    QTest::keyClick(editor, Qt::Key_P, Qt::AltModifier); // Apply
    EVENTUALLY(m_it->window->findChild<ValueCell *>(QStringLiteral("value_GPS_RAW_INT.satellites_visible")));
    QTest::keyClick(editor, Qt::Key_Escape);
    EVENTUALLY(!m_it->window->findChild<ValuesEditor *>());
    m_it->activate();
    EVENTUALLY(m_it->vehicle().satellites > 5
               && cell("GPS_RAW_INT.satellites_visible")->value() == QString::number(m_it->vehicle().satellites));
    EVENTUALLY(std::abs(cell("alt_rel")->value().toDouble()) < 1);
    QVERIFY2(alerts().isEmpty(), shown().constData());
}

void LiveAlertsTest::limitIsReportedInFlight()
{
    m_it->setMode(QStringLiteral("GUIDED"));
    m_it->hands->hold("armButton");
    EVENTUALLY(m_it->strip("stripArmed") == QStringLiteral("ARMED"));
    m_it->hands->hold("takeOffButton");
    EVENTUALLY2(hasAlert("alt high: "), shown().constData());
    QCOMPARE(cell("alt_rel")->note(), QStringLiteral("▲ high"));
    QVERIFY(m_it->flies([this] { return m_it->vehicle().altitudeRelative > 9.5; }));
    EVENTUALLY2(std::abs(cell("alt_rel")->value().toDouble() - m_it->vehicle().altitudeRelative) < 0.3,
                qPrintable(cell("alt_rel")->value()));
    m_it->hands->picture(QStringLiteral("live-limit"));
    QTest::mouseClick(row(rowOf("alt high: "))->button(), Qt::LeftButton);
    waitForSnapshots(30);
    QVERIFY2(alerts().isEmpty(), shown().constData()); // it is still too high, and the modes were changed from here
    QCOMPARE(cell("alt_rel")->note(), QStringLiteral("▲ high"));
}

void LiveAlertsTest::switchIsReported()
{
    QAction *action = m_it->window->suites().action(SuiteId::Aes256Gcm);
    m_it->hands->choose("menuSecurity", action);
    EVENTUALLY2(hasAlert("Switched to AES-256-GCM"), shown().constData());
    EVENTUALLY(m_it->view().session->info.suite == SuiteId::Aes256Gcm);
    QVERIFY(row(rowOf("Switched"))->alert()->severity == AlertSeverity::Information);
    QTest::mouseClick(row(rowOf("Switched to AES-256-GCM"))->button(), Qt::LeftButton);
    EVENTUALLY2(!hasAlert("Switched"), shown().constData());
}

/// It sends to the vehicle itself, as a second telemetry radio does.
void LiveAlertsTest::modeByAnotherStationIsReported()
{
    QStringList arguments = test::words("monitor --secure off --no-record --link");
    arguments << QStringLiteral("udpout:127.0.0.1:%1").arg(m_otherPort) << QStringLiteral("--do")
              << QStringLiteral("mode LOITER");
    test::Program other(QStringLiteral("skyseal-cli"), arguments); // while the window's event loop runs
    EVENTUALLY_EQUAL(m_it->strip("stripMode"), QStringLiteral("LOITER"));
    EVENTUALLY2(hasAlert("Mode GUIDED → LOITER, not by this station"), shown().constData());
    m_it->hands->picture(QStringLiteral("live-mode"));
    QCOMPARE(other.waitForExit(), 0);
    m_it->setMode(QStringLiteral("GUIDED"));
    waitForSnapshots(30);
    QVERIFY2(!hasAlert("Mode LOITER"), shown().constData());
}

void LiveAlertsTest::aircraftNearAreReported()
{
    m_it->fetchParameters();
    m_it->setParameter(QStringLiteral("SIM_ADSB_ALT"), QStringLiteral("60"));
    m_it->setParameter(QStringLiteral("SIM_ADSB_RADIUS"), QStringLiteral("300"));
    m_it->setParameter(QStringLiteral("SR0_ADSB"), QStringLiteral("4"));
    m_it->setParameter(QStringLiteral("SIM_ADSB_COUNT"), QStringLiteral("2"));
    m_it->show("workspace_fly");
    EVENTUALLY_EQUAL(m_it->vehicle().traffic.size(), std::size_t(2));
    EVENTUALLY2(hasAlert("Aircraft near: SIM"), shown().constData());
    const auto *map = m_it->find<MapView>("map");
    EVENTUALLY_EQUAL(map->traffic().marks().size(), std::size_t(2));
    const auto first = map->traffic().marks()[0].at;
    EVENTUALLY(map->traffic().marks()[0].at != first); // it moves
    m_it->hands->picture(QStringLiteral("live-aircraft"));
    m_it->show("workspace_vehicle");
    m_it->setParameter(QStringLiteral("SIM_ADSB_ALT"), QStringLiteral("2000"));
    m_it->show("workspace_fly");
    EVENTUALLY2(!hasAlert("Aircraft near"), shown().constData());
    QCOMPARE(m_it->vehicle().traffic.size(), std::size_t(2));
}

/// The agent stands still for a while, as if the radio were in a shadow. A switch that was requested then fails; the vehicle
/// returns by itself; and all of that is reported.
void LiveAlertsTest::silentAgentIsReportedUntilItIsBack()
{
    ::kill(static_cast<pid_t>(m_it->air->pid()), SIGSTOP);
    m_it->hands->choose("menuSecurity", m_it->window->suites().action(SuiteId::Aes256Ctr));
    EVENTUALLY2(hasAlert("Link lost "), shown().constData());
    QCOMPARE(row(0)->alert()->severity, AlertSeverity::Severe); // above all others
    EVENTUALLY2(hasAlert("Not switched to AES-256-CTR"), shown().constData());
    QVERIFY2(hasAlert("Link lost "), shown().constData());
    m_it->hands->picture(QStringLiteral("live-lost"));
    ::kill(static_cast<pid_t>(m_it->air->pid()), SIGCONT);
    EVENTUALLY2(!hasAlert("Link lost "), shown().constData());
    EVENTUALLY(m_it->isSealed());
    EVENTUALLY2(m_it->strip("stripMode") == QStringLiteral("RTL"), qPrintable(m_it->strip("stripMode")));
    EVENTUALLY2(hasAlert("Mode GUIDED → RTL, not by this station"), shown().constData());
    QCOMPARE(m_it->view().session->info.suite, SuiteId::Aes256Gcm);
    QCOMPARE(m_it->view().session->stats.rx.forged, std::uint64_t(0));
    m_it->setMode(QStringLiteral("GUIDED"));
}

void LiveAlertsTest::lowBatteryEndsTheFlight()
{
    m_it->show("workspace_vehicle");
    m_it->setParameter(QStringLiteral("BATT_FS_LOW_ACT"), QStringLiteral("2")); // RTL
    m_it->setParameter(QStringLiteral("BATT_LOW_TIMER"), QStringLiteral("1"));
    m_it->setParameter(QStringLiteral("SIM_BATT_VOLTAGE"), QStringLiteral("11.15"));
    m_it->show("workspace_fly");
    EVENTUALLY2(hasAlert("Battery low: "), shown().constData());
    QVERIFY2(!hasAlert("Failsafe"), shown().constData());
    m_it->show("workspace_vehicle");
    m_it->setParameter(QStringLiteral("SIM_BATT_VOLTAGE"), QStringLiteral("10.7"));
    m_it->show("workspace_fly");
    EVENTUALLY2(hasAlert("Battery very low: "), shown().constData());
    EVENTUALLY2(hasAlert("Failsafe: Battery Failsafe - RTL"), shown().constData());
    EVENTUALLY2(hasAlert("Mode GUIDED → RTL, not by this station"), shown().constData());
    QCOMPARE(m_it->strip("stripMode"), QStringLiteral("RTL"));
    m_it->hands->picture(QStringLiteral("live-battery"));
    QVERIFY(m_it->flies([this] { return m_it->strip("stripArmed") == QStringLiteral("DISARMED"); }));
    EVENTUALLY2(!hasAlert("Failsafe"), shown().constData());
    QVERIFY2(hasAlert("Battery very low: "), shown().constData());
    m_it->show("workspace_vehicle");
    m_it->setParameter(QStringLiteral("SIM_BATT_VOLTAGE"), QStringLiteral("12.6")); // another battery
    m_it->show("workspace_fly");
    EVENTUALLY2(!hasAlert("Battery"), shown().constData());
    QCOMPARE(m_it->view().session->stats.rx.forged, std::uint64_t(0));
}

SKYSEAL_TEST_WIDGETS(LiveAlertsTest)
#include "live_alerts_test.moc"
