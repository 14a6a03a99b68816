// An operator's flight with a real autopilot: the whole window, skyseal-air and an unmodified ArduCopter SITL, by clicks and
// keys alone. From the link's dialog over the reason against arming, a mission from a file, the flight while the ciphers
// switch, a pause, a place and an altitude, to RTL and the replay of the recording. Every step leaves a picture in the folder
// that SKYSEAL_PICTURES names. Without ARDUPILOT_SITL (see Sitl) the test is skipped.
#include "app/skyseal/application.h"
#include "confirm_question.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/snapshot.h"
#include "core/log/log_index.h"
#include "core/vehicle/geodesy.h"
#include "tests/support/flight.h"
#include "tests/support/sitl.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"
#include "ui/parameters/parameter_model.h"
#include "ui/replay/recording_model.h"
#include "ui/security/suite_actions.h"
#include "ui/status/strip_item.h"
#include "ui/window/main_window.h"
#include "window_hands.h"

#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;

namespace {

/// A square of 80 m north of the simulator's home, 15 m high.
const char kMission[] = "QGC WPL 110\n"
                        "0\t1\t0\t16\t0\t0\t0\t0\t-35.363261\t149.165230\t584\t1\n"
                        "1\t0\t3\t22\t0\t0\t0\t0\t-35.363261\t149.165230\t15\t1\n"
                        "2\t0\t3\t16\t0\t0\t0\t0\t-35.362541\t149.165230\t15\t1\n"
                        "3\t0\t3\t16\t0\t0\t0\t0\t-35.362541\t149.166110\t20\t1\n"
                        "4\t0\t3\t16\t0\t0\t0\t0\t-35.363261\t149.166110\t15\t1\n"
                        "5\t0\t3\t16\t0\t0\t0\t0\t-35.363261\t149.165330\t15\t1\n";

/// Below what ArduCopter arms with.
const char kWrongAngle[] = "ANGLE_MAX 500\n";

QString words(const char *text)
{
    return QString::fromUtf8(text);
}

} // namespace

class ArduPilotWindowTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { QVERIFY2(!m_failed, "an earlier step of the flight failed"); }
    void cleanup() { m_failed = m_failed || QTest::currentTestFailed(); }
    void cleanupTestCase();

    void connectsByTheDialog();
    void saysWhyItWouldNotArm();
    void correctsTheParameter();
    void sendsAMissionFromAFile();
    void takesOff();
    void fliesTheMissionWhileCiphersSwitch();
    void pausesAndHoldsItsPlace();
    void goesToAPlace();
    void changesTheAltitude();
    void returnsAndLands();
    void replaysTheRecording();

private:
    template<typename W> W *find(const char *name) const { return m_hands->find<W>(name); }
    QString strip(const char *name) const { return find<StripItem>(name)->text(); }
    QString result() const { return find<QLabel>("commandResult")->text(); }
    const ViewState &view() const { return m_window->view(); }
    const vehicle::VehicleState &vehicle() const { return view().vehicle->state; }
    void picture(const char *name, QWidget *widget = nullptr) { m_hands->picture(words(name), widget); }
    void show(const char *workspace);
    /// Types over all that the field holds.
    static void type(QWidget *field, const QString &text)
    {
        field->setFocus();
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
    }
    void switchTo(SuiteId suite);
    void setMode(const QString &mode);
    void answerYes();
    /// Waits for something of the flight, which takes longer than an answer.
    template<typename Condition> [[nodiscard]] static bool flies(Condition condition)
    {
        return QTest::qWaitFor(condition, 4 * test::kDeadlineMs);
    }

    test::Sitl m_sitl{kWrongAngle};
    crypto::SystemRandom m_random;
    QTemporaryDir m_folder;
    std::unique_ptr<test::Flight> m_flight;
    std::unique_ptr<test::Program> m_copter, m_air;
    std::unique_ptr<app::Application> m_application;
    MainWindow *m_window = nullptr;
    std::unique_ptr<WindowHands> m_hands;
    bool m_failed = false;
};

void ArduPilotWindowTest::initTestCase()
{
    SKYSEAL_REQUIRES("arducopter");
    QVERIFY(crypto::initCrypto());
    for (const char *folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
        qputenv(folder, m_folder.filePath(words(folder)).toUtf8());
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.filePath(words("settings")));
    QCoreApplication::setApplicationName(words("skyseal"));
    QCoreApplication::setOrganizationName(words("skyseal"));
    m_flight = std::make_unique<test::Flight>();
    QVERIFY(m_flight->ready());

    app::WindowOptions options;
    options.identityFile = m_flight->path(words("ground.key")).toStdString();
    options.peersFile = m_flight->path(words("ground.peers")).toStdString();
    options.links.push_back(*link::LinkUrl::parse("udpin:127.0.0.1:0")); // on which nothing comes
    m_application = std::make_unique<app::Application>(std::move(options), m_random);
    QVERIFY(m_application->start());
    for (QWidget *top : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(top))
            m_window = window;
    QVERIFY(m_window);
    m_hands = std::make_unique<WindowHands>(*m_window);
    m_window->resize(1366, 768);
    QVERIFY(QTest::qWaitForWindowExposed(m_window, test::kDeadlineMs));
    m_window->activateWindow();
}

void ArduPilotWindowTest::connectsByTheDialog()
{
    picture("01-start");
    m_hands->choose("menuLink", "actionConnect");
    EVENTUALLY(m_window->findChild<QDialog *>(words("linkDialog")));
    auto *dialog = find<QDialog>("linkDialog");
    type(dialog->findChild<QLineEdit *>(words("linkHost")), words("127.0.0.1"));
    type(dialog->findChild<QSpinBox *>(words("linkPort")), QString::number(m_flight->groundPort));
    picture("02-connect", dialog);
    QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);

    const quint16 port = test::freeTcpPort();
    m_copter = m_sitl.start(port, 2);
    QStringList arguments = m_flight->airArguments();
    arguments[arguments.indexOf(words("--vehicle")) + 1] = words("tcp:127.0.0.1:%1").arg(port);
    m_air = std::make_unique<test::Program>(words("skyseal-air"), arguments);
    EVENTUALLY(strip("stripLock").startsWith(words("ChaCha20-Poly1305 · air-1 ✓")));
    EVENTUALLY(view().vehicle && !vehicle().modes.empty());
    picture("03-connected");
}

void ArduPilotWindowTest::saysWhyItWouldNotArm()
{
    auto *button = find<QPushButton>("preArmButton");
    const auto says = [this](const char *word) {
        return std::ranges::any_of(vehicle().preArmReasons,
                                   [word](const auto &reason) { return reason.find(word) != reason.npos; });
    };
    EVENTUALLY(says("ANGLE_MAX"));
    QTest::mouseClick(button, Qt::LeftButton);
    EVENTUALLY(m_window->findChild<QDialog *>(words("preArmDialog")));
    auto *list = find<QListWidget>("preArmList");
    EVENTUALLY(!list->findItems(words("ANGLE_MAX"), Qt::MatchContains).isEmpty());
    QVERIFY(list->findItems(words("ANGLE_MAX"), Qt::MatchContains).front()->text().contains(words("Correct the parameter")));
    picture("04-pre-arm", find<QDialog>("preArmDialog"));
    picture("05-pre-arm-window");
    m_hands->hold("armButton");
    EVENTUALLY(result().contains(words("Arm")));
    EVENTUALLY2(!result().endsWith(words("…")), qPrintable(result()));
    QVERIFY(!vehicle().armed);
    picture("06-arming-refused");
    m_hands->click("preArmClose");
}

void ArduPilotWindowTest::correctsTheParameter()
{
    show("workspace_vehicle");
    m_hands->click("parameterFetch");
    auto *count = find<QLabel>("parameterCount");
    const auto all = [count] {
        const QStringList numbers = count->text().split(words(" of "));
        return numbers.size() == 2 && numbers[0] == numbers[1];
    };
    EVENTUALLY2(all(), qPrintable(count->text()));
    type(find<QLineEdit>("parameterFilter"), words("ANGLE_MAX"));
    auto *list = find<QTreeView>("parameterView");
    const auto found = list->model()->match(list->model()->index(0, ParameterModel::Name), Qt::DisplayRole, words("ANGLE_MAX"),
                                            1, Qt::MatchExactly);
    QCOMPARE(found.size(), 1);
    QVERIFY(list->model()->rowCount() < 5);
    const auto cell = [&](ParameterModel::Column column) { return found.front().siblingAtColumn(column); };
    QCOMPARE(cell(ParameterModel::Value).data().toString(), words("500"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(cell(ParameterModel::Value)).center());
    EVENTUALLY(list->hasFocus());
    QCOMPARE(list->currentIndex(), cell(ParameterModel::Value));
    QTest::keyClick(list, Qt::Key_F2);
    EVENTUALLY(list->viewport()->findChild<QLineEdit *>());
    auto *editor = list->viewport()->findChild<QLineEdit *>();
    type(editor, words("4500"));
    QTest::keyClick(editor, Qt::Key_Return);
    EVENTUALLY_EQUAL(cell(ParameterModel::State).data().toString(), words("written, read back as 4500"));
    EVENTUALLY_EQUAL(cell(ParameterModel::Value).data().toString(), words("4500"));
    picture("07-parameter");
    EVENTUALLY2(vehicle().gpsFix >= int(mavlink::GPS_FIX_TYPE_3D_FIX), qPrintable(strip("stripGps")));
    QVERIFY(flies([this] { return vehicle().ekfOk.value_or(false) && vehicle().home.known(); }));
    QVERIFY(flies([this] { return vehicle().preArmReasons.empty(); }));
}

void ArduPilotWindowTest::sendsAMissionFromAFile()
{
    const QString path = m_folder.filePath(words("square.waypoints"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(kMission) > 0);
    file.close();
    show("workspace_plan");
    m_hands->clickAndName("missionSend", path);
    auto *list = find<QTreeView>("missionView");
    EVENTUALLY_EQUAL(list->model()->rowCount(), 6);
    EVENTUALLY2(!find<QLabel>("missionResult")->text().contains(words("…")), qPrintable(find<QLabel>("missionResult")->text()));
    m_hands->click("missionRead");
    EVENTUALLY2(!find<QLabel>("missionResult")->text().contains(words("…")), qPrintable(find<QLabel>("missionResult")->text()));
    QCOMPARE(list->model()->rowCount(), 6);
    QCOMPARE(view().vehicle->mission->at(3).altitude, 20.F);
    picture("08-mission");
}

void ArduPilotWindowTest::takesOff()
{
    show("workspace_fly");
    setMode(words("GUIDED"));
    m_hands->hold("armButton");
    EVENTUALLY2(strip("stripArmed") == words("ARMED"), qPrintable(result()));
    picture("09-armed");
    m_hands->hold("takeOffButton");
    QVERIFY2(flies([this] { return vehicle().altitudeRelative > 9; }), qPrintable(result()));
    picture("10-airborne");
}

void ArduPilotWindowTest::fliesTheMissionWhileCiphersSwitch()
{
    m_hands->hold("startMissionButton");
    EVENTUALLY2(strip("stripMode") == words("AUTO"), qPrintable(result()));
    const SuiteId suites[] = {SuiteId::Aes256Gcm, SuiteId::Aes256Ctr, SuiteId::Aes256Cbc, SuiteId::ChaCha20,
                              SuiteId::ChaCha20Poly1305};
    int item = 2; // the first waypoint
    for (const SuiteId suite : suites) {
        switchTo(suite);
        if (item <= 4) {
            QVERIFY2(flies([&] { return vehicle().missionCurrent > item; }), qPrintable(QString::number(item)));
            picture(qPrintable(words("11-mission-%1").arg(item++)));
        }
    }
    QCOMPARE(strip("stripMode"), words("AUTO"));
}

void ArduPilotWindowTest::pausesAndHoldsItsPlace()
{
    m_sitl.centreSticks();
    m_hands->hold("pauseButton");
    EVENTUALLY2(strip("stripMode") != words("AUTO"), qPrintable(result()));
    EVENTUALLY(vehicle().groundSpeed < 0.5);
    const vehicle::Position place = vehicle().position;
    const double altitude = vehicle().altitudeRelative, since = vehicle().flightTime;
    QVERIFY(flies([&] { return vehicle().flightTime > since + 10; }));
    picture("12-paused");
    QVERIFY2(std::abs(vehicle().altitudeRelative - altitude) < 1, qPrintable(QString::number(vehicle().altitudeRelative)));
    QVERIFY(vehicle::distanceMetres(place, vehicle().position) < 3);
}

void ArduPilotWindowTest::goesToAPlace()
{
    setMode(words("GUIDED")); // in which ArduCopter before 4.1 must be, as it does not know MAV_CMD_DO_REPOSITION
    auto *map = find<MapView>("map");
    const QPoint goal = map->rect().center() + QPoint(-70, 40);
    const LatLong place = mercator::unproject(map->viewport().toMetres(goal));
    m_hands->chooseOnMap(goal, "mapGoHere");
    EVENTUALLY(test::shownQuestion(*m_window));
    picture("13-go-here", test::shownQuestion(*m_window));
    answerYes();
    const auto apart = [&] { return vehicle::distanceMetres(vehicle().position, {place.latitude, place.longitude, 0}); };
    QVERIFY2(flies([&] { return apart() < 2; }), qPrintable(words("%1; %2 m").arg(result()).arg(apart())));
    EVENTUALLY2(result().endsWith(words("accepted")), qPrintable(result()));
    QCOMPARE(strip("stripMode"), words("GUIDED"));
    picture("14-there");
}

void ArduPilotWindowTest::changesTheAltitude()
{
    m_hands->choose("menuVehicle", "actionChangeAltitude");
    EVENTUALLY(m_window->findChild<QDialog *>(words("changeAltitudeDialog")));
    type(find<QDoubleSpinBox>("changeAltitudeDialogAltitude"), words("25"));
    picture("15-altitude", find<QDialog>("changeAltitudeDialog"));
    m_hands->hold("changeAltitudeDialogGo");
    QVERIFY2(flies([this] { return std::abs(vehicle().altitudeRelative - 25) < 1; }), qPrintable(result()));
    picture("16-higher");
}

void ArduPilotWindowTest::returnsAndLands()
{
    m_hands->hold("returnButton");
    EVENTUALLY2(strip("stripMode") == words("RTL"), qPrintable(result()));
    picture("17-rtl");
    switchTo(SuiteId::Aes256Gcm);
    QVERIFY(flies([this] { return strip("stripArmed") == words("DISARMED"); }));
    QVERIFY(vehicle().distanceHome < 3);
    picture("18-landed");
    const auto &received = view().session->stats.rx;
    qInfo("%llu records of the vehicle, %llu lost", static_cast<unsigned long long>(received.good),
          static_cast<unsigned long long>(received.lost));
    QCOMPARE(received.lost, std::uint64_t(0));
    QCOMPARE(received.forged, std::uint64_t(0));
    show("workspace_lab");
    picture("19-lab");
    show("workspace_fly");
}

void ArduPilotWindowTest::replaysTheRecording()
{
    m_hands->choose("menuFile", "actionReplay");
    EVENTUALLY(m_window->findChild<QDialog *>(words("recordingsDialog")));
    auto *list = find<QTreeView>("recordingView");
    const auto ciphers = [list] { return list->model()->index(0, RecordingModel::Ciphers).data().toString(); };
    EVENTUALLY2(ciphers().contains(words("AES-256-GCM")), qPrintable(ciphers()));
    picture("20-recordings", find<QDialog>("recordingsDialog"));
    m_hands->click("recordingReplay");
    EVENTUALLY(find<QWidget>("replayBar")->isVisible());
    EVENTUALLY(view().isReplay() && view().snapshot->replay && view().snapshot->replay->index);
    const Duration length = view().snapshot->replay->index->length;
    auto *line = find<QWidget>("replayLine");
    QTest::mouseClick(line, Qt::LeftButton, {}, {line->width() * 2 / 3, line->height() / 2});
    EVENTUALLY(!view().snapshot->replay->seeking && view().snapshot->replay->position > length / 2);
    EVENTUALLY(view().vehicle && vehicle().armed);
    picture("21-replay");
    m_hands->click("replayPlay");
    EVENTUALLY(!view().snapshot->replay->playing);
    QVERIFY(!find<HoldButton>("landButton")->isEnabled()); // nothing of a recording can be commanded
    m_hands->click("sourceEnd");
    EVENTUALLY(!view().isReplay());
    QVERIFY(!find<QWidget>("replayBar")->isVisible());
    QCOMPARE(strip("stripArmed"), words("DISARMED"));
    picture("22-live-again");
}

/// By its tab.
void ArduPilotWindowTest::show(const char *workspace)
{
    m_window->activateWindow(); // where no window manager does it when a dialog closes
    QVERIFY(QTest::qWaitForWindowActive(m_window, test::kDeadlineMs));
    const auto *action = find<QAction>(workspace);
    for (QToolButton *tab : find<QWidget>("workspaceTabs")->findChildren<QToolButton *>())
        if (tab->defaultAction() == action)
            QTest::mouseClick(tab, Qt::LeftButton);
    QVERIFY(action->isChecked());
}

void ArduPilotWindowTest::switchTo(SuiteId suite)
{
    const QAction *action = m_window->suites().action(suite);
    m_hands->choose("menuSecurity", action);
    EVENTUALLY(action->isChecked());
    EVENTUALLY(view().session && view().session->info.suite == suite);
}

void ArduPilotWindowTest::setMode(const QString &mode)
{
    auto *modes = find<QComboBox>("modeBox");
    modes->setFocus();
    QTest::keyClick(modes, Qt::Key_Home);
    for (int i = 0; i < modes->count() && modes->currentText() != mode; ++i)
        QTest::keyClick(modes, Qt::Key_Down);
    QCOMPARE(modes->currentText(), mode);
    m_hands->hold("setModeButton");
    EVENTUALLY2(strip("stripMode") == mode, qPrintable(result()));
}

void ArduPilotWindowTest::answerYes()
{
    QTest::mouseClick(test::shownQuestion(*m_window)->button(QMessageBox::Yes), Qt::LeftButton);
}

void ArduPilotWindowTest::cleanupTestCase()
{
    m_hands.reset();
    if (m_application)
        m_application->stop();
    m_application.reset();
    m_air.reset();
    m_copter.reset();
}

SKYSEAL_TEST_WIDGETS(ArduPilotWindowTest)
#include "ardupilot_window_test.moc"
