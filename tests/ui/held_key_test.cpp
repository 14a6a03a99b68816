// A key that is held commands once, and nothing in the control that gets the focus meanwhile. Under X11 a held key arrives as
// pairs of a release and a press without the mark of auto-repeat: QTest's events have none either.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/command_guard.h"
#include "ui/flight/hold_button.h"
#include "ui/held_keys.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QKeyEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QDialog>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class HeldKeyTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_station->showSealed(1);
        m_land = find<HoldButton>("landButton");
        m_setMode = find<HoldButton>("setModeButton");
    }
    void cleanup()
    {
        letGo(m_land, Qt::Key_Space);
        tearDown();
    }

    void commandsOnce_data()
    {
        QTest::addColumn<bool>("released");
        QTest::addColumn<bool>("marked");
        QTest::newRow("pairs without the mark") << true << false;
        QTest::newRow("pairs with the mark") << true << true;
        QTest::newRow("presses with the mark") << false << true;
    }
    void commandsOnce()
    {
        QFETCH(bool, released);
        QFETCH(bool, marked);
        m_land->setFocus();
        QTest::keyPress(m_land, Qt::Key_Space);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        auto *guard = m_land->findChild<CommandGuard *>();
        const auto repeatOnce = [&] {
            if (released)
                send(QEvent::KeyRelease, 0, marked);
            send(QEvent::KeyPress, 0, marked);
        };
        const auto repeatUntilItListens = [&] {
            repeatOnce();
            return m_land->isHeld() || !guard->isQuiet();
        };
        EVENTUALLY(repeatUntilItListens());
        for (int i = 0; i < 5; ++i) {
            repeatOnce();
            QVERIFY(!m_land->isHeld());
        }
        QCOMPARE(m_station->commands.size(), std::size_t(1));
    }

    void repeatingDoesNotInterruptAHold()
    {
        const QSignalSpy aborted(m_land, &HoldButton::aborted);
        m_land->setFocus();
        QTest::keyPress(m_land, Qt::Key_Space);
        const QMetaObject::Connection repeats = connect(&m_repeats, &QTimer::timeout, this,
                                                        [this] { repeat(m_land, Qt::Key_Space); });
        m_repeats.start(30);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        m_repeats.stop();
        disconnect(repeats);
        QCOMPARE(aborted.size(), 0);
    }

    void releaseAborts()
    {
        QSignalSpy aborted(m_land, &HoldButton::aborted);
        m_land->setFocus();
        QTest::keyPress(m_land, Qt::Key_Space);
        QTest::keyRelease(m_land, Qt::Key_Space);
        EVENTUALLY_EQUAL(aborted.size(), 1);
        QVERIFY(!m_land->isHeld());
        QVERIFY(m_station->commands.empty());
    }

    /// The event loop may be late: the times of the events decide.
    void timesOfEventsDecide()
    {
        send(QEvent::KeyPress, 1000);
        QVERIFY(m_land->isHeld());
        send(QEvent::KeyRelease, 1500);
        send(QEvent::KeyPress, 1500);
        QVERIFY(m_land->isHeld()); // the same hold
        QSignalSpy aborted(m_land, &HoldButton::aborted);
        send(QEvent::KeyRelease, 1600);
        send(QEvent::KeyPress, 1700); // again by a finger
        QCOMPARE(aborted.size(), 1);
        QVERIFY(m_land->isHeld());
        send(QEvent::KeyRelease, 1800);
        EVENTUALLY_EQUAL(aborted.size(), 2);
    }

    void keyThatWasDownBeforeIsIgnored()
    {
        m_land->setFocus();
        QTest::keyPress(m_land, Qt::Key_Space);
        m_setMode->setFocus();
        QVERIFY(!m_land->isHeld());
        repeat(m_setMode, Qt::Key_Space);
        QVERIFY(!m_setMode->isHeld());
        letGo(m_setMode, Qt::Key_Space);
        QTest::keyPress(m_setMode, Qt::Key_Space);
        QVERIFY(m_setMode->isHeld());
    }

    /// The release half can still reach the control that had the focus, the press half the one that has it now.
    void pairAcrossTheFocusIsIgnored()
    {
        m_land->setFocus();
        QTest::keyPress(m_land, Qt::Key_Space);
        QTest::keyRelease(m_land, Qt::Key_Space);
        m_setMode->setFocus();
        QTest::keyPress(m_setMode, Qt::Key_Space);
        QVERIFY(!m_setMode->isHeld());
    }

    void takeOffDialogLeavesNothingToTheNextControl()
    {
        m_setMode->setFocus();
        find<QAction>("actionTakeOff")->trigger();
        auto *dialog = find<QDialog>("takeOffDialog");
        auto *go = dialog->findChild<HoldButton *>(QStringLiteral("takeOffDialogGo"));
        go->setFocus();
        QTest::keyPress(go, Qt::Key_Space);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        EVENTUALLY(!m_window->findChild<QDialog *>(QStringLiteral("takeOffDialog")));
        m_window->activateWindow();
        m_setMode->setFocus();
        for (int i = 0; i < 3; ++i) {
            repeat(m_setMode, Qt::Key_Space);
            QVERIFY(!m_setMode->isHeld());
        }
    }

    void heldKeyAnswersNoQuestion_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("space") << int(Qt::Key_Space);
        QTest::newRow("return") << int(Qt::Key_Return);
    }
    void heldKeyAnswersNoQuestion()
    {
        QFETCH(int, key);
        const auto held = static_cast<Qt::Key>(key);
        QTest::keyPress(m_window.get(), held);
        find<QAction>("actionLand")->trigger();
        auto *box = find<QMessageBox>("confirmCommand");
        auto *yes = box->button(QMessageBox::Yes);
        yes->setFocus();
        for (int i = 0; i < 3; ++i)
            repeat(yes, held);
        QTest::keyRelease(yes, held);
        QVERIFY(m_station->commands.empty());
        QVERIFY(box->isVisible());
        letGo(yes, held);
        QTest::keyClick(yes, held);
        QCOMPARE(m_station->commands.size(), std::size_t(1));
    }

    /// Neither does it press a button that commands nothing: it would open a panel, or tick a box.
    void heldKeyPressesNoOtherButton()
    {
        auto *fetch = find<QPushButton>("parameterFetch");
        const QSignalSpy clicked(fetch, &QPushButton::clicked);
        m_land->setFocus();
        send(QEvent::KeyPress, 1000);
        fetch->setFocus();
        for (quint64 at = 1500; at < 1600; at += 30) {
            send(QEvent::KeyRelease, at, false, fetch);
            send(QEvent::KeyPress, at, false, fetch);
        }
        send(QEvent::KeyRelease, 1600, false, fetch);
        QCOMPARE(clicked.size(), 0);
        send(QEvent::KeyPress, 1700, false, fetch); // by a finger
        send(QEvent::KeyRelease, 1750, false, fetch);
        QCOMPARE(clicked.size(), 1);
        send(QEvent::KeyPress, 1760, false, fetch); // sooner than a finger could, but in the same button
        send(QEvent::KeyRelease, 1770, false, fetch);
        QCOMPARE(clicked.size(), 2);
    }

    void quietAfterACommand()
    {
        QTest::mousePress(m_land, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::mouseRelease(m_land, Qt::LeftButton);
        QTest::mousePress(m_land, Qt::LeftButton);
        QVERIFY(!m_land->isHeld());
        QTest::mouseRelease(m_land, Qt::LeftButton);
        letGo(m_land, Qt::Key_Space);
        const auto pressed = [this] {
            QTest::mousePress(m_land, Qt::LeftButton);
            return m_land->isHeld();
        };
        EVENTUALLY(pressed());
        QTest::mouseRelease(m_land, Qt::LeftButton);
    }

private:
    /// As X11 repeats a key.
    static void repeat(QWidget *control, Qt::Key key)
    {
        QTest::keyRelease(control, key);
        QTest::keyPress(control, key);
    }
    /// Until the release counts.
    static void letGo(QWidget *control, Qt::Key key)
    {
        QSignalSpy released(&HeldKeys::ofProgram(), &HeldKeys::released);
        QTest::keyRelease(control, key);
        EVENTUALLY(!released.isEmpty());
    }
    void send(QEvent::Type type, quint64 milliseconds, bool marked = false, QWidget *control = nullptr)
    {
        QKeyEvent event(type, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), marked);
        event.setTimestamp(milliseconds);
        QCoreApplication::sendEvent(control ? control : m_land, &event);
    }

    HoldButton *m_land = nullptr, *m_setMode = nullptr;
    QTimer m_repeats;
};

SKYSEAL_TEST_WIDGETS(HeldKeyTest)
#include "held_key_test.moc"
