// A vehicle whose sealed session has ended: it is not shown as plain MAVLink, and commands that cannot be sent are disabled. A
// session that a sweep has ended is shown as part of the sweep.
#include "fake_sweep.h"
#include "scripted_snapshots.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "ui/flight/take_off_dialog.h"
#include "ui/security/secure_link_panel.h"
#include "ui/security/suite_actions.h"
#include "ui/text/lock_face.h"
#include "ui/status/strip_item.h"
#include "ui/sweep/sweep_dialog.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::ui;

class EndedSessionTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void endedSessionIsNotPlain_data()
    {
        QTest::addColumn<int>("reason");
        QTest::addColumn<QString>("title");
        QTest::addColumn<QString>("words");
        const auto row = [](const char *name, channel::DownReason reason, const char *title, const char *words) {
            QTest::newRow(name) << static_cast<int>(reason) << QString::fromUtf8(title) << QString::fromUtf8(words);
        };
        row("revoked", channel::DownReason::Revoked, "Revoked · air-1", "no longer a known peer");
        row("silent", channel::DownReason::TimedOut, "Session lost · air-1", "air-1 was silent for too long");
        row("goodbye", channel::DownReason::PeerClosed, "Session ended · air-1", "closed by the other end");
        row("restart", channel::DownReason::PeerRestarted, "Session ended · air-1", "the other end restarted");
        row("keys", channel::DownReason::Exhausted, "Session ended · air-1", "its keys were used up");
        row("copied", channel::DownReason::Cloned, "Session ended · air-1", "its keys are in use twice");
        row("here", channel::DownReason::Closed, "Session ended · air-1", "closed here");
    }

    void endedSessionIsNotPlain()
    {
        QFETCH(int, reason);
        QFETCH(QString, title);
        QFETCH(QString, words);
        const auto why = static_cast<channel::DownReason>(reason);
        m_station->show(sealedSnapshot(0));
        QVERIFY(!find<QPushButton>("secureKeys")->isVisible());
        engine::Snapshot snapshot = ended(1, why);
        m_station->show(snapshot);
        const QString advice = find<QLabel>("secureAdvice")->text();
        QCOMPARE(find<QLabel>("secureTitle")->text(), title);
        QVERIFY2(advice.contains(words), qPrintable(advice));
        QVERIFY2(!advice.contains(QStringLiteral("plain MAVLink")), qPrintable(advice));
        QCOMPARE(advice.contains(QStringLiteral("Waiting: ")), why != channel::DownReason::Revoked);
        QCOMPARE(find<StripItem>("stripLock")->text(), title);
        QVERIFY(find<QPushButton>("secureKeys")->isVisible());

        // The agent is back, and does not know our key any more.
        snapshot.time = 2;
        snapshot.unanswering.push_back({"air-1", "192.0.2.7:40000", "SHA256:own", 4});
        m_station->show(snapshot);
        QCOMPARE(find<StripItem>("stripLock")->text(), QStringLiteral("air-1 does not answer"));
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("air-1 does not answer"));
        QVERIFY(find<QLabel>("secureAdvice")->text().contains(QStringLiteral("SHA256:own")));

        m_station->show(sealedSnapshot(3));
        QVERIFY(find<QLabel>("secureTitle")->text().startsWith(QStringLiteral("Sealed")));
        m_station->show(plainSnapshot(4));
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Not sealed"));
    }

    void nothingIsOfferedThatCannotBeSent_data()
    {
        QTest::addColumn<int>("reason");
        QTest::addColumn<QString>("words");
        QTest::newRow("lost") << static_cast<int>(channel::DownReason::TimedOut) << QStringLiteral("Session lost · air-1");
        QTest::newRow("revoked") << static_cast<int>(channel::DownReason::Revoked) << QStringLiteral("Revoked · air-1");
    }

    void nothingIsOfferedThatCannotBeSent()
    {
        QFETCH(int, reason);
        QFETCH(QString, words);
        const QList<QPushButton *> buttons{find<HoldButton>("armButton"),     find<HoldButton>("landButton"),
                                           find<HoldButton>("returnButton"),  find<HoldButton>("takeOffButton"),
                                           find<HoldButton>("setModeButton"), find<QPushButton>("missionRead"),
                                           find<QPushButton>("missionSend"),  find<QPushButton>("parameterFetch")};
        const auto enabled = [&buttons](bool wanted) {
            return std::ranges::all_of(buttons, [=](const QPushButton *button) { return button->isEnabled() == wanted; });
        };
        m_station->show(sealedSnapshot(1));
        QVERIFY(enabled(true));
        QVERIFY(find<HoldButton>("landButton")->toolTip().startsWith(QStringLiteral("Hold")));

        // One that is held at that moment, and a dialog that is open, come too late as well.
        QTest::mousePress(find<HoldButton>("landButton"), Qt::LeftButton);
        find<QAction>("actionTakeOff")->trigger();
        auto *takeOff = m_window->findChild<TakeOffDialog *>();
        QVERIFY(takeOff);
        m_station->show(ended(2, static_cast<channel::DownReason>(reason)));
        QVERIFY(enabled(false));
        for (const QPushButton *button : buttons)
            QVERIFY2(button->toolTip().contains(words), qPrintable(button->objectName() + button->toolTip()));
        QVERIFY2(find<QLabel>("commandResult")->text().contains(words), qPrintable(find<QLabel>("commandResult")->text()));
        auto *go = takeOff->findChild<HoldButton *>(QStringLiteral("takeOffDialogGo"));
        QVERIFY(!go->isEnabled() && go->toolTip().contains(words));
        takeOff->close();
        QCOMPARE(find<HoldButton>("landButton")->progress(), 0.0);
        QVERIFY(!find<HoldButton>("landButton")->isDown()); // the hold is over, and nothing was sent
        QVERIFY(m_station->commands.empty());

        auto *menu = find<QMenu>("menuVehicle");
        Q_EMIT menu->aboutToShow();
        for (const char *name :
             {"actionArm", "actionDisarm", "actionTakeOff", "actionLand", "actionReturn", "actionStartMission"}) {
            QVERIFY2(!find<QAction>(name)->isEnabled(), name);
            QVERIFY2(find<QAction>(name)->toolTip().contains(words), name);
        }

        m_station->show(sealedSnapshot(3));
        QVERIFY(enabled(true));
        QCOMPARE(find<QLabel>("commandResult")->text(), QString());
        Q_EMIT menu->aboutToShow();
        QVERIFY(find<QAction>("actionDisarm")->isEnabled());
        m_station->show(plainSnapshot(4));
        QVERIFY(enabled(true));
    }

    void questionThatIsAnsweredTooLate()
    {
        m_station->show(sealedSnapshot(1));
        find<QAction>("actionLand")->trigger();
        auto *box = find<QMessageBox>("confirmCommand");
        m_station->show(ended(2, channel::DownReason::TimedOut));
        QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
        QVERIFY(m_station->commands.empty());
        const QString line = find<QLabel>("commandResult")->text();
        QVERIFY2(line.contains(QStringLiteral("not sent")), qPrintable(line));
    }

    void aSilentLinkStillTakesCommands()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.messageAge = 9;
        snapshot.vehicles.front().state.lost = true;
        m_station->show(snapshot);
        QVERIFY(find<HoldButton>("landButton")->isEnabled());
    }

    void plainRunOfASweepIsNamed()
    {
        SuiteActions suites(*m_station);
        SecureLinkPanel panel(suites);
        const auto text = [&panel](const char *name) { return panel.findChild<QLabel *>(QLatin1String(name))->text(); };
        ViewState view = viewOf(std::make_shared<const engine::Snapshot>(plainSnapshot(1)), 0);
        panel.showViewState(view);
        QVERIFY(text("secureAdvice").contains(QStringLiteral("Start skyseal-air")));
        QVERIFY(lockFaceOf(view).toolTip.contains(QStringLiteral("Start skyseal-air")));
        view.inSweep = true; // of sealed suites
        panel.showViewState(view);
        QCOMPARE(text("secureTitle"), QStringLiteral("Not sealed"));
        QCOMPARE(lockFaceOf(view).variants.front(), QStringLiteral("Not sealed · plain MAVLink"));
        view.plainRun = true;
        panel.showViewState(view);
        QCOMPARE(text("secureTitle"), QStringLiteral("Not sealed, sweep running"));
        QVERIFY(!text("secureAdvice").contains(QStringLiteral("Start skyseal-air")));
        QVERIFY(text("secureAdvice").contains(QStringLiteral("is measuring plain MAVLink")));
        QVERIFY(panel.findChild<QPushButton *>(QStringLiteral("secureHelp"))->isHidden());
        QCOMPARE(lockFaceOf(view).variants.front(), QStringLiteral("Not sealed · sweep running"));
        QVERIFY(!lockFaceOf(view).toolTip.contains(QStringLiteral("Start skyseal-air")));

        // Between plain MAVLink and a suite the session is ended by the sweep; a lost session is shown as lost.
        view = viewOf(std::make_shared<const engine::Snapshot>(ended(2, channel::DownReason::Closed)), 0);
        view.inSweep = true;
        QCOMPARE(lockFaceOf(view).variants.front(), QStringLiteral("New session · air-1"));
        view = viewOf(std::make_shared<const engine::Snapshot>(ended(2, channel::DownReason::TimedOut)), 0);
        view.inSweep = true;
        QCOMPARE(lockFaceOf(view).variants.front(), QStringLiteral("Session lost · air-1"));
    }

    void consentIsForTheRunInClearAlone()
    {
        FakeSweep sweeps;
        m_window->setSweep(sweeps);
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.armed = false;
        snapshot.sessions.front().info.peerOffered.push_back(crypto::SuiteId::None);
        m_station->show(snapshot);
        find<QAction>("actionSweep")->trigger();
        auto *dialog = m_window->findChild<SweepDialog *>();
        QVERIFY(dialog);
        dialog->findChild<QAbstractButton *>(QStringLiteral("sweep_none"))->setChecked(true);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QCOMPARE(sweeps.orders.size(), std::size_t(1));
        const auto title = [&](const engine::Snapshot &now) {
            m_station->show(now);
            return find<QLabel>("secureTitle")->text();
        };
        sweeps.begin(crypto::SuiteId::Aes256Gcm);
        QCOMPARE(title(plainSnapshot(2)), QStringLiteral("Not sealed")); // without consent
        sweeps.begin(crypto::SuiteId::None);
        QCOMPARE(title(plainSnapshot(3)), QStringLiteral("Not sealed, sweep running"));
        sweeps.begin(crypto::SuiteId::Aes256Gcm);
        QCOMPARE(title(plainSnapshot(4)), QStringLiteral("Not sealed, sweep running")); // on its way back
        QCOMPARE(title(sealedSnapshot(5)), QStringLiteral("Sealed"));
        QCOMPARE(title(plainSnapshot(6)), QStringLiteral("Not sealed"));
        sweeps.begin(crypto::SuiteId::None);
        sweeps.finish();
        QCOMPARE(title(plainSnapshot(7)), QStringLiteral("Not sealed"));
    }

private:
    /// The vehicle as it was heard last over the session that ended.
    static engine::Snapshot ended(double time, channel::DownReason reason)
    {
        engine::Snapshot snapshot = sealedSnapshot(time);
        snapshot.sessions.clear();
        snapshot.security = engine::Security::Nothing;
        snapshot.vehicles.front().ended = engine::EndedSession{"air-1", reason, 7};
        return snapshot;
    }
};

SKYSEAL_TEST_WIDGETS(EndedSessionTest)
#include "ended_session_test.moc"
