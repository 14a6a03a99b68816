// What the list of alerts makes of views and events: counting, dismissing, coming back, forgetting. Time is a number.
#include "core/link/address_text.h"
#include "scripted_snapshots.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/alert_list.h"

#include <QtTest/QTest>

#include <functional>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

using ChangeSnapshot = std::function<void(engine::Snapshot &)>;

channel::HandshakeRefused unknownAgentAt(std::uint8_t lastByte)
{
    channel::HandshakeRefused out;
    out.path.remote = link::ipv4(0xc0000200u | lastByte, 14560);
    out.reason = channel::RefusalReason::UnknownPeer;
    return out;
}

channel::SwitchDone switchDone(channel::SwitchFailure failure)
{
    channel::SwitchDone out;
    out.session = channel::SessionId{7};
    out.from = crypto::SuiteId::ChaCha20Poly1305;
    out.to = crypto::SuiteId::Aes256Gcm;
    out.failure = failure;
    return out;
}

} // namespace

class AlertsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_list = AlertList();
        m_number = 0;
    }

    void quietFlightHasNone()
    {
        for (double t = 0; t < 60; t += 0.5)
            show(t);
        QVERIFY(m_list.alerts().empty());
        QVERIFY(m_list.takeRaised().empty());
    }

    void lostLinkLastsUntilItIsBack()
    {
        show(1, age(4.2));
        QCOMPARE(texts(), QStringList{QStringLiteral("Link lost 4 s")});
        QCOMPARE(m_list.alerts().front().severity, AlertSeverity::Severe);
        QVERIFY(m_list.alerts().front().ongoing);
        show(70, age(73));
        QCOMPARE(texts(), QStringList{QStringLiteral("Link lost 01:13")});
        QCOMPARE(m_list.alerts().front().since, 1.0);
        QCOMPARE(m_list.takeRaised().size(), std::size_t(1)); // raised once
        show(71);
        QVERIFY(m_list.alerts().empty());
    }

    void forgedFramesCountUpInOneAlert()
    {
        show(1, forged(7, 7));
        QCOMPARE(texts(), QStringList{QStringLiteral("7 forged frames")});
        show(2, forged(87, 87));
        QCOMPARE(texts(), QStringList{QStringLiteral("87 forged frames")});
        show(40, forged(90, 10)); // the older ones left the last minute
        QCOMPARE(texts(), QStringList{QStringLiteral("90 forged frames")});
        show(41, forged(4, 4)); // another session
        QCOMPARE(texts(), QStringList{QStringLiteral("4 forged frames")});
        show(99, forged(4, 0));
        QVERIFY(m_list.alerts().empty());
        show(100, forged(5, 1)); // the next attack on the same session
        QCOMPARE(texts(), QStringList{QStringLiteral("5 forged frames")});
    }

    void framesOutsideTheSessionAreForgedToo()
    {
        show(1);
        m_list.handleEvent(engine::PlaintextRefused{1, "192.0.2.66:40000", 5, {}}, 2);
        show(2);
        m_list.handleEvent(engine::SystemRefused{1, "air-2", "air-1", 3}, 3);
        show(3, forged(2, 2));
        QCOMPARE(texts(), QStringList{QStringLiteral("10 forged frames")});
        m_list.handleEvent(engine::PlaintextRefused{1, "192.0.2.66:40000", 1, "air-2"}, 4); // only waits for approval
        show(4, forged(2, 2));
        QCOMPARE(texts(), QStringList{QStringLiteral("10 forged frames")});
        show(64, forged(2, 0));
        QVERIFY(m_list.alerts().empty());
    }

    void aNetworkMayRepeatRecords()
    {
        const auto replayed = [](std::uint64_t frames, std::uint64_t good) {
            return [=](engine::Snapshot &snapshot) {
                auto &session = snapshot.sessions.front();
                session.stats.rx.replayed = session.replayedLastMinute = frames;
                session.goodLastMinute = good;
            };
        };
        show(1, replayed(90, 100));
        QVERIFY(m_list.alerts().empty());
        show(2, replayed(120, 100));
        QCOMPARE(texts(), QStringList{QStringLiteral("120 replayed frames")});
    }

    void dismissedStateComesBackOnlyAfterItEnded()
    {
        show(1, age(4));
        m_list.dismiss({AlertKind::LinkLost, 1});
        for (double t = 2; t < 4000; t += 100)
            show(t, age(t + 4));
        QVERIFY(m_list.alerts().empty());
        show(4000);
        show(4001, age(4));
        QCOMPARE(texts(), QStringList{QStringLiteral("Link lost 4 s")});
    }

    void dismissedStateComesBackWhenItIsWorse()
    {
        show(1, battery(20));
        QCOMPARE(texts(), QStringList{QStringLiteral("Battery low: 20 %")});
        QCOMPARE(m_list.alerts().front().severity, AlertSeverity::Warning);
        m_list.dismiss({AlertKind::LowBattery, 1});
        m_list.takeRaised();
        show(2, battery(11));
        QVERIFY(m_list.alerts().empty());
        show(3, battery(10));
        QCOMPARE(texts(), QStringList{QStringLiteral("Battery very low: 10 %")});
        QCOMPARE(m_list.alerts().front().severity, AlertSeverity::Severe);
        QCOMPARE(m_list.takeRaised().size(), std::size_t(1));

        show(4, forged(3, 3));
        m_list.dismiss({AlertKind::ForgedFrames, 1});
        show(5, forged(29, 29));
        QVERIFY(!texts().contains(QStringLiteral("29 forged frames")));
        show(6, forged(30, 30));
        QVERIFY(texts().contains(QStringLiteral("30 forged frames")));
    }

    void dismissedFailsafeHidesNoEmergency()
    {
        const auto status = [](std::uint8_t value) {
            return [value](engine::Snapshot &snapshot) { snapshot.vehicles.front().state.systemStatus = value; };
        };
        show(1, status(mavlink::MAV_STATE_CRITICAL));
        m_list.dismiss({AlertKind::Failsafe, 1});
        m_list.takeRaised();
        show(2, status(mavlink::MAV_STATE_CRITICAL));
        QVERIFY(m_list.alerts().empty());
        show(3, status(mavlink::MAV_STATE_EMERGENCY));
        QCOMPARE(texts(), QStringList{QStringLiteral("Emergency")});
        QCOMPARE(m_list.takeRaised().size(), std::size_t(1));
        show(4, status(mavlink::MAV_STATE_FLIGHT_TERMINATION)); // announced again, although it is shown
        QCOMPARE(m_list.takeRaised().size(), std::size_t(1));
    }

    void selectedVehicleComesFirst()
    {
        const auto invented = [](double ageOfFirst) {
            return [ageOfFirst](engine::Snapshot &snapshot) {
                for (int id = 2; id < 250; ++id) {
                    snapshot.vehicles.push_back(snapshot.vehicles.front());
                    snapshot.vehicles.back().state.systemId = static_cast<std::uint8_t>(id);
                    snapshot.vehicles.back().state.systemStatus = mavlink::MAV_STATE_CRITICAL;
                }
                snapshot.vehicles.front().state.messageAge = ageOfFirst;
            };
        };
        show(1, invented(0));
        show(9, invented(4));
        QCOMPARE(m_list.alerts().front().id, (AlertId{AlertKind::LinkLost, 1}));
    }

    void refusedCommandHidesNoChange()
    {
        show(0);
        m_list.handleEvent(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Accepted}, 1); // arming
        m_list.noteCommand(1, 2);
        m_list.handleEvent(vehicle::CommandResult{vehicle::RequestId{2}, 1, vehicle::CommandOutcome::Refused}, 9);
        show(10, mode("RTL"));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
    }

    void swingingBatteryIsOneAlert()
    {
        show(1, battery(20));
        m_list.dismiss({AlertKind::LowBattery, 1});
        show(2, battery(21));
        show(3, battery(20));
        QVERIFY(m_list.alerts().empty());
        show(4, battery(40)); // another battery
        show(5, battery(20));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        show(6, battery(vehicle::kUnknown));
        QVERIFY(m_list.alerts().empty());
    }

    void failsafeNamesItsReason()
    {
        const auto critical = [](engine::Snapshot &snapshot) { snapshot.vehicles.front().state.systemStatus = 5; };
        show(1);
        m_list.handleEvent(vehicle::TextReceived{1, {1, 4, "Radio Failsafe - RTL", {}}}, 2);
        show(3, critical);
        QCOMPARE(texts(), QStringList{QStringLiteral("Failsafe: Radio Failsafe - RTL")});
        QCOMPARE(m_list.alerts().front().severity, AlertSeverity::Severe);
        show(60, critical);
        QCOMPARE(texts(), QStringList{QStringLiteral("Failsafe: Radio Failsafe - RTL")});
        show(61);
        QVERIFY(m_list.alerts().empty());
        show(62, critical); // another one, of which nothing was said
        QCOMPARE(texts(), QStringList{QStringLiteral("Failsafe")});
    }

    void modeChangedByOthersGoesAfterTenSeconds()
    {
        show(0);
        show(1, mode("RTL"));
        QCOMPARE(texts(), QStringList{QStringLiteral("Mode GUIDED → RTL, not by this station")});
        QVERIFY(m_list.hasMomentary());
        show(5, mode("LAND"));
        QCOMPARE(texts(), QStringList{QStringLiteral("Mode RTL → LAND, not by this station")}); // this change once
        show(14.9, mode("LAND"));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        m_list.expire(15);
        QVERIFY(m_list.alerts().empty());
        QVERIFY(!m_list.hasMomentary());
    }

    void ownCommandsAreNoAlert()
    {
        show(0);
        m_list.noteCommand(1, 1);
        show(6, mode("RTL"));
        QVERIFY(m_list.alerts().empty());
        m_list.noteCommand(1, 10); // to a slow vehicle
        m_list.handleEvent(vehicle::CommandResult{vehicle::RequestId{1}, 1, vehicle::CommandOutcome::Accepted}, 20);
        show(22, mode("LAND"));
        QVERIFY(m_list.alerts().empty());
        m_list.noteCommand(2, 30); // to another vehicle
        show(31, mode("LOITER"));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
    }

    void dismissedChangeDoesNotHideTheNext()
    {
        show(0);
        show(1, mode("RTL"));
        m_list.dismiss({AlertKind::ModeChanged, 1});
        QVERIFY(m_list.alerts().empty());
        show(2, mode("GUIDED"));
        QCOMPARE(texts(), QStringList{QStringLiteral("Mode RTL → GUIDED, not by this station")});
    }

    void unknownAgentIsReportedOnce()
    {
        m_list.handleEvent(unknownAgentAt(7), 1);
        QCOMPARE(texts(), QStringList{QStringLiteral("Unknown agent at 192.0.2.7:14560")});
        m_list.dismiss({AlertKind::UnknownAgent, 0});
        m_list.handleEvent(unknownAgentAt(7), 61); // it keeps announcing itself
        QVERIFY(m_list.alerts().empty());
        m_list.handleEvent(unknownAgentAt(8), 62); // another one
        QCOMPARE(texts(), QStringList{QStringLiteral("Unknown agent at 192.0.2.8:14560")});
        m_list.dismiss({AlertKind::UnknownAgent, 0});
        m_list.handleEvent(unknownAgentAt(8), 200); // after a pause
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
    }

    /// The station reports it once a minute.
    void unknownAgentStaysWhileItIsHeard()
    {
        const auto heard = [](engine::Snapshot &snapshot) { snapshot.unknownAgents.push_back({"192.0.2.7:14560"}); };
        m_list.handleEvent(unknownAgentAt(7), 1);
        for (double t = 2; t < 100; ++t)
            show(t, heard); // longer than the event alone would last
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        m_list.handleEvent(unknownAgentAt(7), 100);
        QCOMPARE(texts(), QStringList{QStringLiteral("Unknown agent at 192.0.2.7:14560")}); // as one
        show(159);
        QCOMPARE(m_list.alerts().size(), std::size_t(1)); // it was heard less than a minute ago
        show(161);
        QVERIFY(m_list.alerts().empty());
        m_list.handleEvent(unknownAgentAt(7), 170);
        m_list.handleEvent(channel::SessionUp{channel::SessionId{7}, {}, "air-1", crypto::SuiteId::Aes256Gcm, {}}, 171);
        QVERIFY(m_list.alerts().empty());
    }

    void switchResultsGo()
    {
        show(0);
        m_list.handleEvent(switchDone(channel::SwitchFailure::None), 1);
        QCOMPARE(texts(), QStringList{QStringLiteral("Switched to AES-256-GCM")});
        QCOMPARE(m_list.alerts().front().severity, AlertSeverity::Information);
        QCOMPARE(m_list.alerts().front().id.systemId, std::uint8_t(1));
        m_list.handleEvent(switchDone(channel::SwitchFailure::NotConfirmed), 2);
        QCOMPARE(m_list.alerts().front().severity, AlertSeverity::Warning);
        QVERIFY(m_list.alerts().front().details.contains(QStringLiteral("rolled back")));
        show(12);
        QVERIFY(m_list.alerts().empty());
        auto rekey = switchDone(channel::SwitchFailure::None);
        rekey.rekey = true;
        m_list.handleEvent(rekey, 13);
        QVERIFY(m_list.alerts().empty());
    }

    void sweepSwitchesInSilence()
    {
        ViewState view = viewOf(std::make_shared<const engine::Snapshot>(sealedSnapshot(0)), 1);
        view.inSweep = true;
        m_list.showView(view, 0);
        m_list.handleEvent(switchDone(channel::SwitchFailure::None), 1);
        QVERIFY(m_list.alerts().empty());
    }

    void severeEventStaysUntilItIsDismissed()
    {
        show(0);
        channel::SessionUp up;
        up.session = channel::SessionId{7};
        up.peerName = "air-1";
        m_list.handleEvent(up, 0);
        channel::SessionDown down;
        down.session = channel::SessionId{7};
        down.reason = channel::DownReason::Cloned;
        m_list.handleEvent(down, 1);
        for (double t = 2; t < 1000; t += 10)
            show(t);
        QCOMPARE(texts(), QStringList{QStringLiteral("air-1: keys in use twice")});
        m_list.dismiss({AlertKind::KeysCloned, 1});
        QVERIFY(m_list.alerts().empty());
    }

    void limitsRaiseAlerts()
    {
        ValueChoice altitude{.source = *findValueSource(QStringLiteral("alt_rel"))};
        altitude.low = 5;
        altitude.high = 120;
        ValueChoice rolling{.source = *findValueSource(QStringLiteral("ATTITUDE.roll")), .caption = QStringLiteral("bank")};
        rolling.high = 30;
        m_list.setValues({altitude, rolling}, UnitSystem::Metric);
        const auto at = [](double metres, double ageOfValues = 0.1) {
            return [=](engine::Snapshot &snapshot) {
                snapshot.vehicles.front().state.altitudeRelative = metres;
                snapshot.vehicles.front().state.messageAge = ageOfValues;
            };
        };
        show(0, at(119));
        show(1, at(121)); // one outlier
        show(1.5, at(119));
        show(2.6, at(119));
        QVERIFY(m_list.alerts().empty());
        show(10, at(121));
        QVERIFY(m_list.alerts().empty());
        show(11, at(122.5));
        QCOMPARE(texts(), QStringList{QStringLiteral("alt high: 122.5\u00a0m")});
        QCOMPARE(m_list.alerts().front().severity, AlertSeverity::Warning);
        QCOMPARE(m_list.alerts().front().details, QStringLiteral("The high limit is 120.0\u00a0m."));
        QCOMPARE(m_list.takeRaised().size(), std::size_t(1));
        for (double t = 12; t < 40; t += 1) // it swings
            show(t, at(int(t) % 2 == 0 ? 119 : 121));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        QVERIFY(m_list.takeRaised().empty());
        show(40, at(119));
        show(42.9, at(119));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        show(43.2, at(119));
        QVERIFY(m_list.alerts().empty());
        show(50, at(4));
        show(51, at(4));
        QCOMPARE(texts(), QStringList{QStringLiteral("alt low: 4.0\u00a0m")});
        QVERIFY(m_list.alerts().front().details.endsWith(QStringLiteral("Passed 2 times.")));
        show(60, at(50, 4)); // old: nothing is known
        QVERIFY(texts().contains(QStringLiteral("alt low: 4.0\u00a0m")));
        show(61, at(50));
        show(63, at(50));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        show(64, at(50));
        QVERIFY(m_list.alerts().empty());
    }

    void dismissedLimitComesBackAfterItEnded()
    {
        ValueChoice altitude{.source = *findValueSource(QStringLiteral("alt_rel"))};
        altitude.high = 120;
        m_list.setValues({altitude}, UnitSystem::Aviation);
        const auto at = [](double metres) {
            return [=](engine::Snapshot &snapshot) { snapshot.vehicles.front().state.altitudeRelative = metres; };
        };
        show(0, at(130));
        show(1, at(130));
        QCOMPARE(texts(), QStringList{QStringLiteral("alt high: 427\u00a0ft")});
        m_list.dismiss(m_list.alerts().front().id);
        show(100, at(140));
        QVERIFY(m_list.alerts().empty());
        show(101, at(100));
        show(104, at(100));
        show(110, at(130));
        show(111, at(130));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        m_number = 0; // another station, with the same limits
        show(112, at(130));
        QVERIFY(m_list.alerts().empty());
        show(113, at(130));
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        m_list.setValues({}, UnitSystem::Aviation);
        show(114, at(130));
        QVERIFY(m_list.alerts().empty());
    }

    void limitsOfAllVehiclesAreWatched()
    {
        ValueChoice altitude{.source = *findValueSource(QStringLiteral("alt_rel"))};
        altitude.high = 120;
        m_list.setValues({altitude}, UnitSystem::Metric);
        const auto two = [](engine::Snapshot &snapshot) {
            snapshot.vehicles.push_back(snapshot.vehicles.front());
            snapshot.vehicles[1].state.systemId = 2;
            snapshot.vehicles[1].state.altitudeRelative = 150;
        };
        show(0, two);
        show(1, two);
        QCOMPARE(texts(), QStringList{QStringLiteral("Vehicle 2: alt high: 150.0\u00a0m")});
        show(2); // it is gone
        QVERIFY(m_list.alerts().empty());
    }

    void fullDisksAreNamed()
    {
        show(1, [](engine::Snapshot &snapshot) {
            snapshot.recording.file = "/logs";
            snapshot.recording.problem = "less than 200 MiB are free there";
            snapshot.storageProblem = "No space left on device";
        });
        QVERIFY(texts().contains(QStringLiteral("Not recording: less than 200 MiB are free there")));
        QVERIFY(texts().contains(QStringLiteral("Counters not stored: No space left on device")));
        show(2);
        QVERIFY(m_list.alerts().empty());
        m_list.handleEvent(channel::PeerStorageChanged{channel::SessionId{7}, true}, 3);
        show(3);
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        QCOMPARE(m_list.alerts().front().id, (AlertId{AlertKind::AgentNotStoring, 1}));
        m_list.dismiss(m_list.alerts().front().id);
        show(4);
        QVERIFY(m_list.alerts().empty());
        m_list.handleEvent(channel::PeerStorageChanged{channel::SessionId{7}, false}, 5);
        show(5);
        m_list.handleEvent(channel::PeerStorageChanged{channel::SessionId{7}, true}, 6);
        show(6);
        QCOMPARE(m_list.alerts().size(), std::size_t(1));
        show(7, [](engine::Snapshot &snapshot) { snapshot.sessions.clear(); });
        QVERIFY(m_list.alerts().empty());
    }

    void severeOnesStandFirst()
    {
        show(0);
        show(1, battery(15));
        show(2, [](engine::Snapshot &snapshot) {
            battery(15)(snapshot);
            age(5)(snapshot);
            forged(1, 1)(snapshot);
        });
        QCOMPARE(texts(),
                 (QStringList{QStringLiteral("Link lost 5 s"), QStringLiteral("Battery low: 15 %"),
                              QStringLiteral("One forged frame")}));
    }

    void severalVehiclesAreNamed()
    {
        const auto two = [](double ageOfSecond) {
            return [=](engine::Snapshot &snapshot) {
                snapshot.vehicles.push_back(snapshot.vehicles.front());
                snapshot.vehicles[1].state.systemId = 2;
                snapshot.vehicles[1].state.messageAge = ageOfSecond;
            };
        };
        show(1, two(9));
        QCOMPARE(texts(), QStringList{QStringLiteral("Vehicle 2: Link lost 9 s")});
        show(2, [&](engine::Snapshot &snapshot) {
            two(10)(snapshot);
            forged(4, 4)(snapshot); // of one session, over which both are heard
        });
        QCOMPARE(texts(),
                 (QStringList{QStringLiteral("Vehicle 2: Link lost 10 s"), QStringLiteral("Vehicle 1: 4 forged frames")}));
        show(3); // the second one is gone
        QVERIFY(!texts().join(QLatin1Char(' ')).contains(QStringLiteral("Link lost")));
    }

    void anotherStationStartsOver()
    {
        show(0);
        show(1, mode("RTL"));
        show(2, age(9));
        QCOMPARE(m_list.alerts().size(), std::size_t(2));
        m_number = 0; // that of the demo
        show(3, mode("GUIDED"));
        QVERIFY(m_list.alerts().empty());
    }

    /// Whatever strangers send, and for however long.
    void memoryIsBounded()
    {
        show(0);
        double now = 10;
        std::size_t most = 0;
        for (int round = 0; round < 40; ++round, now += 1) {
            for (int id = 0; id < 256; ++id) {
                m_list.handleEvent(engine::PlaintextRefused{static_cast<std::uint8_t>(id), "192.0.2.66:40000", 1, {}}, now);
                m_list.handleEvent(unknownAgentAt(static_cast<std::uint8_t>(id)), now);
                m_list.handleEvent(channel::PeerStorageChanged{channel::SessionId{static_cast<std::uint32_t>(1000 + id)}, true},
                                   now);
                m_list.handleEvent(vehicle::TextReceived{static_cast<std::uint8_t>(id), {1, 4, "Failsafe", {}}}, now);
            }
            show(now);
            most = std::max(most, m_list.alerts().size());
        }
        QCOMPARE(most, std::size_t(256 + 1)); // forged frames of each system, and an unknown agent
        QCOMPARE(m_list.takeRaised().size(), AlertList::kMostRaised);
        show(now + 100);
        QVERIFY(m_list.alerts().empty());
    }

private:
    static ChangeSnapshot age(double seconds)
    {
        return [=](engine::Snapshot &snapshot) { snapshot.vehicles.front().state.messageAge = seconds; };
    }
    static ChangeSnapshot battery(double percent)
    {
        return [=](engine::Snapshot &snapshot) { snapshot.vehicles.front().state.batteryPercent = percent; };
    }
    static ChangeSnapshot mode(const char *name)
    {
        return [=](engine::Snapshot &snapshot) { enterMode(snapshot.vehicles.front().state, name); };
    }
    static ChangeSnapshot forged(std::uint64_t total, std::uint64_t lastMinute)
    {
        return [=](engine::Snapshot &snapshot) {
            snapshot.sessions.front().stats.rx.forged = total;
            snapshot.sessions.front().forgedLastMinute = lastMinute;
        };
    }

    void show(double now, const ChangeSnapshot &change = {})
    {
        engine::Snapshot snapshot = sealedSnapshot(0);
        snapshot.number = ++m_number;
        if (change)
            change(snapshot);
        m_list.showView(viewOf(std::make_shared<const engine::Snapshot>(std::move(snapshot)), 1), now);
    }

    QStringList texts() const
    {
        QStringList out;
        for (const Alert &alert : m_list.alerts())
            out << alert.text;
        return out;
    }

    AlertList m_list;
    std::uint64_t m_number = 0;
};

SKYSEAL_TEST(AlertsTest)
#include "alerts_test.moc"
