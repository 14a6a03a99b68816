// The workspaces: keys and buttons change them, each shows its panels, keeps its arrangement, and fits the smallest window.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/window/panel_table.h"
#include "ui/window/workspace_table.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QScrollArea>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::ui;

class WorkspacesTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        find<QAction>("actionResetView")->trigger();
    }
    void cleanup() { tearDown(); }

    void firstOneIsForFlying()
    {
        QVERIFY(find<QAction>("workspace_fly")->isChecked());
        QCOMPARE(shownDocks(), QStringList{QStringLiteral("dockFlight")});
    }

    void menuTicksThePanelsThatAreShown()
    {
        for (std::size_t i : {0U, 3U, 1U}) {
            press(i);
            EVENTUALLY_EQUAL(shownDocks(), placedDocks(i));
            m_station->show(sealedSnapshot(1));
            QStringList ticked;
            for (const PanelRow &panel : panelTable())
                if (find<QAction>(QByteArray("view_").append(panel.id).constData())->isChecked())
                    ticked << QLatin1String(panel.id);
            QCOMPARE(ticked, placedDocks(i));
        }
    }

    void keysShowThePanelsOfEach()
    {
        for (std::size_t i : {1U, 2U, 3U, 0U}) {
            press(i);
            const WorkspaceRow &row = workspaceTable()[i];
            QVERIFY2(find<QAction>(QByteArray("workspace_").append(row.id).constData())->isChecked(), row.id);
            EVENTUALLY_EQUAL(shownDocks(), placedDocks(i));
        }
        for (const PanelRow &panel : panelTable())
            QVERIFY2(std::ranges::any_of(panel.places, [](auto area) { return area != Qt::NoDockWidgetArea; }), panel.id);
    }

    void panelsHaveTheirPlaces()
    {
        for (std::size_t i = 0; i < kWorkspaces; ++i) {
            press(i);
            for (const PanelRow &panel : panelTable())
                QCOMPARE(m_window->dockWidgetArea(find<QDockWidget>(panel.id)), areaIn(panel, static_cast<Workspace>(i)));
        }
    }

    void buttonsShowThem()
    {
        auto *tabs = find<QWidget>("workspaceTabs");
        const auto buttons = tabs->findChildren<QAbstractButton *>();
        QCOMPARE(buttons.size(), qsizetype(kWorkspaces));
        auto *map = m_window->findChild<QWidget *>(QStringLiteral("map"));
        QVERIFY(map);
        map->setFocus();
        QTest::mouseClick(buttons[3], Qt::LeftButton);
        EVENTUALLY_EQUAL(shownDocks(), placedDocks(3));
        QVERIFY(buttons[3]->isChecked() && !buttons[0]->isChecked());
        QCOMPARE(QApplication::focusWidget(), map);
        buttons[0]->setFocus();
        QTest::keyClick(buttons[0], Qt::Key_Space);
        EVENTUALLY_EQUAL(shownDocks(), placedDocks(0));
        for (std::size_t i = 0; i < kWorkspaces; ++i)
            QVERIFY(buttons[static_cast<qsizetype>(i)]->accessibleName().contains(QLatin1String(workspaceTable()[i].title)));
    }

    void eachKeepsItsArrangement()
    {
        find<QDockWidget>("dockFlight")->close();
        find<QAction>("view_dockMessages")->trigger(); // shown where the other workspaces have it
        const QStringList fly{QStringLiteral("dockMessages")};
        EVENTUALLY_EQUAL(shownDocks(), fly);
        QCOMPARE(m_window->dockWidgetArea(find<QDockWidget>("dockMessages")), Qt::BottomDockWidgetArea);
        press(3);
        EVENTUALLY_EQUAL(shownDocks(), placedDocks(3));
        find<QDockWidget>("dockSecure")->close();
        QStringList lab = placedDocks(3);
        lab.removeAll(QStringLiteral("dockSecure"));
        press(0);
        EVENTUALLY_EQUAL(shownDocks(), fly);
        press(3);
        EVENTUALLY_EQUAL(shownDocks(), lab);
        m_window->close();
        open();
        QVERIFY(find<QAction>("workspace_lab")->isChecked());
        EVENTUALLY_EQUAL(shownDocks(), lab);
        press(0);
        EVENTUALLY_EQUAL(shownDocks(), fly);
        find<QAction>("actionResetView")->trigger();
        EVENTUALLY_EQUAL(shownDocks(), placedDocks(0));
        press(3);
        EVENTUALLY_EQUAL(shownDocks(), lab); // another workspace is not reset with it
    }

    void floatingPanelReturnsWithItsWorkspace()
    {
        press(3);
        auto *dock = find<QDockWidget>("dockSecure");
        dock->setFloating(true);
        press(0);
        EVENTUALLY(!dock->isVisible());
        press(3);
        EVENTUALLY(dock->isVisible() && dock->isFloating());
        find<QAction>("actionResetView")->trigger();
        EVENTUALLY(dock->isVisible() && !dock->isFloating());
    }

    void hiddenPanelsDoNotCollect()
    {
        press(2);
        find<QAction>("view_dockInspector")->trigger();
        EVENTUALLY(m_station->inspecting);
        press(0);
        EVENTUALLY(!m_station->inspecting);
    }

    void planShowsTheAltitudes()
    {
        press(1);
        const auto *why = find<QLabel>("profileEmpty");
        QVERIFY(why->isVisible());
        QVERIFY(why->text().startsWith(QStringLiteral("No vehicle. The altitudes of its mission")));
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().mission = nullptr;
        m_station->show(snapshot);
        EVENTUALLY(why->text().contains(QStringLiteral("not been read")));
        std::vector<vehicle::MissionItem> items;
        for (std::uint16_t i = 0; i < 4; ++i)
            items.push_back({.sequence = i, .latitude = 47 + 0.001 * i, .longitude = 8, .altitude = i == 2 ? 48.5F : 10});
        snapshot.vehicles.front().mission = std::make_shared<const std::vector<vehicle::MissionItem>>(items);
        snapshot.time = 2;
        m_station->show(snapshot);
        // Two legs of 0.001 degrees on the sphere of the projection; item 0 is home.
        const auto *profile = find<QWidget>("profileView");
        EVENTUALLY(profile->isVisible());
        QVERIFY2(profile->accessibleDescription().contains(QStringLiteral("highest 48.5\u00a0m above home")),
                 qPrintable(profile->accessibleDescription()));
        QVERIFY2(profile->accessibleDescription().startsWith(QStringLiteral("223\u00a0m")),
                 qPrintable(profile->accessibleDescription()));
        items[2].altitude = 60;
        snapshot.vehicles.front().mission = std::make_shared<const std::vector<vehicle::MissionItem>>(items);
        snapshot.time = 3;
        m_station->show(snapshot);
        EVENTUALLY(profile->accessibleDescription().contains(QStringLiteral("highest 60.0\u00a0m")));
    }

    /// A dock alone has its name above it; of several behind each other, each tab has it.
    void noTitleRepeatsItsTab()
    {
        QVERIFY(hasTitle("dockFlight"));
        press(2);
        EVENTUALLY(isInFront("dockParameters") && isInFront("dockMessages"));
        QVERIFY(!hasTitle("dockParameters") && !hasTitle("dockMessages"));
        find<QDockWidget>("dockInspector")->close();
        EVENTUALLY(hasTitle("dockParameters"));
        find<QAction>("view_dockInspector")->trigger();
        EVENTUALLY(isInFront("dockInspector"));
        EVENTUALLY(!hasTitle("dockInspector"));
    }

    void countersHaveTheirRoomFromTheStart()
    {
        m_window->resize(800, 700); // the width is shared out before anything is sealed
        press(3);
        QCoreApplication::processEvents();
        m_station->show(sealedSnapshot(1));
        const auto *scroll = find<QDockWidget>("dockSecure")->findChild<QScrollArea *>();
        EVENTUALLY(m_window->findChild<QWidget *>(QStringLiteral("counter_1_2"))->isVisible());
        EVENTUALLY2(scroll->widget()->width() <= scroll->viewport()->width(),
                    qPrintable(QStringLiteral("%1 in %2").arg(scroll->widget()->width()).arg(scroll->viewport()->width())));
    }

    void eachFitsTheSmallestWindow()
    {
        m_window->resize(1024, 700);
        for (std::size_t i = 0; i < kWorkspaces; ++i) {
            press(i);
            QCoreApplication::processEvents();
            QVERIFY2(m_window->width() <= 1024 && m_window->height() <= 700, workspaceTable()[i].id);
        }
    }

private:
    void press(std::size_t workspace)
    {
        QTest::keyClick(m_window.get(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(workspace)), Qt::ControlModifier);
    }

    bool isInFront(const char *dock) const { return !find<QDockWidget>(dock)->visibleRegion().isEmpty(); }

    /// Whether something is written above the panel, left of the buttons.
    bool hasTitle(const char *id) const
    {
        constexpr int kFrame = 4;
        auto *dock = find<QDockWidget>(id);
        const QRect bar(kFrame, kFrame, dock->width() / 2, dock->widget()->y() - 2 * kFrame);
        const QImage picture = dock->grab(bar).toImage();
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (picture.pixel(x, y) != picture.pixel(0, y))
                    return true;
        return false;
    }

    /// Docks that are open, in front of their tabs or behind; in the order of the table.
    QStringList shownDocks() const
    {
        QStringList shown;
        for (const PanelRow &panel : panelTable())
            if (!find<QDockWidget>(panel.id)->isHidden())
                shown << QLatin1String(panel.id);
        return shown;
    }

    static QStringList placedDocks(std::size_t workspace)
    {
        QStringList placed;
        for (const PanelRow &panel : panelTable())
            if (panel.places[workspace] != Qt::NoDockWidgetArea)
                placed << QLatin1String(panel.id);
        return placed;
    }
};

SKYSEAL_TEST_WIDGETS(WorkspacesTest)
#include "workspaces_test.moc"
