// The switch of the links panel that serves other ground stations, by mouse and keys.
#include "window_rig.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/state_text.h"
#include "ui/status/strip_item.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTimer>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class GatewaySectionTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        reveal();
    }
    void cleanup() { tearDown(); }

    void servesNobodyUntilAsked()
    {
        m_station->show(sealed(false));
        QVERIFY(!find<QCheckBox>("serveOn")->isChecked());
        QVERIFY(m_station->served.empty());
        QCOMPARE(find<QLabel>("serveState")->text(), QStringLiteral("off"));
        QVERIFY(!find<QTreeView>("serveClients")->isVisible());
    }

    void readOnlyOnThisComputerAtFirst()
    {
        QTest::keyClick(find<QCheckBox>("serveOn"), Qt::Key_Space);
        QCOMPARE(m_station->served.size(), std::size_t(1));
        const engine::ServeConfig &config = m_station->served.front();
        QCOMPARE(config.url.toText(), std::string("tcpin:127.0.0.1:5790"));
        QVERIFY(!config.write.any());
        QVERIFY(!config.isOpenToOthers());
        QTest::keyClick(find<QCheckBox>("serveOn"), Qt::Key_Space);
        QVERIFY(m_station->served.empty());
        QCOMPARE(find<QLabel>("serveState")->text(), QStringLiteral("off"));
    }

    void isKept()
    {
        type("udpin:127.0.0.1:14600");
        chooseRights(1);
        QVERIFY(m_station->served.empty()); // not switched on
        find<QCheckBox>("serveOn")->click();
        m_station->served.clear();
        open();
        reveal();
        QCOMPARE(m_station->served.size(), std::size_t(1));
        QCOMPARE(m_station->served.front().url.toText(), std::string("udpin:127.0.0.1:14600"));
        QCOMPARE(m_station->served.front().write, engine::WriteRights::all());
        QVERIFY(find<QCheckBox>("serveOn")->isChecked());
        QCOMPARE(find<QComboBox>("serveUrl")->currentText(), QStringLiteral("udpin:127.0.0.1:14600"));
        QCOMPARE(find<QComboBox>("serveRights")->currentIndex(), 1);
    }

    /// Beside the choice at once, and in the strip while others may write.
    void writeRightsAreSaid()
    {
        const auto *warning = find<QLabel>("serveWarning");
        auto *sign = find<StripItem>("stripSharing");
        QVERIFY(!warning->isVisible() && !sign->isVisible());
        chooseRights(1);
        QVERIFY(warning->isVisible());
        QVERIFY2(warning->text().contains(QStringLiteral("arm, fly and stop the vehicles")), qPrintable(warning->text()));
        QVERIFY(!sign->isVisible()); // not switched on
        find<QCheckBox>("serveOn")->click();
        QVERIFY(sign->isVisible());
        QCOMPARE(sign->text(), QStringLiteral("Others may command"));
        QVERIFY2(sign->toolTip().contains(QStringLiteral("arm, fly and stop the vehicles")), qPrintable(sign->toolTip()));
        for (const char *workspace : {"workspace_plan", "workspace_vehicle", "workspace_lab", "workspace_fly"}) {
            find<QAction>(workspace)->trigger();
            QVERIFY(sign->isVisible());
            QVERIFY(sign->width() >= sign->sizeHint().width());
        }
        find<QDockWidget>("dockLinks")->hide();
        QVERIFY(!find<QCheckBox>("serveOn")->isVisible());
        QTest::mouseClick(sign, Qt::LeftButton);
        QVERIFY(find<QCheckBox>("serveOn")->isVisible());

        type("tcpin:127.0.0.1:5790,write=mission,param");
        QCOMPARE(sign->text(), QStringLiteral("Others may write"));
        QVERIFY(!warning->text().contains(QStringLiteral("arm")) && warning->text().contains(QStringLiteral("missions")));
        type("tcpin:127.0.0.1:5790,write=none");
        QVERIFY(!sign->isVisible() && !warning->isVisible());
        type("tcpin:127.0.0.1:99999"); // invalid: nobody is served
        QVERIFY(!sign->isVisible());
        type("tcpin:127.0.0.1:5790");
        QVERIFY(sign->isVisible());
        find<QCheckBox>("serveOn")->click();
        QVERIFY(!sign->isVisible());
    }

    void addressNeverWidensTheRights()
    {
        type("tcpin:127.0.0.1:5790,write=mission,param");
        find<QCheckBox>("serveOn")->click();
        QVERIFY(!m_station->served.front().write.any()); // "Read only" is chosen
        chooseRights(1);
        const engine::WriteRights &write = m_station->served.front().write;
        QVERIFY(write.any() && !(write == engine::WriteRights::all()));
        type("tcpin:127.0.0.1:5790");
        QCOMPARE(m_station->served.front().write, engine::WriteRights::all());
    }

    void classesAreTickedInAMenu()
    {
        auto *button = find<QToolButton>("serveClasses");
        QVERIFY(!button->accessibleName().isEmpty());
        QVERIFY(!button->isEnabled()); // "Read only" is chosen
        type("tcpin:127.0.0.1:5790,name=Mission Planner udpin:14551");
        find<QCheckBox>("serveOn")->click();
        chooseRights(1);
        QVERIFY(button->isEnabled());
        QMenu *menu = button->menu();
        const auto at = [menu](const char *name) {
            return menu->actionGeometry(menu->findChild<QAction *>(QLatin1String(name))).center();
        };
        // By keys: opened, everything is cleared, missions are ticked. It stays open until Esc.
        QTimer::singleShot(0, menu, [menu] {
            if (!menu->activeAction())
                QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Space);
            QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Space);
            QVERIFY(menu->isVisible());
            QTest::keyClick(menu, Qt::Key_Escape);
        });
        QTest::keyClick(button, Qt::Key_Space);
        QVERIFY(!menu->isVisible());
        QCOMPARE(find<QComboBox>("serveUrl")->currentText(),
                 QStringLiteral("tcpin:127.0.0.1:5790,name=Mission Planner,write=mission udpin:14551,write=mission"));
        QCOMPARE(m_station->served.size(), std::size_t(2));
        for (const engine::ServeConfig &config : m_station->served)
            QCOMPARE(config.write.toText(), std::string("mission"));
        // By the mouse.
        QTimer::singleShot(0, menu, [menu, at] {
            QVERIFY(!menu->findChild<QAction *>(QLatin1String("serve-all"))->isChecked());
            QVERIFY(menu->findChild<QAction *>(QLatin1String("serve-mission"))->isChecked());
            QTest::mouseClick(menu, Qt::LeftButton, {}, at("serve-param"));
            QTest::mouseClick(menu, Qt::LeftButton, {}, at("serve-rc"));
            QTest::mouseClick(menu, Qt::LeftButton, {}, at("serve-mission"));
            QVERIFY(menu->isVisible());
            QTest::keyClick(menu, Qt::Key_Escape);
        });
        QTest::mouseClick(button, Qt::LeftButton);
        for (const engine::ServeConfig &config : m_station->served)
            QCOMPARE(config.write.toText(), std::string("param,rc"));
        QTimer::singleShot(0, menu, [menu, at] {
            QTest::mouseClick(menu, Qt::LeftButton, {}, at("serve-all"));
            QTest::keyClick(menu, Qt::Key_Escape);
        });
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(m_station->served[0].write, engine::WriteRights::all());
        QCOMPARE(find<QComboBox>("serveUrl")->currentText(),
                 QStringLiteral("tcpin:127.0.0.1:5790,name=Mission Planner udpin:14551"));
    }

    void severalAddressesHaveTheirOwnRights()
    {
        type("tcpin:127.0.0.1:5790,name=Mission Planner,write=all udpout:127.0.0.1:14540,write=mission,rc  udpin:14551 "
             "udpin:14552,write=none");
        find<QCheckBox>("serveOn")->click();
        const std::vector<engine::ServeConfig> &served = m_station->served;
        QCOMPARE(served.size(), std::size_t(4));
        QCOMPARE(served[0].name, std::string("Mission Planner"));
        for (const engine::ServeConfig &config : served)
            QVERIFY(!config.write.any()); // "Read only" is chosen
        chooseRights(1);
        QCOMPARE(served.size(), std::size_t(4));
        QCOMPARE(served[0].write, engine::WriteRights::all());
        QCOMPARE(served[1].write.toText(), std::string("mission,rc"));
        QCOMPARE(served[2].url.toText(), std::string("udpin:127.0.0.1:14551"));
        QCOMPARE(served[2].write, engine::WriteRights::all());
        QVERIFY(!served[3].write.any());
        type("udpin:14551 udpin:99999");
        QVERIFY(served.empty()); // rather nobody than some
        const QString problem = find<QLabel>("serveState")->text();
        QVERIFY2(problem.startsWith(QStringLiteral("udpin:99999: ")), qPrintable(problem));
    }

    void problemOfOneOfSeveralIsShown()
    {
        type("udpin:14551 tcpin:5790");
        find<QCheckBox>("serveOn")->click();
        engine::Snapshot snapshot = sealed(true);
        snapshot.served.push_back(snapshot.served.front());
        snapshot.served[1].phase = engine::LinkPhase::Opening;
        m_station->show(snapshot);
        EVENTUALLY_EQUAL(find<QLabel>("serveState")->text(),
                         engine::linkPhaseText(engine::LinkPhase::Opening) + QStringLiteral("; no station is connected"));
        snapshot.served[1].url = "tcpin:127.0.0.1:5790";
        snapshot.served[1].phase = engine::LinkPhase::Failed;
        snapshot.served[1].problem = "Address already in use";
        snapshot.time += 1;
        m_station->show(snapshot);
        EVENTUALLY_EQUAL(find<QLabel>("serveState")->text(),
                         QStringLiteral("tcpin:127.0.0.1:5790: failed: Address already in use"));
    }

    void invalidUrlServesNobody()
    {
        find<QCheckBox>("serveOn")->click();
        QCOMPARE(m_station->served.size(), std::size_t(1));
        type("tcpin:127.0.0.1:99999");
        QVERIFY(m_station->served.empty());
        const QString problem = find<QLabel>("serveState")->text();
        QVERIFY2(problem.contains(QStringLiteral("99999")), qPrintable(problem));
        type("tcpin:127.0.0.1:5791");
        QCOMPARE(m_station->served.size(), std::size_t(1));
    }

    void problemOfTheLinkIsShown()
    {
        find<QCheckBox>("serveOn")->click();
        engine::Snapshot snapshot = sealed(true);
        snapshot.served.front().phase = engine::LinkPhase::Failed;
        snapshot.served.front().problem = "Address already in use";
        m_station->show(snapshot);
        EVENTUALLY_EQUAL(find<QLabel>("serveState")->text(), QStringLiteral("failed: Address already in use"));
    }

    void clientsAreListed()
    {
        find<QCheckBox>("serveOn")->click();
        engine::Snapshot snapshot = sealed(true);
        m_station->show(snapshot);
        EVENTUALLY(find<QLabel>("serveState")->text() == QStringLiteral("listening; no station is connected"));
        QVERIFY(!find<QTreeView>("serveClients")->isVisible());
        snapshot.clients.push_back({"tcpin:127.0.0.1:5790", "127.0.0.1:50123", "none", {}});
        snapshot.time += 1;
        m_station->show(snapshot);
        EVENTUALLY(find<QLabel>("serveState")->text() == QStringLiteral("listening; one station"));
        QVERIFY(find<QTreeView>("serveClients")->isVisible());
        QCOMPARE(find<QTreeView>("serveClients")->model()->rowCount(), 1);
        find<QCheckBox>("serveOn")->click();
        QVERIFY(!find<QTreeView>("serveClients")->isVisible());
    }

    void openToOtherComputersIsSaid()
    {
        type("tcpin:0.0.0.0:5790");
        find<QCheckBox>("serveOn")->click();
        QVERIFY(m_station->served.front().isOpenToOthers());
        m_station->show(sealed(true));
        EVENTUALLY(find<QLabel>("serveState")->text().contains(QStringLiteral("open to other computers")));
    }

private:
    void reveal()
    {
        auto *dock = find<QDockWidget>("dockLinks");
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
    }

    void type(const char *url)
    {
        QLineEdit *line = find<QComboBox>("serveUrl")->lineEdit();
        line->selectAll();
        QTest::keyClicks(line, QLatin1String(url));
        QTest::keyClick(line, Qt::Key_Return);
    }

    void chooseRights(int index)
    {
        auto *rights = find<QComboBox>("serveRights");
        rights->setFocus();
        while (rights->currentIndex() < index)
            QTest::keyClick(rights, Qt::Key_Down);
    }

    static engine::Snapshot sealed(bool serves)
    {
        engine::Snapshot snapshot;
        snapshot.time = 1;
        if (serves) {
            snapshot.served.emplace_back();
            snapshot.served.front().phase = engine::LinkPhase::Listening;
        }
        return snapshot;
    }
};

SKYSEAL_TEST_WIDGETS(GatewaySectionTest)
#include "gateway_section_test.moc"
