// Touch-sized controls on small screens: no workspace and no dialog needs more room than the screen has.
#include "fake_sweep.h"
#include "gallery_dialogs.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/form_scroll.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"
#include "ui/window/workspace_table.h"
#include "ui/yielding_scroll.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QScreen>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QSpinBox>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

constexpr QSize kScreens[] = {QSize(1366, 768), QSize(1024, 768)};
constexpr int kTitle = 40; ///< pixels: what the window manager takes of the height

QString text(const QSize &size)
{
    return QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
}

bool fits(const QSize &size, const QSize &room)
{
    return size.width() <= room.width() && size.height() <= room.height() - kTitle;
}

} // namespace

class TouchRoomTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        find<QAction>("actionResetView")->trigger(); // the panels of a workspace
    }
    void cleanup()
    {
        tearDown();
        applyTheme(Theme::Light);
    }

    void workspacesFit_data()
    {
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<QByteArray>("workspace");
        for (const QSize &screen : kScreens)
            for (const WorkspaceRow &row : workspaceTable())
                QTest::addRow("%s %s", qPrintable(text(screen)), row.id) << screen << QByteArray(row.id);
    }
    void workspacesFit()
    {
        QFETCH(QSize, screen);
        QFETCH(QByteArray, workspace);
        const QSize room = screen - QSize(0, kTitle);
        m_window->resize(room);
        find<QAction>(("workspace_" + workspace).constData())->trigger();
        m_station->showSealed(1);
        setTouchSized(true);
        for (const char *state : {"waiting", "several"}) {
            if (state[0] == 'w')
                m_station->showWaiting();
            else
                m_station->showTwoSealed(2, [](auto &first) { first.systemId = 255; }); // each button names its vehicle
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
            const QSize least = m_window->minimumSizeHint();
            QVERIFY2(fits(least, screen), qPrintable(QLatin1String(state) + QLatin1Char(' ') + text(least)));
            QCOMPARE(m_window->size(), room);
        }
        setTouchSized(false);
        QCoreApplication::processEvents();
        QCOMPARE(m_window->size(), room);
    }

    /// Of the usual size, no panel is cut where its workspace has room for it.
    void usualSizeDoesNotScroll_data()
    {
        QTest::addColumn<QByteArray>("workspace");
        for (const WorkspaceRow &row : workspaceTable())
            QTest::newRow(row.id) << QByteArray(row.id);
    }
    void usualSizeDoesNotScroll()
    {
        QFETCH(QByteArray, workspace);
        m_window->resize(1366, 768);
        find<QAction>(("workspace_" + workspace).constData())->trigger();
        m_station->showSealed(1);
        QCoreApplication::processEvents();
        for (const YieldingScroll *scroll : m_window->findChildren<YieldingScroll *>()) {
            if (!scroll->isVisible())
                continue;
            EVENTUALLY2(!scroll->verticalScrollBar()->isVisible(), qPrintable(scroll->accessibleName()));
            EVENTUALLY2(!scroll->horizontalScrollBar()->isVisible(), qPrintable(scroll->accessibleName()));
        }
    }

    /// Nothing is lost with the room: the panel scrolls.
    void panelWithoutRoomScrolls()
    {
        m_window->resize(1366, 768 - kTitle);
        find<QAction>("workspace_vehicle")->trigger();
        m_station->showSealed(1);
        setTouchSized(true);
        find<QAction>("view_dockLinks")->trigger();
        const auto *last = find<QWidget>("linkRemove");
        EVENTUALLY(last->isVisible());
        for (const char *name : {"linkAdd", "linkRemove"})
            QVERIFY2(find<QWidget>(name)->height() >= kTouchTarget - 1, name);
    }

    void dialogsFit_data()
    {
        QTest::addColumn<QString>("state");
        for (const QString &state : dialogStates())
            QTest::newRow(qPrintable(state)) << state;
    }
    void dialogsFit()
    {
        QFETCH(QString, state);
        setTouchSized(true);
        m_station->showSealed(1);
        FakeKeyring keyring;
        FakePairing pairing;
        fillKeyring(keyring);
        const std::unique_ptr<QWidget> dialog(openDialog(state, *m_window, keyring, pairing));
        QVERIFY(QTest::qWaitForWindowExposed(dialog.get(), test::kDeadlineMs));
        for (const QSize &screen : kScreens)
            QVERIFY2(fits(dialog->minimumSizeHint().expandedTo(dialog->minimumSize()), screen),
                     qPrintable(text(dialog->minimumSizeHint())));
        for (const FormScroll *area : dialog->findChildren<FormScroll *>()) // nothing is cut at the side
            EVENTUALLY2(area->widget()->width() <= area->viewport()->width(), qPrintable(text(area->widget()->size())));
        QVERIFY2(dialog->height() <= dialog->screen()->availableSize().height() - kTitle, qPrintable(text(dialog->size())));
    }

    /// All of its fields can be reached by keys, and its buttons stay where they are.
    void sweepIsConfiguredByKeys()
    {
        m_window->setSweep(m_sweeps);
        m_station->showSealed(1);
        setTouchSized(true);
        find<QAction>("actionSweep")->trigger();
        auto *dialog = find<QDialog>("sweepDialog");
        QVERIFY(QTest::qWaitForWindowExposed(dialog, test::kDeadlineMs));
        dialog->resize(dialog->width(), 768 - kTitle);
        dialog->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(dialog, test::kDeadlineMs));
        auto *run = dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        QVERIFY(dialog->rect().contains(QRect(run->mapTo(dialog, QPoint()), run->size())));
        auto *repeats = dialog->findChild<QSpinBox *>(QStringLiteral("sweepRepeats"));
        for (int i = 0; i < 80 && !repeats->hasFocus(); ++i)
            QTest::keyClick(dialog->focusWidget() ? dialog->focusWidget() : dialog, Qt::Key_Tab);
        QVERIFY(repeats->hasFocus());
        EVENTUALLY(repeats->visibleRegion().boundingRect().height() >= repeats->height() - 1);
        QVERIFY(dialog->rect().contains(QRect(run->mapTo(dialog, QPoint()), run->size())));
        dialog->close();
        EVENTUALLY(!m_window->findChild<QDialog *>(QStringLiteral("sweepDialog")));
    }

private:
    void setTouchSized(bool on)
    {
        find<QAction>("actionSettings")->trigger();
        auto *dialog = find<QDialog>("settingsDialog");
        EVENTUALLY(dialog->isVisible());
        auto *touch = dialog->findChild<QCheckBox *>(QStringLiteral("settingTouch"));
        if (touch->isChecked() != on)
            QTest::keyClick(touch, Qt::Key_Space);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        EVENTUALLY(!m_window->findChild<QDialog *>(QStringLiteral("settingsDialog")));
    }

    FakeSweep m_sweeps;
};

SKYSEAL_TEST_WIDGETS(TouchRoomTest)
#include "touch_room_test.moc"
