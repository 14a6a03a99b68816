// The docks below the map: the messages follow the newest one, the diagnostics are enlarged only for a sweep, an empty mission
// says why, and a mission that cannot be saved leaves the old file.
#include "core/mavlink/enums.h"
#include "fake_sweep.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/test_runner.h"
#include "ui/mission/mission_panel.h"
#include "ui/sweep/sweep_dialog.h"
#include "window_rig.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class BottomDocksTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void emptyListsSayWhatWillBeThere()
    {
        const auto shown = [this](const char *name) {
            const auto *label = find<QLabel>(name);
            return label->isVisibleTo(label->parentWidget()) && !label->text().isEmpty();
        };
        for (const char *name : {"parameterEmpty", "inspectorEmpty", "messagesEmpty", "linksEmpty"})
            QVERIFY2(shown(name), name);
        bringToFront("dockMessages");
        EVENTUALLY_EQUAL(find<QLabel>("messagesEmpty")->geometry(), find<QTreeView>("messageView")->viewport()->geometry());
        say(1);
        m_station->show(sealedSnapshot(1));
        for (const char *name : {"parameterEmpty", "messagesEmpty", "linksEmpty"})
            QVERIFY2(!shown(name), name);
    }

    void filterThatHidesEverythingSaysSo_data()
    {
        QTest::addColumn<QByteArray>("dock");
        QTest::addColumn<QByteArray>("filter");
        QTest::addColumn<QByteArray>("list");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char *dock, const char *filter, const char *list, const char *text) {
            QTest::newRow(dock) << QByteArray(dock) << QByteArray(filter) << QByteArray(list) << QByteArray(text);
        };
        row("dockMessages", "messageFilter", "messageView", "messagesEmpty");
        row("dockParameters", "parameterFilter", "parameterView", "parameterEmpty");
        row("dockInspector", "inspectorFilter", "inspectorList", "inspectorEmpty");
    }
    void filterThatHidesEverythingSaysSo()
    {
        QFETCH(QByteArray, dock);
        QFETCH(QByteArray, filter);
        QFETCH(QByteArray, list);
        QFETCH(QByteArray, text);
        find<QAction>(("view_" + dock).constData())->trigger();
        EVENTUALLY(!isBehind(dock.constData()));
        say(3);
        double time = 0;
        const auto *rows = find<QTreeView>(list.constData())->model();
        const auto arrived = [&] {
            m_station->show(sealedSnapshot(++time));
            return rows->rowCount() > 0;
        };
        EVENTUALLY(arrived());
        const auto *said = find<QLabel>(text.constData());
        QVERIFY(!said->isVisible());
        auto *typed = find<QLineEdit>(filter.constData());
        QTest::keyClicks(typed, QStringLiteral("zzz"));
        EVENTUALLY(said->isVisible());
        QCOMPARE(rows->rowCount(), 0);
        QCOMPARE(said->text(), QStringLiteral("Nothing matches the filter."));
        typed->clear();
        QVERIFY(!said->isVisible());
        QVERIFY(rows->rowCount() > 0);
    }

    /// The fields of a message beside the list of the types.
    void inspectorSaysHowToSeeFields()
    {
        const auto *said = find<QLabel>("fieldsEmpty");
        QVERIFY(said->isVisibleTo(said->parentWidget()));
        find<QAction>("view_dockInspector")->trigger();
        EVENTUALLY(!isBehind("dockInspector"));
        auto *list = find<QTreeView>("inspectorList");
        double time = 0;
        const auto arrived = [&] {
            m_station->show(sealedSnapshot(++time));
            return list->model()->rowCount() > 0;
        };
        EVENTUALLY(arrived());
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Home);
        EVENTUALLY(!said->isVisibleTo(said->parentWidget()));
    }

    void messagesFollowTheNewest()
    {
        EVENTUALLY(isBehind("dockMessages"));
        say(100);
        bringToFront("dockMessages");
        EVENTUALLY(showsNewest());
        say(50);
        EVENTUALLY(showsNewest());
        // A smaller view has a longer range.
        auto *dock = find<QDockWidget>("dockMessages");
        const int before = dock->height();
        m_window->resizeDocks({dock}, {before - 40}, Qt::Vertical);
        EVENTUALLY(dock->height() < before);
        EVENTUALLY(showsNewest());
        say(1);
        EVENTUALLY(showsNewest());
    }

    void messagesStayWhereTheOperatorScrolledTo()
    {
        auto *view = find<QTreeView>("messageView");
        bringToFront("dockMessages");
        say(100);
        EVENTUALLY(showsNewest());
        QTest::keyClick(view, Qt::Key_Home);
        EVENTUALLY(view->verticalScrollBar()->value() == 0);
        say(10);
        QCoreApplication::processEvents();
        QCOMPARE(view->verticalScrollBar()->value(), 0);
        view->verticalScrollBar()->setValue(view->verticalScrollBar()->maximum());
        say(10);
        EVENTUALLY(showsNewest());
    }

    void sweepEnlargesTheDiagnosticsForItsTime()
    {
        FakeSweep sweeps;
        m_window->setSweep(sweeps);
        m_station->show(sealedSnapshot(1));
        const auto *dock = find<QDockWidget>("dockDiagnostics");
        const int before = dock->height();
        runSweep(sweeps);
        EVENTUALLY(dock->height() > before + 50);
        const int grown = dock->height();
        auto *choice = find<QComboBox>("chartView");
        const int sweepPage = choice->currentIndex();
        choosePage(0);
        EVENTUALLY_EQUAL(dock->height(), before);
        choosePage(sweepPage); // the results need the room again
        EVENTUALLY_EQUAL(dock->height(), grown);
        m_window->close();
        open();
        EVENTUALLY_EQUAL(find<QDockWidget>("dockDiagnostics")->height(), before);
    }

    void sweepNamesItsInvalidRuns()
    {
        FakeSweep sweeps;
        m_window->setSweep(sweeps);
        m_station->show(sealedSnapshot(1));
        std::vector<experiment::Sample> samples(3);
        samples[1].invalid = "not saturated: nothing reached 95 %";
        runSweep(sweeps, std::move(samples));
        const QString shown = find<QLabel>("sweepStatus")->text();
        QVERIFY2(shown.contains(QStringLiteral("1 not valid: not saturated")), qPrintable(shown));
    }

    void missionIsSavedAsAWhole()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("saved.waypoints"));
        auto *panel = m_window->findChild<MissionPanel *>();
        QVERIFY(panel);
        const auto save = [&](std::size_t items) {
            panel->saveFile(path, std::make_shared<const std::vector<vehicle::MissionItem>>(items));
        };
        const auto lines = [&path] {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll().count('\n') : qsizetype(-1);
        };
        save(2);
        QCOMPARE(lines(), qsizetype(3)); // with its head
        {
            const test::FileSizeLimit limit(10);
            save(5);
        }
        QVERIFY2(find<QLabel>("missionResult")->text().contains(QStringLiteral("cannot be written: File too large")),
                 qPrintable(find<QLabel>("missionResult")->text()));
        QCOMPARE(lines(), qsizetype(3));
        save(5);
        QCOMPARE(lines(), qsizetype(6));
    }

    void missionPanelShowsWhyItIsEmpty()
    {
        const auto *why = find<QLabel>("missionEmpty");
        bringToFront("dockMission");
        QVERIFY(why->text().startsWith(QStringLiteral("No vehicle. Its mission is listed here")));
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().mission = nullptr;
        m_station->show(snapshot);
        QVERIFY2(why->text().contains(QStringLiteral("not been read")), qPrintable(why->text()));
        ++snapshot.time;
        snapshot.vehicles.front().mission = std::make_shared<const std::vector<vehicle::MissionItem>>();
        m_station->show(snapshot);
        QVERIFY2(why->text().contains(QStringLiteral("has no mission")), qPrintable(why->text()));
        ++snapshot.time;
        snapshot.vehicles.front().mission = std::make_shared<const std::vector<vehicle::MissionItem>>(2);
        m_station->show(snapshot);
        QVERIFY(!why->isVisible());
        QCOMPARE(find<QTreeView>("missionView")->model()->rowCount(), 2);
    }

private:
    void say(int count)
    {
        for (int i = 0; i < count; ++i) {
            vehicle::TextReceived text;
            text.systemId = 1;
            text.text.severity = mavlink::MAV_SEVERITY_WARNING;
            text.text.text = "warning " + std::to_string(++m_said);
            m_station->notify(text);
        }
    }
    bool showsNewest() const
    {
        const auto *view = find<QTreeView>("messageView");
        const QModelIndex last = view->model()->index(view->model()->rowCount() - 1, 3);
        return last.data().toString() == QStringLiteral("warning %1").arg(m_said)
            && view->viewport()->rect().contains(view->visualRect(last).center());
    }
    bool isBehind(const char *dock) const { return find<QDockWidget>(dock)->visibleRegion().isEmpty(); }
    void bringToFront(const char *dock)
    {
        EVENTUALLY(isBehind(dock)); // the action hides a dock that is in front
        find<QAction>((QByteArray("view_") + dock).constData())->trigger();
        EVENTUALLY(!isBehind(dock));
    }
    void choosePage(int index)
    {
        auto *choice = find<QComboBox>("chartView");
        choice->setFocus();
        const Qt::Key key = index < choice->currentIndex() ? Qt::Key_Up : Qt::Key_Down;
        while (choice->currentIndex() != index)
            QTest::keyClick(choice, key);
    }
    void runSweep(FakeSweep &sweeps, std::vector<experiment::Sample> samples = {})
    {
        find<QAction>("actionSweep")->trigger();
        auto *dialog = m_window->findChild<SweepDialog *>();
        QVERIFY(dialog);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        if (const auto *armed = m_window->findChild<QMessageBox *>(QStringLiteral("confirmSweep")))
            QTest::mouseClick(armed->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(sweeps.orders.size(), std::size_t(1));
        sweeps.finish(std::move(samples));
    }

    int m_said = 0;
};

SKYSEAL_TEST_WIDGETS(BottomDocksTest)
#include "bottom_docks_test.moc"
