// The alerts over the map by pointer and keys: what is dismissed, what stays where it is, and what reaches the map.
#include "core/link/address_text.h"
#include "fake_keyring.h"
#include "fake_pairing.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/alert_row.h"
#include "ui/alerts/alert_stack.h"
#include "ui/flight/vehicle_commands.h"
#include "ui/keys/pairing_dialog.h"
#include "ui/map/map_view.h"
#include "window_hands.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QWheelEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

Alert makeAlert(std::uint8_t systemId, AlertSeverity severity = AlertSeverity::Warning)
{
    return {{AlertKind::LowBattery, systemId},
            severity,
            QStringLiteral("Alert %1").arg(systemId),
            QStringLiteral("Details"),
            1,
            0,
            true};
}

/// Counts what reaches the ground under the alerts.
class CountingGround : public QWidget
{
public:
    using QWidget::QWidget;
    int presses = 0, wheels = 0;

protected:
    void mousePressEvent(QMouseEvent *) override { ++presses; }
    void wheelEvent(QWheelEvent *event) override
    {
        ++wheels;
        event->accept();
    }
};

} // namespace

class AlertStackTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_frame = std::make_unique<QWidget>();
        m_frame->resize(800, 500);
        m_field = new QLineEdit(m_frame.get());
        m_field->setGeometry(0, 0, 200, 30);
        m_ground = new CountingGround(m_frame.get());
        m_ground->setGeometry(0, 40, 800, 460);
        m_stack = new AlertStack(*m_ground);
        m_dismissed.clear();
        m_alerts.clear();
        connect(m_stack, &AlertStack::dismissed, this, [this](AlertId id) {
            m_dismissed.push_back(id.systemId);
            std::erase_if(m_alerts, [&](const Alert &alert) { return alert.id == id; });
            m_stack->showAlerts(m_alerts, 0);
        });
        m_frame->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_frame.get(), test::kDeadlineMs));
        m_frame->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_frame.get(), test::kDeadlineMs));
        movePointer({400, 400});
    }
    void cleanup()
    {
        m_frame.reset();
        tearDown();
    }

    void isHiddenWithoutAlerts()
    {
        QVERIFY(m_stack->isHidden());
        show({1});
        QVERIFY(m_stack->isVisible());
        show({});
        QVERIFY(m_stack->isHidden());
    }

    void standsInTheUpperRightCorner()
    {
        show({1, 2});
        QCOMPARE(m_stack->geometry().right(), 800 - 41);
        QCOMPARE(m_stack->y(), 48);
        m_ground->resize(300, 460);
        QVERIFY(m_stack->x() >= 8);
        QCOMPARE(m_stack->geometry().right(), 300 - 41);
        m_ground->resize(300, 100); // room for one line and the number of the others
        QVERIFY(m_ground->geometry().contains(m_stack->geometry()));
        QCOMPARE(more()->text(), QStringLiteral("● and 1 more"));
    }

    void fiveAreShownAndTheOthersCounted()
    {
        show({1, 2, 3, 4, 5});
        QVERIFY(more()->isHidden());
        show({1, 2, 3, 4, 5, 6, 7, 8});
        QCOMPARE(lines(), (std::vector<int>{1, 2, 3, 4, 5}));
        QCOMPARE(more()->text(), QStringLiteral("● and 3 more"));
        QVERIFY(more()->isVisible());
    }

    void unknownAgentIsPairedFromItsAlert()
    {
        openWindow();
        FakeKeyring keyring;
        FakePairing pairing;
        m_window->setKeyring(keyring, &pairing);
        m_station->show(sealedSnapshot(1));
        channel::HandshakeRefused stranger;
        stranger.path.remote = link::ipv4(0xc0000207u, 14560);
        stranger.reason = channel::RefusalReason::UnknownPeer;
        m_station->notify(stranger);
        auto *pair = find<QToolButton>("alertRemedy0");
        EVENTUALLY(pair->isVisible());
        find<QAction>("actionAlerts")->trigger();
        EVENTUALLY(find<QToolButton>("alertDismiss0")->hasFocus());
        QTest::keyClick(find<QToolButton>("alertDismiss0"), Qt::Key_Backtab);
        EVENTUALLY(pair->hasFocus());
        QTest::keyClick(pair, Qt::Key_Return);
        EVENTUALLY(m_window->findChild<PairingDialog *>());
        tearDown(); // before the keyring
    }

    void clickDismisses()
    {
        show({1, 2, 3});
        QTest::mouseClick(dismissButton(1), Qt::LeftButton);
        QCOMPARE(m_dismissed, std::vector<int>{2});
        QTest::mouseClick(row(0), Qt::LeftButton, {}, {60, 10}); // on the text
        QCOMPARE(m_dismissed.size(), std::size_t(1));
        QCOMPARE(dismissButton(0)->accessibleName(), QStringLiteral("Dismiss: Alert 1"));
        QCOMPARE(row(0)->accessibleName(), QStringLiteral("Warning: Alert 1"));
    }

    void nothingMovesUnderThePointer()
    {
        show({1, 2, 3});
        movePointer(dismissButton(1)->mapTo(m_frame.get(), dismissButton(1)->rect().center()));
        m_alerts.insert(m_alerts.begin(), makeAlert(9, AlertSeverity::Severe));
        m_stack->showAlerts(m_alerts, 0);
        QCOMPARE(lines(), (std::vector<int>{1, 2, 3, 9})); // below, although it is the most important one
        QTest::mouseClick(m_frame->windowHandle(), Qt::LeftButton, {}, m_pointer);
        QCOMPARE(m_dismissed, std::vector<int>{2});
        QCOMPARE(lines(), (std::vector<int>{1, 0, 3, 9})); // its place stays empty
        QTest::mouseClick(m_frame->windowHandle(), Qt::LeftButton, {}, m_pointer);
        QCOMPARE(m_dismissed.size(), std::size_t(1));
        QCOMPARE(m_ground->presses, 0);
        movePointer({400, 400});
        QCOMPARE(lines(), (std::vector<int>{9, 1, 3}));
    }

    void hiddenAlarmMarksTheLastLineWhilePointed()
    {
        show({1, 2, 3, 4, 5, 6});
        movePointer(row(0)->mapTo(m_frame.get(), QPoint(60, 10)));
        m_alerts.insert(m_alerts.begin(), makeAlert(9, AlertSeverity::Severe));
        m_stack->showAlerts(m_alerts, 0);
        QCOMPARE(lines(), (std::vector<int>{1, 2, 3, 4, 5}));
        QCOMPARE(more()->text(), QStringLiteral("▲ and 2 more"));
        movePointer({400, 400});
        QCOMPARE(lines(), (std::vector<int>{9, 1, 2, 3, 4}));
    }

    void keysChooseAndDismiss()
    {
        m_field->setFocus();
        show({1, 2, 3});
        m_stack->focusFirst();
        QVERIFY(dismissButton(0)->hasFocus());
        press(Qt::Key_Down);
        QVERIFY(dismissButton(1)->hasFocus());
        press(Qt::Key_Escape);
        QCOMPARE(m_dismissed, std::vector<int>{2});
        QVERIFY(dismissButton(2)->hasFocus()); // the next one, on its own line
        press(Qt::Key_Up);
        QVERIFY(dismissButton(0)->hasFocus());
        press(Qt::Key_Return);
        QCOMPARE(m_dismissed, (std::vector<int>{2, 1}));
        press(Qt::Key_Space);
        QCOMPARE(m_dismissed, (std::vector<int>{2, 1, 3}));
        QVERIFY(m_field->hasFocus());
    }

    void heldEscapeDismissesOne()
    {
        show({1, 2, 3});
        m_stack->focusFirst();
        press(Qt::Key_Escape);
        for (int i = 0; i < 5; ++i) {
            QKeyEvent again(QEvent::KeyPress, Qt::Key_Escape, {}, QString(), true);
            QCoreApplication::sendEvent(QApplication::focusWidget(), &again);
        }
        QCOMPARE(m_dismissed, std::vector<int>{1});
    }

    /// An alert that ends by itself passes the focus on to no other one.
    void keyMeetsNoOtherAlert()
    {
        m_field->setFocus();
        show({1, 2});
        m_stack->focusFirst();
        std::erase_if(m_alerts, [](const Alert &alert) { return alert.id.systemId == 1; });
        m_stack->showAlerts(m_alerts, 0);
        QCOMPARE(lines(), (std::vector<int>{0, 2}));
        press(Qt::Key_Space);
        press(Qt::Key_Return);
        QVERIFY(m_dismissed.empty());
        press(Qt::Key_Escape);
        QVERIFY(m_field->hasFocus());
        EVENTUALLY(lines() == (std::vector<int>{2}));
    }

    void mapIsReachedBesideTheLines()
    {
        show({1, 2});
        const QRect box = m_stack->geometry();
        for (const QPoint at : {box.topLeft() - QPoint(3, 0), box.bottomRight() + QPoint(0, 3), box.topRight() + QPoint(4, 0)})
            QTest::mouseClick(m_frame->windowHandle(), Qt::LeftButton, {}, at);
        QCOMPARE(m_ground->presses, 3);
        wheelAt(box.bottomLeft() + QPoint(40, 3));
        QCOMPARE(m_ground->wheels, 1);
        QTest::mouseClick(m_frame->windowHandle(), Qt::LeftButton, {}, box.center());
        QCOMPARE(m_ground->presses, 3);
    }

    // In the window.

    void lostLinkIsShownOverTheMap()
    {
        openWindow();
        showAge(1, 4.2);
        const auto *map = find<MapView>("map");
        QVERIFY(m_stack->isVisible());
        QVERIFY(map->geometry().contains(m_stack->geometry()));
        QCOMPARE(row(0)->alert()->text, QStringLiteral("Link lost 4 s"));
        QTest::mouseClick(dismissButton(0), Qt::LeftButton);
        QVERIFY(m_stack->isHidden());
        showAge(2, 5.2);
        QVERIFY(m_stack->isHidden());
        showAge(3, 0.1);
        showAge(4, 4.2);
        QVERIFY(m_stack->isVisible());
    }

    void shortcutGoesToTheAlerts()
    {
        openWindow();
        showAge(1, 0.1);
        QVERIFY(!find<QAction>("actionAlerts")->isEnabled());
        showAge(2, 4.2);
        QVERIFY(find<QAction>("actionAlerts")->isEnabled());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), test::kDeadlineMs));
        auto *map = find<MapView>("map");
        map->setFocus();
        QTest::keyClick(map, Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(dismissButton(0)->hasFocus());
        QTest::keyClick(dismissButton(0), Qt::Key_Escape);
        QVERIFY(m_stack->isHidden());
        QVERIFY(map->hasFocus());
    }

    void shortcutGoesToTheAlertsAfterAMenu()
    {
        openWindow();
        showAge(1, 0.1);
        showAge(2, 4.2);
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), test::kDeadlineMs));
        find<MapView>("map")->setFocus();
        WindowHands(*m_window).choose("menuView", "actionZoomIn");
        m_window->activateWindow(); // a menu takes that from the window on this platform, unlike on X11: see x11_test
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), test::kDeadlineMs));
        QTest::keyClick(m_window->windowHandle(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(dismissButton(0)->hasFocus());
    }

    void onlyModesFromElsewhereAreAlerts()
    {
        openWindow();
        showAge(1, 0.1);
        m_window->findChild<VehicleCommands *>()->send(1, vehicle::SetMode{"RTL"});
        showAge(2, 0.1, "RTL");
        QVERIFY(m_stack->isHidden());
        m_station = std::make_unique<FakeStation>();
        open();
        m_stack = find<AlertStack>("alertStack");
        showAge(1, 0.1);
        showAge(2, 0.1, "RTL");
        QVERIFY(m_stack->isVisible());
        QCOMPARE(row(0)->alert()->text, QStringLiteral("Mode GUIDED → RTL, not by this station"));
    }

    void replayHidesNoAlertOfTheLiveVehicle()
    {
        openWindow();
        showAge(1, 0.1);
        m_window->startReplay(QStringLiteral("tlog:/logs/one.tlog"));
        engine::Snapshot old = plainSnapshot(3);
        old.vehicles.front().state.messageAge = 30;
        m_station->showReplay(old);
        QVERIFY(m_stack->isHidden()); // that of the recording is no alert
        showAge(2, 4.2);
        QVERIFY(m_stack->isVisible());
        QCOMPARE(row(0)->alert()->text, QStringLiteral("Link lost 4 s"));
        m_window->endReplay();
        QVERIFY(m_stack->isVisible());
    }

private:
    void show(std::initializer_list<int> ids)
    {
        m_alerts.clear();
        for (const int id : ids)
            m_alerts.push_back(makeAlert(static_cast<std::uint8_t>(id)));
        m_stack->showAlerts(m_alerts, 0);
    }
    AlertRow *row(int number) const { return m_stack->findChild<AlertRow *>(QStringLiteral("alertRow%1").arg(number)); }
    QToolButton *dismissButton(int number) const { return row(number)->button(); }
    QLabel *more() const { return m_stack->findChild<QLabel *>(QStringLiteral("alertMore")); }
    /// The system ids on the visible lines; 0: an empty place.
    std::vector<int> lines() const
    {
        std::vector<int> out;
        for (int i = 0; i < AlertStack::kMostShown && !row(i)->isHidden(); ++i)
            out.push_back(row(i)->alert() ? row(i)->alert()->id.systemId : 0);
        return out;
    }
    /// In the frame.
    void movePointer(const QPoint &place)
    {
        m_pointer = place;
        QCursor::setPos(m_frame->mapToGlobal(place)); // Qt asks for it when a part of the window disappears
        QTest::mouseMove(m_frame->windowHandle(), place);
        QCoreApplication::processEvents();
    }
    void wheelAt(const QPoint &place)
    {
        movePointer(place);
        QWidget *under = m_frame->childAt(place);
        QWheelEvent turn(QPointF(under->mapFrom(m_frame.get(), place)), QPointF(m_frame->mapToGlobal(place)), {}, {0, 120},
                         Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(under, &turn);
    }
    static void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }

    void openWindow()
    {
        m_frame.reset();
        setUp();
        m_stack = find<AlertStack>("alertStack");
    }
    void showAge(double time, double age, const char *mode = "GUIDED")
    {
        engine::Snapshot snapshot = sealedSnapshot(time);
        snapshot.vehicles.front().state.messageAge = age;
        enterMode(snapshot.vehicles.front().state, mode);
        m_station->show(snapshot);
    }

    std::unique_ptr<QWidget> m_frame;
    QLineEdit *m_field = nullptr;
    CountingGround *m_ground = nullptr;
    AlertStack *m_stack = nullptr;
    QPoint m_pointer;
    std::vector<Alert> m_alerts;
    std::vector<int> m_dismissed;
};

SKYSEAL_TEST_WIDGETS(AlertStackTest)
#include "alert_stack_test.moc"
