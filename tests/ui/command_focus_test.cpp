// The focus never comes to a control that commands by itself: not when a card vanishes or the demo starts, whatever is hidden,
// disabled or destroyed, when a dialog closes, nor at the start of the window. By the tab key it does. By real key events.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/command_guard.h"
#include "ui/flight/hold_button.h"
#include "ui/held_keys.h"
#include "window_rig.h"

#include <QtCore/QPointer>
#include <QtGui/QAction>
#include <QtGui/QWindow>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

using namespace skyseal;
using namespace skyseal::ui;

class CommandFocusTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUpWithDemo();
        EVENTUALLY(QApplication::activeWindow() == m_window.get());
    }
    void cleanup() { tearDown(); }

    void windowStartsWithoutACommand()
    {
        QVERIFY(commandsNothing());
        m_station->show(disarmedSnapshot());
        QVERIFY(commandsNothing());
        holdSpace();
        QVERIFY(m_station->commands.empty());
    }

    void cardVanishes_data()
    {
        QTest::addColumn<QString>("button");
        QTest::addColumn<bool>("flying");
        for (const char *button : {"demoButton", "connectButton"})
            for (const bool flying : {false, true})
                QTest::addRow("%s, %s", button, flying ? "flying" : "on the ground") << QString::fromLatin1(button) << flying;
    }
    /// Space is held on its button, and goes on repeating when the vehicle appears.
    void cardVanishes()
    {
        QFETCH(QString, button);
        QFETCH(bool, flying);
        m_station->show(waitingSnapshot());
        auto *control = find<QPushButton>(button.toLatin1().constData());
        EVENTUALLY(control->isVisible());
        control->setFocus();
        EVENTUALLY(control->hasFocus());
        QTest::keyPress(window(), Qt::Key_Space);
        repeatSpace();
        m_station->show(flying ? sealedSnapshot(1) : disarmedSnapshot());
        EVENTUALLY(!control->isVisible());
        QVERIFY2(commandsNothing(), qPrintable(nameOfFocus()));
        for (int i = 0; i < 5; ++i) {
            repeatSpace();
            QVERIFY(nothingIsHeld());
        }
        letGo();
        holdSpace(); // a second time, meant for the card
        QVERIFY2(commandsNothing(), qPrintable(nameOfFocus()));
        QVERIFY(m_station->commands.empty());
    }

    /// The button acts when the key is released; the vehicle of the demo appears then.
    void demoStarts()
    {
        m_station->show(waitingSnapshot());
        auto *demo = find<QPushButton>("demoButton");
        demo->setFocus();
        EVENTUALLY(demo->hasFocus());
        connect(m_window.get(), &MainWindow::demoRequested, this, [this] { m_station->show(disarmedSnapshot()); });
        QTest::keyClick(window(), Qt::Key_Space);
        EVENTUALLY(!demo->isVisible());
        QVERIFY2(commandsNothing(), qPrintable(nameOfFocus()));
        holdSpace();
        QVERIFY(m_station->commands.empty());
    }

    void whateverIsTakenAway_data()
    {
        QTest::addColumn<QString>("how");
        for (const char *how : {"hidden", "disabled"})
            QTest::newRow(how) << QString::fromLatin1(how);
    }
    void whateverIsTakenAway()
    {
        QFETCH(QString, how);
        m_station->show(disarmedSnapshot());
        int taken = 0;
        for (const QPointer<QWidget> widget : m_window->findChildren<QWidget *>()) {
            if (!widget || !widget->isVisible() || !widget->isEnabled() || (widget->focusPolicy() & Qt::TabFocus) == 0)
                continue;
            widget->setFocus();
            if (!widget->hasFocus())
                continue;
            ++taken;
            if (how == QLatin1String("hidden"))
                widget->hide();
            else
                widget->setEnabled(false);
            QVERIFY2(commandsNothing(), qPrintable(widget->objectName() + QStringLiteral(" to ") + nameOfFocus()));
            widget->setEnabled(true);
            widget->show();
        }
        QVERIFY2(taken > 30, qPrintable(QString::number(taken)));
    }

    void destroyedControlLeavesTheFocusToNoCommand()
    {
        m_station->show(disarmedSnapshot());
        auto *bar = find<QWidget>("actionBar");
        auto passing = std::make_unique<QPushButton>(bar);
        passing->show();
        QWidget::setTabOrder(passing.get(), find<QWidget>("armButton"));
        passing->setFocus();
        EVENTUALLY(passing->hasFocus());
        passing.reset();
        QVERIFY2(commandsNothing(), qPrintable(nameOfFocus()));
    }

    void dialogCloses()
    {
        m_station->show(disarmedSnapshot());
        auto *arm = find<HoldButton>("armButton");
        reachByTab(arm);
        QTest::keyClick(window(), Qt::Key_F12);
        QPointer<QDialog> dialog;
        const auto opened = [&] {
            dialog = m_window->findChild<QDialog *>(QStringLiteral("linkDialog"));
            return dialog && dialog->isActiveWindow();
        };
        EVENTUALLY(opened());
        QTest::keyClick(dialog->windowHandle(), Qt::Key_Escape);
        EVENTUALLY(!dialog || !dialog->isVisible());
        m_window->activateWindow();
        EVENTUALLY(QApplication::activeWindow() == m_window.get());
        EVENTUALLY2(commandsNothing(), qPrintable(nameOfFocus()));
        holdSpace();
        QVERIFY(m_station->commands.empty());
    }

    /// The vehicle takes off while the focus is on its button, which would be Disarm.
    void disarmInTheAirLosesTheFocus()
    {
        m_station->show(disarmedSnapshot());
        auto *arm = find<HoldButton>("armButton");
        reachByTab(arm);
        engine::Snapshot flying = sealedSnapshot(2);
        flying.vehicles.front().state.inAir = true;
        m_station->show(flying);
        QVERIFY(!arm->isEnabled());
        QVERIFY2(commandsNothing(), qPrintable(nameOfFocus()));
        holdSpace();
        QVERIFY(m_station->commands.empty());
    }

    void tabReachesIt()
    {
        m_station->show(disarmedSnapshot());
        auto *arm = find<HoldButton>("armButton");
        reachByTab(arm);
        QTest::keyPress(window(), Qt::Key_Space);
        QVERIFY(arm->isHeld());
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        letGo();
    }

private:
    static engine::Snapshot disarmedSnapshot()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.armed = false;
        return snapshot;
    }
    QWindow *window() const { return m_window->windowHandle(); }
    static bool commandsNothing()
    {
        const QWidget *focus = QApplication::focusWidget();
        return !focus || !focus->findChild<CommandGuard *>(QString(), Qt::FindDirectChildrenOnly);
    }
    static QString nameOfFocus()
    {
        const QWidget *focus = QApplication::focusWidget();
        return focus ? focus->objectName() : QStringLiteral("nothing");
    }
    bool nothingIsHeld() const
    {
        const auto buttons = m_window->findChildren<HoldButton *>();
        return std::ranges::none_of(buttons, &HoldButton::isHeld);
    }
    void repeatSpace() const
    {
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), true);
        QWidget *focus = QApplication::focusWidget();
        QCoreApplication::sendEvent(focus ? focus : static_cast<QWidget *>(m_window.get()), &press);
    }
    void letGo() const
    {
        QSignalSpy released(&HeldKeys::ofProgram(), &HeldKeys::released);
        QTest::keyRelease(window(), Qt::Key_Space);
        EVENTUALLY(!released.isEmpty());
    }
    /// As long as a button needs that was held at the same time, and beyond.
    void holdSpace() const
    {
        HoldButton reference(QStringLiteral("reference"));
        reference.show();
        m_window->activateWindow();
        QTest::keyPress(window(), Qt::Key_Space);
        const QSignalSpy confirmed(&reference, &HoldButton::confirmed);
        QTest::mousePress(&reference, Qt::LeftButton);
        EVENTUALLY_EQUAL(confirmed.size(), 1);
        QVERIFY(nothingIsHeld());
        letGo();
    }
    void reachByTab(const QWidget *control) const
    {
        find<QWidget>("map")->setFocus();
        for (int i = 0; i < 500 && !control->hasFocus(); ++i)
            QTest::keyClick(window(), Qt::Key_Tab);
        QVERIFY(control->hasFocus());
    }
};

SKYSEAL_TEST_WIDGETS(CommandFocusTest)
#include "command_focus_test.moc"
