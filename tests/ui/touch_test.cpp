// The window by fingers: touch-sized controls, held buttons, the map's gestures and lists that scroll under a finger.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/flight/hold_button.h"
#include "ui/map/map_view.h"
#include "ui/status/strip_item.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QPointingDevice>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QTabBar>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class TouchTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_finger = QTest::createTouchDevice(); }
    void init()
    {
        setUp();
        m_window->resize(1366, 768);
        m_station->showSealed(1);
    }
    void cleanup()
    {
        applyTheme(Theme::Light);
        tearDown();
    }

    void settingIsChosenByKeys()
    {
        QVERIFY(find<QComboBox>("modeBox")->height() < kTouchTarget);
        switchByKeys();
        EVENTUALLY(find<QComboBox>("modeBox")->height() >= kTouchTarget);
        QVERIFY(loadSettings(*m_store).touchSized);
        open(); // it stays
        EVENTUALLY(find<QComboBox>("modeBox")->height() >= kTouchTarget);
        switchByKeys();
        EVENTUALLY(find<QComboBox>("modeBox")->height() < kTouchTarget);
        QVERIFY(!loadSettings(*m_store).touchSized);
    }

    void targetsAreLargeEnough()
    {
        m_window->resize(1920, 1600); // all docks at once are more than a small screen has room for
        switchByKeys();
        EVENTUALLY(find<QComboBox>("modeBox")->height() >= kTouchTarget);
        QCoreApplication::processEvents();
        int seen = 0;
        for (const auto *button : m_window->findChildren<QAbstractButton *>()) {
            if (!isTarget(*button))
                continue;
            ++seen;
            // Layouts follow one after the other, and may round.
            const bool large = test::eventually([&] { return button->height() >= kTouchTarget - 1; });
            QVERIFY2(large,
                     qPrintable(QStringLiteral("%1 %2 %3x%4")
                                    .arg(button->objectName(), button->text())
                                    .arg(button->width())
                                    .arg(button->height())));
        }
        QVERIFY(seen > 20);
        for (const auto *bar : m_window->findChildren<QTabBar *>())
            for (int i = 0; bar->isVisible() && i < bar->count(); ++i)
                QVERIFY2(bar->tabRect(i).height() >= kTouchTarget, qPrintable(bar->tabText(i)));
        const auto *view = find<QTreeView>("missionView");
        QVERIFY(view->sizeHintForRow(0) >= kTouchTarget);
    }

    void menuRowsAreLargeEnough()
    {
        switchByKeys();
        auto *bar = m_window->menuBar();
        for (const QAction *title : bar->actions()) {
            QVERIFY2(bar->actionGeometry(const_cast<QAction *>(title)).height() >= kTouchTarget, qPrintable(title->text()));
            QMenu *menu = title->menu();
            menu->popup({0, 0});
            for (QAction *action : menu->actions())
                if (!action->isSeparator() && action->isVisible())
                    QVERIFY2(menu->actionGeometry(action).height() >= kTouchTarget, qPrintable(action->text()));
            menu->close();
        }
    }

    void fingerHoldsAButton()
    {
        auto *takeOff = find<HoldButton>("takeOffButton");
        const QPoint middle = takeOff->rect().center();
        QTest::touchEvent(takeOff, m_finger).press(0, middle, takeOff);
        QVERIFY(takeOff->isHeld());
        QTest::touchEvent(takeOff, m_finger).release(0, middle, takeOff); // too early
        QVERIFY(!takeOff->isHeld());
        QVERIFY(m_station->commands.empty());
        QTest::touchEvent(takeOff, m_finger).press(0, middle, takeOff);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::touchEvent(takeOff, m_finger).release(0, middle, takeOff);
        QVERIFY(std::holds_alternative<vehicle::TakeOff>(m_station->commands[0].second));
    }

    void longPressOpensTheMenuOfThePlace()
    {
        QSignalSpy asked(map(), &MapView::menuRequested);
        const QPoint at(300, 200);
        QTest::touchEvent(map(), m_finger).press(0, at, map());
        EVENTUALLY_EQUAL(asked.size(), 1);
        QTest::touchEvent(map(), m_finger).release(0, at, map());
        QCOMPARE(asked.front().front().value<LatLong>(), mercator::unproject(map()->viewport().toMetres(at)));
        QVERIFY(find<QMenu>("mapMenu")->isVisible());
        find<QMenu>("mapMenu")->close();
    }

    void fingerDragsTheMap()
    {
        QSignalSpy asked(map(), &MapView::menuRequested);
        const QPointF under = map()->viewport().toMetres({300, 200});
        QTest::touchEvent(map(), m_finger).press(0, {300, 200}, map());
        for (int step = 1; step <= 5; ++step)
            QTest::touchEvent(map(), m_finger).move(0, {300 + 20 * step, 200 + 10 * step}, map());
        QTest::touchEvent(map(), m_finger).release(0, {400, 250}, map());
        const QPointF now = map()->viewport().toPixels(under);
        QVERIFY2((now - QPointF(400, 250)).manhattanLength() < 1, qPrintable(QString::number(now.x())));
        QVERIFY(!map()->isFollowing());
        QVERIFY(asked.isEmpty());
    }

    void twoFingersZoomAroundTheirMiddle()
    {
        QSignalSpy asked(map(), &MapView::menuRequested);
        const QPointF middle(350, 220);
        const QPointF under = map()->viewport().toMetres(middle);
        const double before = map()->viewport().metresPerPixel();
        const auto pair = [&](int apart) { return std::pair(QPoint(350 - apart, 220), QPoint(350 + apart, 220)); };
        QTest::touchEvent(map(), m_finger).press(0, pair(50).first, map());
        QTest::touchEvent(map(), m_finger).move(0, pair(50).first, map()).press(1, pair(50).second, map());
        for (const int apart : {60, 75, 100}) {
            const auto [left, right] = pair(apart);
            QTest::touchEvent(map(), m_finger).move(0, left, map()).move(1, right, map());
        }
        QTest::touchEvent(map(), m_finger).release(0, pair(100).first, map()).release(1, pair(100).second, map());
        QVERIFY2(qAbs(map()->viewport().metresPerPixel() * 2 / before - 1) < 1e-6,
                 qPrintable(QString::number(before / map()->viewport().metresPerPixel())));
        QVERIFY((map()->viewport().toPixels(under) - middle).manhattanLength() < 1e-3);
        QVERIFY(asked.isEmpty());
    }

    void tapSelectsAVehicle()
    {
        m_station->showTwoSealed(2, {}, [](auto &second) { second.position.latitude += 0.0004; });
        const QPoint other = map()->viewport().toPixels(map()->content().others().front().metres).toPoint();
        QVERIFY(map()->rect().contains(other));
        QTest::touchEvent(map(), m_finger).press(0, other, map());
        QTest::touchEvent(map(), m_finger).release(0, other, map());
        EVENTUALLY_EQUAL(map()->content().systemId(), std::uint8_t(2));
    }

    void listScrollsUnderAFinger()
    {
        applyTheme(Theme::Light, true);
        QListWidget list;
        for (int i = 0; i < 100; ++i)
            list.addItem(QString::number(i));
        list.resize(300, 400);
        list.show();
        QVERIFY(QTest::qWaitForWindowExposed(&list, test::kDeadlineMs));
        QWidget *part = list.viewport();
        QTest::touchEvent(part, m_finger).press(0, {100, 300}, part);
        for (int y = 290; y >= 100; y -= 10)
            QTest::touchEvent(part, m_finger).move(0, {100, y}, part);
        EVENTUALLY(list.verticalScrollBar()->value() > 0);
        QTest::touchEvent(part, m_finger).release(0, {100, 100}, part);
        QVERIFY(list.sizeHintForRow(0) >= kTouchTarget);
    }

private:
    /// What a finger presses, and is not a part of a larger control. Qt sizes the buttons of a dock's title itself.
    static bool isTarget(const QAbstractButton &button)
    {
        const auto *item = qobject_cast<const StripItem *>(&button);
        return button.isVisible() && !button.objectName().startsWith(QLatin1String("qt_dockwidget"))
            && !qobject_cast<const QLineEdit *>(button.parentWidget()) && !qobject_cast<const QTabBar *>(button.parentWidget())
            && (!item || item->focusPolicy() != Qt::NoFocus);
    }

    void switchByKeys()
    {
        find<QAction>("actionSettings")->trigger();
        auto *dialog = find<SettingsDialog>("settingsDialog");
        EVENTUALLY(dialog->isVisible());
        auto *touch = dialog->findChild<QCheckBox *>(QStringLiteral("settingTouch"));
        touch->setFocus();
        QTest::keyClick(touch, Qt::Key_Space);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        EVENTUALLY(!m_window->findChild<SettingsDialog *>());
        m_window->activateWindow();
    }

    MapView *map() const { return find<MapView>("map"); }

    QPointingDevice *m_finger = nullptr;
};

SKYSEAL_TEST_WIDGETS(TouchTest)
#include "touch_test.moc"
