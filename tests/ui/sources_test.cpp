// Where the picture comes from: the live link, a replay beside it, or the demo in its place; and what asks before an armed
// vehicle loses its station.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/flight/hold_button.h"
#include "ui/map/map_view.h"
#include "ui/messages/messages_panel.h"
#include "ui/status/strip_item.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

#include <algorithm>

using namespace skyseal;
using namespace skyseal::ui;

class SourcesTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUpWithDemo(); }
    void cleanup() { tearDown(); }

    void demoIsRefusedWhileAVehicleIsThere()
    {
        openTools();
        QVERIFY(find<QAction>("actionDemo")->isEnabled());
        closeTools();
        m_station->show(sealedSnapshot(1));
        openTools();
        const QAction *demo = find<QAction>("actionDemo");
        QVERIFY(!demo->isEnabled());
        QVERIFY(demo->toolTip().contains(QStringLiteral("vehicle")));
        closeTools();
    }

    /// The button over the map stays while an agent without an autopilot is connected.
    void demoIsRefusedWhileALinkIsSealed()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.clear();
        m_station->show(snapshot);
        auto *button = find<QPushButton>("demoButton");
        QVERIFY(button->isVisible());
        QSignalSpy requested(m_window.get(), &MainWindow::demoRequested);
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(requested.isEmpty());
        QVERIFY(!button->toolTip().isEmpty());
    }

    void demoIsMarkedAndCanBeEnded()
    {
        const auto *bar = find<QWidget>("sourceBar");
        QVERIFY(!bar->isVisible());
        m_window->setDemo(true);
        QVERIFY(bar->isVisible());
        QVERIFY(bar->width() >= m_window->width() - 32); // across the window
        QVERIFY(find<QLabel>("sourceTitle")->text().startsWith(QStringLiteral("DEMO: a simulated copter takes off")));
        QVERIFY(find<QLabel>("sourceTitle")->toolTip().contains(QStringLiteral("End the demo")));
        QSignalSpy ended(m_window.get(), &MainWindow::demoEndRequested);
        QTest::mouseClick(find<QPushButton>("sourceEnd"), Qt::LeftButton);
        QCOMPARE(ended.size(), 1);
        openTools();
        QVERIFY(!find<QAction>("actionDemo")->isEnabled() && find<QAction>("actionEndDemo")->isEnabled());
        closeTools();
        m_window->setDemo(false);
        QVERIFY(!bar->isVisible());
    }

    void replayTakesThePictureUntilBackToLive()
    {
        m_station->show(sealedSnapshot(1));
        QVERIFY(find<StripItem>("stripLock")->text().contains(QStringLiteral("ChaCha20")));
        m_window->addLink(QStringLiteral("tlog:/logs/own flight.tlog"));
        QCOMPARE(m_station->replays.size(), std::size_t(1));
        QVERIFY(m_station->addedLinks.empty());
        m_station->showReplay(recorded(7));
        QVERIFY(find<QWidget>("sourceBar")->isVisible());
        QVERIFY(find<QLabel>("sourceTitle")->text().contains(QStringLiteral("own flight.tlog")));
        QCOMPARE(m_window->view().vehicle->state.mode, std::string("AUTO"));
        QCOMPARE(find<StripItem>("stripMode")->text(), QStringLiteral("AUTO"));
        m_station->show(sealedSnapshot(2)); // the live link goes on, and the picture stays
        QCOMPARE(m_window->view().vehicle->state.mode, std::string("AUTO"));
        QVERIFY(find<QLabel>("sourceLive")->text().contains(QStringLiteral("ARMED")));
        QTest::mouseClick(find<QPushButton>("sourceEnd"), Qt::LeftButton);
        QCOMPARE(m_station->replaysEnded, 1);
        QVERIFY(!find<QWidget>("sourceBar")->isVisible());
        QVERIFY(m_window->view().vehicle->state.mode != "AUTO");
        m_station->showReplay(recorded(8)); // was on its way
        QVERIFY(m_window->view().vehicle->state.mode != "AUTO");
    }

    void nothingIsSentToARecordedVehicle()
    {
        m_station->show(sealedSnapshot(1));
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        m_station->showReplay(recorded(7));
        auto *land = find<HoldButton>("landButton");
        QVERIFY(!land->isEnabled());
        QVERIFY(land->toolTip().contains(QStringLiteral("replay")));
        QTest::mouseClick(find<QPushButton>("sourceEnd"), Qt::LeftButton);
        QVERIFY(land->isEnabled());
    }

    void liveAlarmsShowDuringAReplay()
    {
        m_station->show(sealedSnapshot(1));
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        m_station->showReplay(recorded(7));
        engine::Snapshot lost = sealedSnapshot(3);
        lost.vehicles.front().state.messageAge = 12;
        m_station->show(lost);
        const QString said = find<QLabel>("sourceLive")->text();
        QVERIFY2(said.contains(QStringLiteral("▲")) && said.contains(QStringLiteral("00:12")), qPrintable(said));
        m_station->notify(engine::VehicleLost{1});
        m_station->notifyReplay(engine::VehicleLost{1});
        MessageModel &messages = m_window->findChild<MessagesPanel *>()->model();
        QCOMPARE(messages.rowCount(), 2);
        QVERIFY(!text(messages, 0).startsWith(QStringLiteral("Replay")));
        QVERIFY(text(messages, 1).startsWith(QStringLiteral("Replay")));
    }

    void tracksOfReplayAndLiveAreNotJoined()
    {
        for (double t = 0; t < 10; t += 0.5)
            m_station->show(sealedSnapshot(t));
        const Track &track = find<MapView>("map")->content().track();
        QVERIFY(track.points().size() > 3);
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        m_station->showReplay(recorded(7));
        QCOMPARE(track.points().size(), std::size_t(1));
    }

    void liveTrackIsThereAfterAReplay()
    {
        for (double t = 0; t < 10; t += 0.5)
            m_station->show(sealedSnapshot(t));
        const auto *map = find<MapView>("map");
        const std::size_t before = map->content().track().points().size();
        const QPointF first = map->content().track().points().front().metres;
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        m_station->showReplay(recorded(7));
        m_window->startReplay(QStringLiteral("tlog:/logs/another.tlog"));
        m_station->showReplay(recorded(8));
        for (double t = 10; t < 20; t += 0.5)
            m_station->show(sealedSnapshot(t));
        QCOMPARE(map->content().track().points().size(), std::size_t(1)); // of the replay
        QTest::mouseClick(find<QPushButton>("sourceEnd"), Qt::LeftButton);
        const auto &points = map->content().track().points();
        QVERIFY(points.size() > before + 3);
        QCOMPARE(points.front().metres, first);
        QCOMPARE(std::ranges::count_if(points, &TrackPoint::begins),
                 std::ptrdiff_t(1)); // what was flown during the replay belongs to it
        const QPointF at = map->viewport().toPixels(*map->content().vehicle());
        QVERIFY(QRectF(map->rect()).contains(at));
    }

    void panelsHaveTheirHeightsAfterAReplay()
    {
        m_window->resize(1366, 768);
        find<QAction>("workspace_lab")->trigger();
        find<QAction>("actionResetView")->trigger();
        m_station->show(sealedSnapshot(1));
        auto *dock = find<QDockWidget>("dockDiagnostics");
        EVENTUALLY(dock->isVisible());
        m_window->resizeDocks({dock}, {700}, Qt::Vertical); // until the map has its least height
        QCoreApplication::processEvents();
        const int before = dock->height();
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        m_station->showReplay(recorded(7));
        EVENTUALLY(dock->height() < before);
        QTest::mouseClick(find<QPushButton>("sourceEnd"), Qt::LeftButton);
        EVENTUALLY_EQUAL(dock->height(), before);
    }

    /// A jump to another time shows the way that led there.
    void seekShowsTheTrackUpToThere()
    {
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        engine::Snapshot picture = recorded(7);
        picture.replay.emplace().position = std::chrono::seconds(7);
        m_station->showReplay(picture);
        const auto *map = find<MapView>("map");
        QCOMPARE(map->content().track().points().size(), std::size_t(1));

        engine::FlownTracks ways;
        const vehicle::Position end = recorded(90).vehicles.front().state.position;
        for (int i = 0; i <= 40; ++i) {
            if (i == 20)
                ways.interrupt(1);
            ways.note(1,
                      {.at = std::chrono::seconds(50 + i),
                       .latitude = end.latitude - (40 - i) * 5e-5,
                       .longitude = end.longitude,
                       .quality = 98,
                       .altitude = float(i)});
        }
        picture = recorded(90);
        picture.replay.emplace().position = std::chrono::seconds(90);
        picture.replay->seeks = 1;
        picture.replay->seeking = true; // the picture of before
        m_station->showReplay(picture);
        picture.replay->seeking = false;
        const auto flown = std::make_shared<const engine::FlownTracks>(ways);
        picture.replay->flown = flown;
        m_station->showReplay(picture);
        const auto &points = map->content().track().points();
        QCOMPARE(points.size(), std::size_t(41));
        for (std::size_t i = 0; i < points.size(); ++i)
            QCOMPARE(points[i].begins, i == 0 || i == 20);
        QCOMPARE(points[40].values.altitude, 40.f);

        picture = recorded(91); // it goes on from there
        picture.vehicles.front().state.position = {end.latitude + 5e-5, end.longitude, end.altitude};
        picture.replay.emplace().position = std::chrono::seconds(91);
        picture.replay->seeks = 1;
        picture.replay->flown = flown;
        m_station->showReplay(picture);
        QCOMPARE(map->content().track().points().size(), std::size_t(42));
        QVERIFY(!map->content().track().points().back().begins);
    }

    void linksOfAReplayAreThoseOfTheStation()
    {
        m_station->show(sealedSnapshot(1));
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        m_station->showReplay(recorded(7));
        const auto *view = find<QTreeView>("linkView");
        QVERIFY(view->model()->rowCount() > 0);
        QVERIFY(!view->model()->index(0, 0).data().toString().startsWith(QStringLiteral("tlog")));
    }

    void chartsMeasureTheLiveLinkDuringAReplay()
    {
        engine::Snapshot live = sealedSnapshot(1);
        live.samples = samplesOf(0, 0, 2, crypto::SuiteId::ChaCha20Poly1305, 0);
        m_station->show(live);
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        engine::Snapshot old = recorded(7);
        old.samples = samplesOf(900, 0, 2, crypto::SuiteId::None, 0);
        m_station->showReplay(old);
        const auto &charted = m_window->findChild<DiagnosticsPanel *>()->history().samples();
        QCOMPARE(charted.back().number, live.samples.back().number);
    }

    void quittingAsksWhileAVehicleIsArmed()
    {
        m_station->show(sealedSnapshot(1)); // armed
        QTest::keyClick(m_window.get(), Qt::Key_Q, Qt::ControlModifier);
        EVENTUALLY(m_window->findChild<QMessageBox *>(QStringLiteral("confirmQuit")));
        QVERIFY(m_window->isVisible());
        const auto *box = find<QMessageBox>("confirmQuit");
        QFont bold = box->font();
        bold.setBold(true);
        const int title = QFontMetrics(bold).horizontalAdvance(box->windowTitle());
        QVERIFY(box->width() >= title + 120); // beside the icon and the buttons of a frame
        QTest::keyClick(find<QMessageBox>("confirmQuit"), Qt::Key_Escape);
        EVENTUALLY(!m_window->findChild<QMessageBox *>(QStringLiteral("confirmQuit")));
        QVERIFY(m_window->isVisible());
        m_window->close(); // by its frame
        QVERIFY(m_window->isVisible());
        QTest::mouseClick(find<QMessageBox>("confirmQuit")->button(QMessageBox::Yes), Qt::LeftButton);
        EVENTUALLY(!m_window->isVisible());
    }

    void quittingDoesNotAskOtherwise()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.front().state.armed = false;
        m_station->show(snapshot);
        QTest::keyClick(m_window.get(), Qt::Key_Q, Qt::ControlModifier);
        EVENTUALLY(!m_window->isVisible());
    }

    /// A replay hides the live vehicle, which counts all the same.
    void quittingAsksDuringAReplay()
    {
        m_station->show(sealedSnapshot(1));
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        engine::Snapshot old = recorded(7);
        old.vehicles.front().state.armed = false;
        m_station->showReplay(old);
        m_window->close();
        QVERIFY(m_window->isVisible());
        QVERIFY(m_window->findChild<QMessageBox *>(QStringLiteral("confirmQuit")));
    }

    void removingTheLinkOfAnArmedVehicleAsks()
    {
        m_station->show(sealedSnapshot(1));
        find<QAction>("view_dockLinks")->trigger();
        auto *view = find<QTreeView>("linkView");
        view->setCurrentIndex(view->model()->index(0, 0));
        QTest::mouseClick(find<QPushButton>("linkRemove"), Qt::LeftButton);
        QVERIFY(m_station->removedLinks.empty());
        QTest::mouseClick(find<QMessageBox>("confirmRemoveLink")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_station->removedLinks.size(), std::size_t(1));
    }

private:
    /// What a recording of this vehicle shows.
    static engine::Snapshot recorded(double time)
    {
        engine::Snapshot out = sealedSnapshot(time);
        out.sessions.clear();
        out.vehicles.front().session.reset();
        enterMode(out.vehicles.front().state, "AUTO");
        out.links.front().url = "tlog:/logs/own.tlog";
        out.links.front().recording = true;
        return out;
    }
    static QString text(const MessageModel &messages, int row)
    {
        return messages.index(row, MessageModel::Text).data().toString();
    }
    void openTools()
    {
        auto *menu = find<QMenu>("menuTools");
        QTest::mouseClick(m_window->menuBar(), Qt::LeftButton, {},
                          m_window->menuBar()->actionGeometry(menu->menuAction()).center());
        EVENTUALLY(menu->isVisible());
    }
    void closeTools()
    {
        auto *menu = find<QMenu>("menuTools");
        QTest::keyClick(menu, Qt::Key_Escape);
        EVENTUALLY(!menu->isVisible());
    }
};

SKYSEAL_TEST_WIDGETS(SourcesTest)
#include "sources_test.moc"
