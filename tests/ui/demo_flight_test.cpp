// A flight as a new user makes it, with the real engine: the demo's simulator and agent as child processes, the window on
// top, by clicks. Pictures are kept in the folder that SKYSEAL_PICTURES names.
#include "confirm_question.h"
#include "app/skyseal/demo.h"
#include "app/skyseal/station_adapter.h"
#include "core/channel/policy.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "tests/support/eventually.h"
#include "tests/support/free_port.h"
#include "tests/support/test_runner.h"
#include "core/vehicle/geodesy.h"
#include "ui/map/map_view.h"
#include "ui/window/main_window.h"
#include "ui/security/suite_actions.h"
#include "ui/security/suite_row.h"
#include "ui/status/strip_item.h"
#include "window_hands.h"

#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;

class DemoFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(crypto::initCrypto());
        qputenv("PATH", QByteArray(SKYSEAL_BIN_DIR) + ':' + qgetenv("PATH"));
        QVERIFY(app::Demo::isAvailable());
        auto demo = app::Demo::create(m_random);
        QVERIFY2(demo, demo ? "" : demo.error().text().c_str());
        m_demo = std::move(*demo);
        connect(m_demo.get(), &app::Demo::ended, this, [](const QString &problem) { QFAIL(qPrintable(problem)); });

        engine::StationConfig config;
        config.keys = m_demo->stationKeys();
        config.policy.suites = channel::defaultSuites();
        config.record = false;
        auto station = engine::Station::create(config);
        QVERIFY2(station, station ? "" : station.error().text().c_str());
        m_station = std::make_unique<app::StationAdapter>(std::move(*station));
        m_store = std::make_unique<QSettings>(m_folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        m_window = std::make_unique<MainWindow>(*m_station, *m_store, ProgramFacts{});
        m_hands = std::make_unique<WindowHands>(*m_window);
        m_window->resize(1280, 900);
        m_window->show();

        const quint16 port = test::freeUdpPort();
        m_window->addLink(QStringLiteral("udpin:127.0.0.1:%1").arg(port));
        m_demo->start(port);
    }

    void sealsByItself()
    {
        EVENTUALLY(strip("stripLock")->text().startsWith(QStringLiteral("ChaCha20-Poly1305 · air-demo ✓")));
        EVENTUALLY(strip("stripGps")->text().startsWith(QStringLiteral("3D fix")));
        // GUIDED needs the vehicle's own estimate of its position, which it has a while after the fix; home comes with it.
        EVENTUALLY(m_window->view().vehicle->state.home.known());
        EVENTUALLY(find<QComboBox>("modeBox")->count() > 5);
    }

    void takesOff()
    {
        auto *modes = find<QComboBox>("modeBox");
        modes->setCurrentIndex(modes->findText(QStringLiteral("GUIDED")));
        m_hands->hold("setModeButton");
        EVENTUALLY2(strip("stripMode")->text() == QStringLiteral("GUIDED"), qPrintable(find<QLabel>("commandResult")->text()));
        m_hands->hold("armButton");
        EVENTUALLY_EQUAL(strip("stripArmed")->text(), QStringLiteral("ARMED"));
        m_hands->hold("takeOffButton");
        EVENTUALLY(find<QLabel>("commandResult")->text().endsWith(QStringLiteral("accepted")));
        EVENTUALLY(m_window->view().vehicle->state.altitudeRelative > 2);
    }

    void switchesInFlight()
    {
        for (const SuiteId suite :
             {SuiteId::Aes256Gcm, SuiteId::Aes256Ctr, SuiteId::Aes256Cbc, SuiteId::ChaCha20, SuiteId::ChaCha20Poly1305}) {
            auto *row = m_window->findChild<SuiteRow *>(QStringLiteral("row_")
                                                        + m_window->suites().action(suite)->objectName());
            QTest::mouseClick(row, Qt::LeftButton, {}, QPoint(12, row->height() / 2));
            EVENTUALLY(row->isChecked());
            EVENTUALLY(m_window->view().session->info.suite == suite);
        }
        QCOMPARE(m_window->view().session->stats.rx.lost, std::uint64_t(0));
        QCOMPARE(m_window->view().session->stats.rx.forged, std::uint64_t(0));
        m_hands->picture(QStringLiteral("flight"));
    }

    /// By the map's menu: home moves to a place, the copter flies to another one, turns its nose to home, climbs, and pauses.
    void fliesByTheMap()
    {
        auto *map = find<MapView>("map");
        const QPoint home = map->rect().center() + QPoint(60, 0), goal = map->rect().center() + QPoint(60, -40);
        const auto apart = [&](const QPoint &pixel, const vehicle::Position &position) {
            const LatLong place = mercator::unproject(map->viewport().toMetres(pixel));
            return vehicle::distanceMetres(position, {place.latitude, place.longitude, 0});
        };
        const auto result = [this] { return find<QLabel>("commandResult")->text(); };
        const auto confirm = [&](const QPoint &at, const char *action, const QString &expected) {
            m_hands->chooseOnMap(at, action);
            EVENTUALLY(question());
            QTest::mouseClick(question()->button(QMessageBox::Yes), Qt::LeftButton);
            EVENTUALLY2(result() == expected, qPrintable(result()));
        };
        confirm(home, "mapSetHome", QStringLiteral("Set home here: accepted"));
        EVENTUALLY(apart(home, m_window->view().vehicle->state.home) < 1);
        confirm(home, "mapPointAt", QStringLiteral("Point camera here: accepted"));
        confirm(goal, "mapGoHere", QStringLiteral("Go here: accepted"));
        m_hands->picture(QStringLiteral("map-menu-flight"));
        EVENTUALLY(apart(goal, m_window->view().vehicle->state.position) < 2);
        EVENTUALLY(std::abs(m_window->view().vehicle->state.heading - 180) < 10); // home is to the south
        m_hands->chooseOnMap(goal, "mapChangeAltitude");
        EVENTUALLY(m_window->findChild<QDialog *>(QStringLiteral("changeAltitudeDialog")));
        const double before = m_window->view().vehicle->state.altitudeRelative;
        auto *altitude = find<QDoubleSpinBox>("changeAltitudeDialogAltitude");
        altitude->setValue(std::round(before) + 5);
        m_hands->hold("changeAltitudeDialogGo");
        EVENTUALLY(m_window->view().vehicle->state.altitudeRelative > before + 4);
        confirm(goal, "mapPause", QStringLiteral("Pause: accepted"));
        EVENTUALLY_EQUAL(strip("stripMode")->text(), QStringLiteral("BRAKE"));
    }

    void researchSuiteNeedsConsent()
    {
        QVERIFY(!m_window->suites().action(SuiteId::Rc4)->isEnabled());
        m_station->setAllowResearch(true);
        m_window->suites().setResearchAllowed(true);
        EVENTUALLY(m_window->suites().action(SuiteId::Rc4)->isEnabled());
        m_window->suites().action(SuiteId::Rc4)->trigger();
        EVENTUALLY(strip("stripLock")->text().startsWith(QStringLiteral("RC4 (insecure)")));
    }

    void lands()
    {
        m_hands->hold("landButton");
        EVENTUALLY_EQUAL(strip("stripMode")->text(), QStringLiteral("LAND"));
        EVENTUALLY_EQUAL(strip("stripArmed")->text(), QStringLiteral("DISARMED"));
        m_hands->picture(QStringLiteral("landed"));
    }

    void cleanupTestCase()
    {
        m_window.reset();
        m_station.reset();
        m_demo.reset();
    }

private:
    template<typename W> W *find(const char *name) { return m_hands->find<W>(name); }
    StripItem *strip(const char *name) { return find<StripItem>(name); }

    QMessageBox *question() const { return test::shownQuestion(*m_window); }

    crypto::SystemRandom m_random;
    QTemporaryDir m_folder;
    std::unique_ptr<QSettings> m_store;
    std::unique_ptr<app::Demo> m_demo;
    std::unique_ptr<app::StationAdapter> m_station;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<WindowHands> m_hands;
};

SKYSEAL_TEST_WIDGETS(DemoFlightTest)
#include "demo_flight_test.moc"
