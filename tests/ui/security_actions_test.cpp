// The choice of the suite, by real clicks and keys in the menu and in the panel, and the faces of a switch.
#include "core/engine/text/event_text.h"
#include "core/engine/text/state_text.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/security/remembered_suites.h"
#include "ui/security/suite_actions.h"
#include "ui/security/suite_row.h"
#include "ui/status/strip_item.h"
#include "ui/text/units.h"
#include "window_rig.h"

#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;

namespace {

channel::SwitchDone switchedTo(SuiteId suite)
{
    return {channel::SessionId{7},        SuiteId::ChaCha20Poly1305,    suite, channel::Epoch{4}, false, false,
            channel::SwitchFailure::None, std::chrono::milliseconds(42)};
}

channel::SwitchDone keysChanged()
{
    return {
        channel::SessionId{7},        SuiteId::ChaCha20Poly1305,    SuiteId::ChaCha20Poly1305, channel::Epoch{4}, false, true,
        channel::SwitchFailure::None, std::chrono::milliseconds(42)};
}

} // namespace

class SecurityActionsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void menuClickAsksTheStation()
    {
        m_station->show(sealedSnapshot(1));
        auto *menu = m_window->findChild<QMenu *>(QStringLiteral("menuSecurity"));
        QVERIFY(menu);
        QTest::mouseClick(m_window->menuBar(), Qt::LeftButton, {},
                          m_window->menuBar()->actionGeometry(menu->menuAction()).center());
        EVENTUALLY(menu->isVisible());
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action(SuiteId::Aes256Gcm)).center());
        EVENTUALLY_EQUAL(m_station->switches.size(), std::size_t(1));
        QCOMPARE(m_station->switches[0].first, channel::SessionId{7});
        QCOMPARE(m_station->switches[0].second, SuiteId::Aes256Gcm);
    }

    void choiceIsTakenUpInTheNextSession()
    {
        chooseAndRestart(SuiteId::Aes256Gcm);
        EVENTUALLY_EQUAL(m_station->switches.size(), std::size_t(1));
        QCOMPARE(m_station->switches[0].first, channel::SessionId{7});
        QCOMPARE(m_station->switches[0].second, SuiteId::Aes256Gcm);
        m_station->notify(switchedTo(SuiteId::Aes256Gcm));
        m_station->show(sealedSnapshot(3, SuiteId::Aes256Gcm));
        m_station->show(sealedSnapshot(4)); // the agent has chosen another one since: it is left alone
        QCOMPARE(m_station->switches.size(), std::size_t(1));
    }

    /// The sessions of the other one are as strong as they can be.
    void weakerChoiceIsNotTakenUp()
    {
        chooseAndRestart(SuiteId::Aes256Ctr);
        EVENTUALLY2(note()->text().contains(QStringLiteral("AES-256-CTR, chosen last, is weaker")), qPrintable(note()->text()));
        QVERIFY(m_station->switches.empty());
    }

    void choiceThatIsNotPermittedIsNotTakenUp()
    {
        chooseAndRestart(SuiteId::Aes256Gcm, {SuiteId::ChaCha20Poly1305});
        EVENTUALLY2(note()->text().contains(QStringLiteral("is not permitted now")), qPrintable(note()->text()));
        QVERIFY(m_station->switches.empty());
    }

    void onlySoundSuitesAreRemembered()
    {
        RememberedSuites suites(*m_store);
        const crypto::PublicKey one{1}, other{2};
        suites.remember(one, SuiteId::Aes256Gcm);
        suites.remember(one, SuiteId::Rc4); // for research
        QCOMPARE(suites.of(one), std::optional(SuiteId::Aes256Gcm));
        QCOMPARE(suites.of(other), std::nullopt);
        for (const QString &key : m_store->allKeys())
            if (key.startsWith(QLatin1String("suites/")))
                m_store->setValue(key, QStringLiteral("rc4")); // by hand
        QCOMPARE(suites.of(one), std::nullopt);
        for (int i = 0; i < 2 * RememberedSuites::kMostPeers; ++i)
            suites.remember({std::uint8_t(i), std::uint8_t(i / 256), 9}, SuiteId::Aes256Gcm);
        m_store->beginGroup(QStringLiteral("suites"));
        QVERIFY(m_store->childKeys().size() <= RememberedSuites::kMostPeers);
        m_store->endGroup();
    }

    void menuByKeysAsksTheStation()
    {
        m_station->show(sealedSnapshot(1));
        auto *menu = m_window->findChild<QMenu *>(QStringLiteral("menuSecurity"));
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::AltModifier);
        EVENTUALLY(menu->isVisible());
        menu->setActiveAction(action(SuiteId::ChaCha20Poly1305));
        QTest::keyClick(menu, Qt::Key_Down);
        QTest::keyClick(menu, Qt::Key_Down);
        QTest::keyClick(menu, Qt::Key_Return);
        EVENTUALLY_EQUAL(m_station->switches.size(), std::size_t(1));
        QCOMPARE(m_station->switches[0].second, SuiteId::Aes256Ctr);
    }

    void shortcutAsksTheStation()
    {
        m_station->show(sealedSnapshot(1));
        QTest::keyClick(m_window.get(), Qt::Key_4, Qt::ControlModifier | Qt::ShiftModifier);
        EVENTUALLY_EQUAL(m_station->switches.size(), std::size_t(1));
        QCOMPARE(m_station->switches[0].second, SuiteId::Aes256Cbc);
    }

    void changeKeysNow()
    {
        auto *change = m_window->findChild<QAction *>(QStringLiteral("actionChangeKeys"));
        QVERIFY(change && !change->isEnabled()); // no link yet
        m_station->show(sealedSnapshot(1));
        auto *menu = m_window->findChild<QMenu *>(QStringLiteral("menuSecurity"));
        QTest::mouseClick(m_window->menuBar(), Qt::LeftButton, {},
                          m_window->menuBar()->actionGeometry(menu->menuAction()).center());
        EVENTUALLY(menu->isVisible());
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(change).center());
        EVENTUALLY_EQUAL(m_station->switches.size(), std::size_t(1));
        QCOMPARE(m_station->switches[0].first, channel::SessionId{7});
        QCOMPARE(m_station->switches[0].second, SuiteId::ChaCha20Poly1305); // the one in use
        QVERIFY(!change->isEnabled());
        QVERIFY(change->text().contains(QStringLiteral("changing")));

        channel::SwitchDone done = keysChanged();
        m_station->notify(done);
        QVERIFY(change->isEnabled());
        QVERIFY(action(SuiteId::ChaCha20Poly1305)->isChecked());
        QVERIFY2(note()->text().contains(QStringLiteral("New keys for ChaCha20-Poly1305, epoch 4, in 42 ms")),
                 qPrintable(note()->text()));

        QTest::keyClick(m_window.get(), Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(m_station->switches.size(), std::size_t(2));
        done.failure = channel::SwitchFailure::NotConfirmed;
        m_station->notify(done);
        QVERIFY(change->isEnabled());
        QVERIFY(note()->text().contains(QStringLiteral("did not confirm")));

        engine::Snapshot pending = sealedSnapshot(1.1);
        pending.sessions.front().info.pending = SuiteId::Aes256Gcm;
        m_station->show(pending);
        QVERIFY(!change->isEnabled());
        m_station->show(plainSnapshot(2));
        QVERIFY(!change->isEnabled());
        QVERIFY(change->toolTip().contains(QStringLiteral("not sealed")));
    }

    void freshKeysAreCalledFreshKeys()
    {
        engine::Snapshot pending = sealedSnapshot(1);
        pending.security = engine::Security::Switching;
        pending.sessions.front().info.pending = SuiteId::ChaCha20Poly1305; // what is in use
        m_station->show(pending);
        QCOMPARE(strip()->text(), QStringLiteral("ChaCha20-Poly1305 · changing keys…"));
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Sealed, changing keys…"));
    }

    void noSuiteWhileKeysAreChanged()
    {
        m_station->show(sealedSnapshot(1));
        m_window->findChild<QAction *>(QStringLiteral("actionChangeKeys"))->trigger();
        QVERIFY(!action(SuiteId::Aes256Gcm)->isEnabled()); // requested, not yet pending in the snapshot
        QVERIFY(action(SuiteId::ChaCha20Poly1305)->isEnabled());
        QTest::keyClick(m_window.get(), Qt::Key_2, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(m_station->switches.size(), std::size_t(1));
        channel::SwitchDone done = keysChanged();
        m_station->notify(done);
        QVERIFY(action(SuiteId::Aes256Gcm)->isEnabled());
    }

    void panelClickPendsThenCommits()
    {
        m_station->show(sealedSnapshot(1));
        SuiteRow *gcm = row(SuiteId::Aes256Gcm);
        SuiteRow *chacha = row(SuiteId::ChaCha20Poly1305);
        QVERIFY(chacha->isChecked());
        QTest::mouseClick(gcm, Qt::LeftButton, {}, QPoint(12, gcm->height() / 2));
        QCOMPARE(m_station->switches.size(), std::size_t(1));
        // Until it is confirmed the old suite has the mark, in both views.
        QVERIFY(gcm->text().contains(QStringLiteral("switching")));
        QVERIFY(!gcm->isChecked());
        QVERIFY(chacha->isChecked());
        QVERIFY(action(SuiteId::ChaCha20Poly1305)->isChecked());

        engine::Snapshot pending = sealedSnapshot(1.1);
        pending.security = engine::Security::Switching;
        pending.sessions.front().info.pending = SuiteId::Aes256Gcm;
        m_station->show(pending);
        QVERIFY(strip()->text().contains(QStringLiteral("switching")));
        QVERIFY(strip()->text().contains(QStringLiteral("ChaCha20-Poly1305")));

        m_station->notify(channel::SwitchDone{channel::SessionId{7}, SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm,
                                              channel::Epoch{4}, false, false, channel::SwitchFailure::None,
                                              std::chrono::milliseconds(42)});
        QVERIFY(gcm->isChecked());
        QVERIFY(!chacha->isChecked());
        QCOMPARE(gcm->text(), QStringLiteral("AES-256-GCM"));
        QVERIFY(note()->text().contains(QStringLiteral("AES-256-GCM")));
        QVERIFY(note()->text().contains(QStringLiteral("42 ms")));
        m_station->show(sealedSnapshot(1.2, SuiteId::Aes256Gcm, 4));
        QVERIFY(strip()->text().startsWith(QStringLiteral("AES-256-GCM")));
        QVERIFY(strip()->text().contains(QStringLiteral("epoch 4")));
    }

    void timesAreRoundedAlike()
    {
        m_station->show(sealedSnapshot(1));
        const auto noteOf = [&](SuiteId to, std::chrono::microseconds took) {
            const bool rekey = to == SuiteId::ChaCha20Poly1305;
            if (rekey)
                m_window->findChild<QAction *>(QStringLiteral("actionChangeKeys"))->trigger();
            const channel::SwitchDone done{channel::SessionId{7},
                                           SuiteId::ChaCha20Poly1305,
                                           to,
                                           channel::Epoch{4},
                                           false,
                                           rekey,
                                           channel::SwitchFailure::None,
                                           took};
            m_station->notify(done);
            const QString sentence = engine::eventText(done, {}).sentence; // of Messages and the command line
            return note()->text() == sentence ? sentence : note()->text() + QStringLiteral(" is not ") + sentence;
        };
        using std::chrono::microseconds;
        const QString fresh = noteOf(SuiteId::ChaCha20Poly1305, microseconds(430));
        QCOMPARE(fresh, QStringLiteral("New keys for ChaCha20-Poly1305, epoch 4, in 0.4 ms"));
        const QString quick = noteOf(SuiteId::Aes256Gcm, microseconds(430));
        QCOMPARE(quick, QStringLiteral("Switched from ChaCha20-Poly1305 to AES-256-GCM, epoch 4, in 0.4 ms"));
        const QString slow = noteOf(SuiteId::Aes256Gcm, microseconds(42'300));
        QCOMPARE(slow, QStringLiteral("Switched from ChaCha20-Poly1305 to AES-256-GCM, epoch 4, in 42 ms"));
        QCOMPARE(engine::switchTimeText(microseconds(9'960)), QStringLiteral("10 ms"));
    }

    void rollBackKeepsTheOldSuiteAndShowsTheReason()
    {
        m_station->show(sealedSnapshot(1));
        QTest::mouseClick(row(SuiteId::ChaCha20), Qt::LeftButton, {}, QPoint(12, 8));
        m_station->notify(channel::SwitchDone{channel::SessionId{7}, SuiteId::ChaCha20Poly1305, SuiteId::ChaCha20,
                                              channel::Epoch{4}, false, false, channel::SwitchFailure::NotConfirmed,
                                              std::chrono::seconds(5)});
        QVERIFY(row(SuiteId::ChaCha20Poly1305)->isChecked());
        QVERIFY(!row(SuiteId::ChaCha20)->isChecked());
        QCOMPARE(row(SuiteId::ChaCha20)->text(), QStringLiteral("ChaCha20"));
        QVERIFY(note()->isVisible());
        QVERIFY(note()->text().contains(QStringLiteral("Switch to ChaCha20 ")));
        QVERIFY(note()->text().contains(QStringLiteral("did not confirm")));
    }

    void switchIsNotSaidOfALinkThatIsNoMore()
    {
        m_station->show(sealedSnapshot(1));
        m_station->notify(channel::SwitchDone{channel::SessionId{7}, SuiteId::ChaCha20Poly1305, SuiteId::ChaCha20,
                                              channel::Epoch{4}, false, false, channel::SwitchFailure::None,
                                              std::chrono::milliseconds(5)});
        QVERIFY2(note()->text().startsWith(QStringLiteral("Switched from ")), qPrintable(note()->text()));
        m_station->show(plainSnapshot(2)); // without an event of its end, as when the demo ends
        QCOMPARE(note()->text(), QString());
    }

    void newSessionClearsTheEndOfTheLast()
    {
        m_station->show(sealedSnapshot(1));
        m_station->notify(channel::SessionDown{channel::SessionId{7}, channel::DownReason::PeerClosed, {}});
        QVERIFY2(note()->text().startsWith(QStringLiteral("Sealed link to the peer ended")), qPrintable(note()->text()));
        engine::Snapshot ended = sealedSnapshot(2);
        ended.sessions.clear();
        ended.vehicles.front().ended = engine::EndedSession{"air-1", channel::DownReason::PeerClosed, 1};
        m_station->show(ended);
        QVERIFY(!note()->text().isEmpty());
        engine::Snapshot again = sealedSnapshot(3);
        again.sessions.front().info.session = channel::SessionId{8};
        again.vehicles.front().session = channel::SessionId{8};
        m_station->show(again);
        QVERIFY2(note()->text().isEmpty(), qPrintable(note()->text()));
        QCOMPARE(m_window->findChild<QLabel *>(QStringLiteral("secureTitle"))->text(), QStringLiteral("Sealed"));
    }

    /// The end of one vehicle's session says nothing about another one in plain MAVLink.
    void endIsNotSaidOfAnotherVehicle()
    {
        m_station->show(sealedSnapshot(1));
        m_station->notify(channel::SessionDown{channel::SessionId{7}, channel::DownReason::TimedOut, {}});
        QVERIFY(!note()->text().isEmpty());
        m_station->show(plainSnapshot(2));
        QVERIFY2(note()->text().isEmpty(), qPrintable(note()->text()));
    }

    void nothingIsSaidOfTheDemoThatHasEnded()
    {
        m_window->setDemo(true);
        m_station->show(sealedSnapshot(1));
        m_station->notify(channel::SessionDown{channel::SessionId{7}, channel::DownReason::TimedOut, {}});
        QVERIFY(!note()->text().isEmpty());
        m_window->setDemo(false);
        QVERIFY2(note()->text().isEmpty(), qPrintable(note()->text()));
    }

    void rowsAreReachedByKeys()
    {
        m_station->show(sealedSnapshot(1));
        row(SuiteId::ChaCha20Poly1305)->setFocus();
        QTest::keyClick(m_window->focusWidget(), Qt::Key_Down);
        QCOMPARE(m_window->focusWidget(), row(SuiteId::Aes256Gcm));
        QVERIFY(m_station->switches.empty()); // moving the focus chooses nothing
        QTest::keyClick(m_window->focusWidget(), Qt::Key_Space);
        QCOMPARE(m_station->switches.size(), std::size_t(1));
    }

    void disabledSuitesSayWhy()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        auto &info = snapshot.sessions.front().info;
        info.permitted = {SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm};
        info.peerOffered = {SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm, SuiteId::Aes256Ctr};
        m_station->show(snapshot);
        QVERIFY(!row(SuiteId::Rc4)->isEnabled());
        QVERIFY(row(SuiteId::Rc4)->text().contains(QStringLiteral("research")));
        QVERIFY(row(SuiteId::Rc4)->text().contains(QStringLiteral("insecure")));
        QVERIFY(row(SuiteId::Aes256Cbc)->toolTip().contains(QStringLiteral("not offered")));
        QVERIFY(row(SuiteId::Aes256Ctr)->toolTip().contains(QStringLiteral("not allowed here")));
        QTest::mouseClick(row(SuiteId::Rc4), Qt::LeftButton, {}, QPoint(12, 8));
        QTest::keyClick(m_window.get(), Qt::Key_6, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(m_station->switches.empty());
    }

    void suitesWeakerThanAllowedSaySo()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        auto &info = snapshot.sessions.front().info;
        info.permitted = {SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm};
        m_window->suites().setWeakest(SuiteId::Aes256Gcm);
        m_station->show(snapshot);
        for (const SuiteId suite : {SuiteId::Aes256Ctr, SuiteId::Aes256Cbc, SuiteId::ChaCha20, SuiteId::Rc4}) {
            QVERIFY(!action(suite)->isEnabled());
            QVERIFY(action(suite)->text().contains(QStringLiteral("weaker than allowed")));
        }
        QVERIFY(action(SuiteId::Aes256Gcm)->isEnabled());
    }

    void rc4IsCalledInsecureWherever()
    {
        engine::Snapshot snapshot = sealedSnapshot(1, SuiteId::Rc4);
        snapshot.sessions.front().info.permitted.push_back(SuiteId::Rc4);
        m_station->show(snapshot);
        QVERIFY(strip()->text().contains(QStringLiteral("insecure")));
        QVERIFY(action(SuiteId::Rc4)->text().contains(QStringLiteral("insecure")));
        QVERIFY(strip()->toolTip().contains(QStringLiteral("insecure")));
    }

    void plainVehicleIsNotSealed()
    {
        m_station->show(plainSnapshot(1));
        QVERIFY(strip()->text().contains(QStringLiteral("Not sealed")));
        for (const SuiteId suite : crypto::sealedSuites()) {
            QVERIFY(!action(suite)->isEnabled());
            QVERIFY(!action(suite)->isChecked());
        }
        QVERIFY(m_window->findChild<QLabel *>(QStringLiteral("secureAdvice"))->text().contains(QStringLiteral("skyseal-air")));
        QVERIFY(m_window->findChild<QWidget *>(QStringLiteral("secureHelp"))->isVisible());
    }

    void attackShowsTheCount()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.security = engine::Security::UnderAttack;
        snapshot.sessions.front().forgedLastMinute = 214;
        snapshot.sessions.front().stats.rx.forged = 214;
        m_station->show(snapshot);
        QVERIFY(strip()->text().contains(QStringLiteral("214")));
        QVERIFY(strip()->text().contains(QStringLiteral("attack")));
        QCOMPARE(m_window->findChild<QLabel *>(QStringLiteral("counter_5_1"))->text(), QStringLiteral("214"));
    }

private:
    /// The session after the next start begins with ChaCha20-Poly1305, and permits these.
    void chooseAndRestart(SuiteId suite, const std::vector<SuiteId> &permitted = usualSuites())
    {
        m_station->show(sealedSnapshot(1));
        action(suite)->trigger();
        QCOMPARE(m_station->switches.size(), std::size_t(1));
        m_station->notify(switchedTo(suite));
        open();
        m_station->switches.clear();
        m_station->notify(channel::SessionUp{channel::SessionId{7}, {}, "air-1", SuiteId::ChaCha20Poly1305, {}});
        engine::Snapshot next = sealedSnapshot(2);
        next.sessions.front().info.permitted = permitted;
        m_station->show(next);
    }

    QAction *action(SuiteId suite) { return m_window->suites().action(suite); }
    SuiteRow *row(SuiteId suite)
    {
        return m_window->findChild<SuiteRow *>(QStringLiteral("row_") + action(suite)->objectName());
    }
    QLabel *note() { return m_window->findChild<QLabel *>(QStringLiteral("switchNote")); }
    StripItem *strip() { return m_window->findChild<StripItem *>(QStringLiteral("stripLock")); }
};

SKYSEAL_TEST_WIDGETS(SecurityActionsTest)
#include "security_actions_test.moc"
