// Where the keyboard is: Esc leads from the menus back to the control before, in one step, and Tab stops nowhere out of sight.
// By real key events.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/window/tab_stops.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QWindow>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QTabBar>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

QString nameOf(const QWidget *widget)
{
    if (!widget)
        return QStringLiteral("nothing");
    QString text;
    QDebug(&text) << widget << "in" << widget->parentWidget() << widget->isVisible() << widget->visibleRegion()
                  << widget->geometry();
    return text;
}

} // namespace

class KeyboardFocusTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_station->showSealed(1);
        m_window->activateWindow();
        EVENTUALLY(QApplication::activeWindow() == m_window.get());
    }
    void cleanup() { tearDown(); }

    void escapeReturnsFromTheMenus_data()
    {
        QTest::addColumn<QString>("way");
        for (const char *way : {"Alt", "F10", "Alt with a letter", "Alt, then Down"})
            QTest::newRow(way) << QString::fromLatin1(way);
    }
    void escapeReturnsFromTheMenus()
    {
        QFETCH(QString, way);
        for (const char *start : {"messageFilter", "map", "returnButton"}) {
            auto *before = find<QWidget>(start);
            before->setFocus();
            EVENTUALLY(before->hasFocus());
            enterMenus(way);
            QVERIFY2(QApplication::activePopupWidget() || m_window->menuBar()->hasFocus(), start);
            press(Qt::Key_Escape);
            EVENTUALLY(!QApplication::activePopupWidget());
            EVENTUALLY2(before->hasFocus(), qPrintable(nameOf(QApplication::focusWidget())));
            QVERIFY(!m_window->menuBar()->activeAction());
        }
    }

    void arrowsWorkInTheMenus()
    {
        find<QWidget>("map")->setFocus();
        enterMenus(QStringLiteral("F10"));
        press(Qt::Key_Right);
        press(Qt::Key_Down);
        EVENTUALLY(QApplication::activePopupWidget());
        QCOMPARE(QApplication::activePopupWidget()->objectName(), QStringLiteral("menuLink"));
        press(Qt::Key_Return);
        EVENTUALLY(m_window->findChild<QDialog *>(QStringLiteral("linkDialog")));
    }

    void tabStopsInSight_data()
    {
        QTest::addColumn<QString>("from");
        for (const char *from : {"unlockStop", "editValues"})
            QTest::newRow(from) << QString::fromLatin1(from);
    }
    void tabStopsInSight()
    {
        QFETCH(QString, from);
        for (const char *workspace : {"workspace_fly", "workspace_plan", "workspace_vehicle", "workspace_lab"}) {
            find<QAction>(workspace)->trigger();
            auto *start = find<QWidget>(from.toLatin1());
            if (!start->isVisible())
                continue;
            for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
                start->setFocus(Qt::TabFocusReason);
                EVENTUALLY(start->hasFocus());
                press(key);
                QWidget *next = QApplication::focusWidget();
                QVERIFY2(next && next != start && isInSight(*next), qPrintable(nameOf(next)));
            }
        }
    }

    /// Tab bars that no dock needs are parked beside the window.
    void tabGoesAroundInSight()
    {
        for (const char *workspace : {"workspace_lab", "workspace_vehicle", "workspace_plan", "workspace_fly"}) {
            find<QAction>(workspace)->trigger();
            auto *start = find<QWidget>("unlockStop");
            for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
                start->setFocus(Qt::TabFocusReason);
                EVENTUALLY(start->hasFocus());
                int stops = 0;
                do {
                    press(key);
                    const QWidget *now = QApplication::focusWidget();
                    QVERIFY2(now && isInSight(*now), qPrintable(nameOf(now)));
                } while (!start->hasFocus() && ++stops < 500);
                QVERIFY2(stops > 8 && stops < 500, workspace);
            }
        }
    }

    void whatIsOutsideIsOutOfSight()
    {
        auto *bar = new QTabBar(m_window.get());
        bar->addTab(QStringLiteral("parked"));
        bar->setGeometry(20, 20, 100, 30);
        bar->show();
        QVERIFY(isInSight(*bar));
        bar->move(-600, -530);
        QVERIFY(bar->isVisible() && !isInSight(*bar));
        bar->setFocus();
        press(Qt::Key_Tab);
        for (int i = 0; i < 200; ++i, press(Qt::Key_Tab))
            QVERIFY(!bar->hasFocus());
    }

private:
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QWindow *to = QGuiApplication::focusWindow();
        if (auto *popup = QApplication::activePopupWidget())
            to = popup->windowHandle();
        QTest::keyClick(to, key, modifiers);
    }
    static void enterMenus(const QString &way)
    {
        if (way == QLatin1String("F10"))
            return press(Qt::Key_F10);
        if (way == QLatin1String("Alt with a letter"))
            return press(Qt::Key_F, Qt::AltModifier);
        QWindow *to = QGuiApplication::focusWindow();
        QTest::keyPress(to, Qt::Key_Alt, Qt::AltModifier);
        QTest::keyRelease(to, Qt::Key_Alt);
        if (way == QLatin1String("Alt, then Down"))
            press(Qt::Key_Down);
    }
};

SKYSEAL_TEST_WIDGETS(KeyboardFocusTest)
#include "keyboard_focus_test.moc"
