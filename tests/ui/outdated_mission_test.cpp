// A mission that another station changed: the panel and the map say so, and nothing is written over it unasked.
#include "map_rig.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "core/vehicle/reasons.h"
#include "scripted_snapshots.h"
#include "ui/flight/hold_button.h"
#include "ui/mission/mission_panel.h"

#include <QtTest/QTest>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class OutdatedMissionTest : public QObject, private MapRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void panelSaysSoAndReadsItAgain()
    {
        auto *dock = find<QDockWidget>("dockMission");
        dock->show();
        dock->raise();
        const auto *text = find<QLabel>("missionOutdated");
        auto *again = find<QPushButton>("missionReadAgain");
        read();
        QVERIFY(!text->isVisible() && !again->isVisible());
        QVERIFY(!m_map->content().isRouteOutdated());
        change();
        EVENTUALLY(text->isVisible() && again->isVisible());
        QCOMPARE(text->text(), QStringLiteral("Mission outdated: changed by another station"));
        QVERIFY(m_map->content().isRouteOutdated());
        QTest::mouseClick(again, Qt::LeftButton);
        QCOMPARE(m_station->requests.size(), std::size_t(1));
        QVERIFY(std::holds_alternative<vehicle::ReadMission>(m_station->requests.front()));
        read();
        QVERIFY(!text->isVisible() && !again->isVisible());
        QVERIFY(!m_map->content().isRouteOutdated());
    }

    void outdatedListsAreNamed()
    {
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.vehicles.front().fence = snapshot.vehicles.front().rally = itemsOf(2);
        snapshot.vehicles.front().fenceOutdated = "changed by another station";
        snapshot.vehicles.front().rallyOutdated = "a transfer to the vehicle was not completed";
        m_station->show(snapshot);
        QCOMPARE(find<QLabel>("missionOutdated")->text(),
                 QStringLiteral("Fence outdated: changed by another station\n"
                                "Rally points outdated: a transfer to the vehicle was not completed"));
    }

    void nothingIsAddedToIt()
    {
        read();
        choose(openMenu(m_map->rect().center()), "mapAddWaypoint");
        auto *go = find<HoldButton>("addWaypointDialogGo");
        change(); // while the dialog is open
        QTest::mousePress(go, Qt::LeftButton);
        EVENTUALLY2(find<QLabel>("commandResult")->text().contains(QStringLiteral("the mission is outdated")),
                    qPrintable(find<QLabel>("commandResult")->text()));
        QVERIFY(m_station->missionWrites.empty());
    }

    void menuDoesNotOfferToAddToIt()
    {
        read();
        change();
        QMenu *menu = openMenu(m_map->rect().center());
        const auto *entry = menu->findChild<QAction *>(QStringLiteral("mapAddWaypoint"));
        QVERIFY(!entry->isEnabled());
        QVERIFY2(entry->toolTip().contains(QStringLiteral("changed by another station")), qPrintable(entry->toolTip()));
        menu->close();
    }

    /// What is added names the mission that it was made from, so that the station sends it over no other one.
    void whatIsAddedNamesItsBasis()
    {
        read();
        choose(openMenu(m_map->rect().center()), "mapAddWaypoint");
        QTest::mousePress(find<HoldButton>("addWaypointDialogGo"), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->requests.size(), std::size_t(1));
        const auto &write = std::get<vehicle::WriteMission>(m_station->requests.front());
        QVERIFY(write.basis == m_mission && !write.overwrite);
    }

    void fileReplacesItOnceConfirmed()
    {
        auto *panel = m_window->findChild<MissionPanel *>();
        change(); // without having been read
        show([](auto &state) { state.armed = false; });
        const auto ask = [&] {
            panel->sendFile(missionFile(), 1);
            return m_window->findChild<QMessageBox *>(QStringLiteral("confirmSendMission"));
        };
        QMessageBox *box = ask();
        QVERIFY(box);
        QCOMPARE(box->text(), QStringLiteral("Replace the mission of another station?"));
        QVERIFY2(box->informativeText().contains(QStringLiteral("changed by another station")),
                 qPrintable(box->informativeText()));
        QTest::keyClick(box, Qt::Key_Escape);
        EVENTUALLY(!m_window->findChild<QMessageBox *>(QStringLiteral("confirmSendMission")));
        QVERIFY(m_station->requests.empty());
        QTest::mouseClick(ask()->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_station->requests.size(), std::size_t(1));
        QVERIFY(std::get<vehicle::WriteMission>(m_station->requests.front()).overwrite);

        // An upload of this station that failed may be repeated.
        m_missionOutdated = Reason(vehicle::reasons::kPlanIncomplete);
        show([](auto &state) { state.armed = false; });
        panel->sendFile(missionFile(), 1);
        QCOMPARE(m_station->requests.size(), std::size_t(2));
        QVERIFY(!std::get<vehicle::WriteMission>(m_station->requests.back()).overwrite);
    }

private:
    static vehicle::MissionItems itemsOf(std::size_t count)
    {
        std::vector<vehicle::MissionItem> items(count);
        for (std::size_t i = 0; i < count; ++i) {
            items[i].sequence = static_cast<std::uint16_t>(i);
            items[i].latitude = 47.3977;
            items[i].longitude = 8.5456;
        }
        return std::make_shared<const std::vector<vehicle::MissionItem>>(std::move(items));
    }
    void read()
    {
        m_mission = itemsOf(3);
        m_missionOutdated = {};
        show();
    }
    void change()
    {
        m_missionOutdated = Reason(vehicle::reasons::kPlanChanged);
        show();
    }
    QString missionFile() const
    {
        const QString name = m_folder->filePath(QStringLiteral("other.waypoints"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly))
            qFatal("%s cannot be written", qPrintable(name));
        file.write("QGC WPL 110\n"
                   "0\t1\t0\t16\t0\t0\t0\t0\t47.39\t8.54\t488\t1\n"
                   "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t15\t1\n");
        return name;
    }
};

SKYSEAL_TEST_WIDGETS(OutdatedMissionTest)
#include "outdated_mission_test.moc"
