// A flight by the keyboard alone, over a real sealed link: from the dialog that opens the link over arming, take-off, altitude,
// a place on the map and a change of the cipher to RTL, landing and the replay of the recording. No mouse, and no call of a
// function of the window: each key goes to the window that has the focus, and a control is reached by Tab. Pictures are kept in
// the folder that SKYSEAL_PICTURES names.
#include "core/log/log_index.h"
#include "core/vehicle/geodesy.h"
#include "confirm_question.h"
#include "sealed_window.h"
#include "tests/support/test_runner.h"
#include "ui/held_keys.h"
#include "ui/replay/recording_model.h"
#include "ui/security/suite_actions.h"

#include <QtCore/QFileInfo>
#include <QtGui/QContextMenuEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;

class KeyboardFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { QVERIFY2(!m_failed, "an earlier step of the flight failed"); }
    void cleanup() { m_failed = m_failed || QTest::currentTestFailed(); }
    void cleanupTestCase() { m_it.reset(); }

    void connects();
    void setsAParameter();
    void armsAndDisarms();
    void takesOff();
    void changesTheAltitude();
    void goesToAPlaceOnTheMap();
    void switchesTheCipher();
    void returnsAndLands();
    void replaysTheRecording();
    void quits();

private:
    /// The window that gets the keys. Where no window manager gives them to the main window when a dialog closes, this does.
    QWindow *keyWindow() const;
    void keyDown(int key, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::keyPress(keyWindow(), static_cast<Qt::Key>(key), modifiers);
    }
    void keyUp(int key, Qt::KeyboardModifiers modifiers = {}) const;
    void press(int key, Qt::KeyboardModifiers modifiers = {}) const
    {
        keyDown(key, modifiers);
        keyUp(key, modifiers);
    }
    void press(const QAction *action) const
    {
        QVERIFY2(action->isEnabled(), qPrintable(action->toolTip()));
        const QKeyCombination keys = action->shortcut()[0];
        press(keys.key(), keys.keyboardModifiers());
    }
    void type(const QString &text) const
    {
        for (const QChar letter : text)
            QTest::keyClick(keyWindow(), letter.toLatin1());
    }
    /// Replaces what the field with the focus holds.
    void typeOver(const QString &text) const
    {
        press(Qt::Key_A, Qt::ControlModifier);
        type(text);
    }
    void tabTo(const QWidget *wanted) const;
    void tabTo(const char *name) const { tabTo(m_it->find<QWidget>(name)); }
    void hold(const char *name) const;
    /// Goes down in a menu to this entry, and chooses it.
    void chooseIn(const QMenu &menu, const QAction *entry) const;
    void answerYes() const;
    QDialog *waitForDialog(const char *name) const;
    QString result() const { return m_it->find<QLabel>("commandResult")->text(); }
    void setMode(const QString &mode) const;
    void picture(const char *name) const { m_it->hands->picture(QLatin1String(name)); }

    std::unique_ptr<SealedWindow> m_it;
    bool m_failed = false;
};

QWindow *KeyboardFlightTest::keyWindow() const
{
    if (!QGuiApplication::focusWindow() || !QApplication::activeWindow())
        m_it->activate();
    return QGuiApplication::focusWindow();
}

/// A press of the same key that comes sooner than a finger can would go on with the hold.
void KeyboardFlightTest::keyUp(int key, Qt::KeyboardModifiers modifiers) const
{
    QSignalSpy released(&HeldKeys::ofProgram(), &HeldKeys::released);
    QTest::keyRelease(keyWindow(), static_cast<Qt::Key>(key), modifiers);
    if (HeldKeys::isPressKey(key))
        EVENTUALLY(!released.isEmpty());
}

void KeyboardFlightTest::tabTo(const QWidget *wanted) const
{
    constexpr int kMostStops = 300;
    keyWindow();
    QStringList stops;
    for (int i = 0; i < kMostStops && QApplication::focusWidget() != wanted; ++i) {
        press(Qt::Key_Tab);
        if (const QWidget *stop = QApplication::focusWidget())
            stops << (stop->objectName().isEmpty() ? QString::fromLatin1(stop->metaObject()->className()) : stop->objectName());
    }
    QVERIFY2(
        QApplication::focusWidget() == wanted,
        qPrintable(QStringLiteral("%1 is not reached by Tab: %2").arg(wanted->objectName(), stops.join(QLatin1Char(' ')))));
}

void KeyboardFlightTest::hold(const char *name) const
{
    const QPointer<HoldButton> button = m_it->find<HoldButton>(name);
    EVENTUALLY2(button->isEnabled(), qPrintable(button->toolTip()));
    tabTo(button);
    const auto *guard = button->findChild<CommandGuard *>();
    EVENTUALLY(!guard->isQuiet()); // after the last command
    QSignalSpy confirmed(button, &HoldButton::confirmed);
    keyDown(Qt::Key_Space);
    EVENTUALLY_EQUAL(confirmed.size(), 1);
    keyUp(Qt::Key_Space);
}

void KeyboardFlightTest::chooseIn(const QMenu &menu, const QAction *entry) const
{
    EVENTUALLY(menu.isVisible());
    QVERIFY2(entry && entry->isEnabled(), entry ? qPrintable(entry->toolTip()) : "no such entry");
    for (int i = 0; i < menu.actions().size() && menu.activeAction() != entry; ++i)
        press(Qt::Key_Down);
    QCOMPARE(menu.activeAction(), entry);
    press(Qt::Key_Return);
}

QDialog *KeyboardFlightTest::waitForDialog(const char *name) const
{
    const auto shown = [&] {
        auto *dialog = m_it->window->findChild<QDialog *>(QLatin1String(name));
        return dialog && dialog->isVisible() && QApplication::activeWindow() == dialog;
    };
    if (!test::eventually(shown))
        qFatal("%s does not open", name);
    return m_it->find<QDialog>(name);
}

void KeyboardFlightTest::answerYes() const
{
    const QMessageBox *box = qobject_cast<QMessageBox *>(waitForDialog("confirmCommand"));
    QVERIFY(box && box->focusWidget() != box->button(QMessageBox::Yes)); // Enter alone would say no
    tabTo(box->button(QMessageBox::Yes));
    press(Qt::Key_Space);
}

void KeyboardFlightTest::setMode(const QString &mode) const
{
    auto *modes = m_it->find<QComboBox>("modeBox");
    tabTo(modes);
    press(Qt::Key_Home);
    for (int i = 0; i < modes->count() && modes->currentText() != mode; ++i)
        press(Qt::Key_Down);
    QCOMPARE(modes->currentText(), mode);
    hold("setModeButton");
    EVENTUALLY2(m_it->strip("stripMode") == mode, qPrintable(result()));
}

void KeyboardFlightTest::initTestCase()
{
    m_it = std::make_unique<SealedWindow>();
    QVERIFY(m_it->open({SealedWindow::idleLink()}));
    m_it->startVehicles();
    m_it->startAgent();
}

void KeyboardFlightTest::connects()
{
    press(Qt::Key_F12);
    const QDialog *dialog = waitForDialog("linkDialog");
    tabTo(dialog->findChild<QLineEdit *>(QStringLiteral("linkHost")));
    typeOver(QStringLiteral("127.0.0.1"));
    tabTo(dialog->findChild<QWidget *>(QStringLiteral("linkPort")));
    typeOver(QString::number(m_it->flight.groundPort));
    press(Qt::Key_Return);
    EVENTUALLY(m_it->isReadyToFly());
    picture("keys-connected");
}

/// It may stay armed on the ground for as long as the next steps take.
void KeyboardFlightTest::setsAParameter()
{
    press(m_it->find<QAction>("workspace_vehicle"));
    tabTo("parameterFetch");
    press(Qt::Key_Space);
    const auto *count = m_it->find<QLabel>("parameterCount");
    const auto all = [count] {
        const QStringList numbers = count->text().split(QStringLiteral(" of "));
        return numbers.size() == 2 && numbers[0] == numbers[1];
    };
    EVENTUALLY2(all(), qPrintable(count->text()));
    tabTo("parameterFilter");
    type(QStringLiteral("disarm_delay"));
    const auto *list = m_it->find<QTreeView>("parameterView");
    EVENTUALLY_EQUAL(list->model()->rowCount(), 1);
    tabTo(list);
    press(Qt::Key_Home);
    press(Qt::Key_F2);
    EVENTUALLY(qobject_cast<QLineEdit *>(QApplication::focusWidget()));
    typeOver(QStringLiteral("0"));
    press(Qt::Key_Return);
    const QModelIndex state = list->model()->index(0, ParameterModel::State);
    EVENTUALLY2(state.data().toString() == QStringLiteral("written, read back as 0"), qPrintable(state.data().toString()));
    press(m_it->find<QAction>("workspace_fly"));
}

void KeyboardFlightTest::armsAndDisarms()
{
    setMode(QStringLiteral("GUIDED"));
    hold("armButton");
    EVENTUALLY2(m_it->strip("stripArmed") == QStringLiteral("ARMED"), qPrintable(result()));
    press(m_it->find<QAction>("actionDisarm"));
    answerYes();
    EVENTUALLY2(result() == QStringLiteral("Disarm: accepted"), qPrintable(result()));
    EVENTUALLY_EQUAL(m_it->strip("stripArmed"), QStringLiteral("DISARMED"));
}

void KeyboardFlightTest::takesOff()
{
    hold("armButton");
    EVENTUALLY2(m_it->strip("stripArmed") == QStringLiteral("ARMED"), qPrintable(result()));
    hold("takeOffButton");
    QVERIFY2(m_it->flies([this] { return m_it->vehicle().altitudeRelative > 9; }), qPrintable(result()));
    picture("keys-airborne");
}

void KeyboardFlightTest::changesTheAltitude()
{
    press(m_it->find<QAction>("actionChangeAltitude"));
    const QPointer<QDialog> dialog = waitForDialog("changeAltitudeDialog");
    typeOver(QStringLiteral("15"));
    hold("changeAltitudeDialogGo");
    EVENTUALLY(!dialog || !dialog->isVisible());
    QVERIFY2(m_it->flies([this] { return std::abs(m_it->vehicle().altitudeRelative - 15) < 1; }), qPrintable(result()));
}

/// The middle of the map is moved with the arrow keys, and its menu opens there.
void KeyboardFlightTest::goesToAPlaceOnTheMap()
{
    auto *map = m_it->find<MapView>("map");
    tabTo(map);
    const auto middle = [map] {
        const LatLong place = mercator::unproject(map->viewport().toMetres(map->rect().center()));
        return vehicle::Position{place.latitude, place.longitude, 0};
    };
    const auto apart = [this](const vehicle::Position &from) {
        return vehicle::distanceMetres(from, m_it->vehicle().position);
    };
    for (int i = 0; i < 40 && apart(middle()) < 20; ++i) {
        press(Qt::Key_Up);
        EVENTUALLY(!map->isMoving());
    }
    QVERIFY(apart(middle()) >= 20);
    const vehicle::Position goal = middle();
    QVERIFY(map->hasFocus());
    QContextMenuEvent menuKey(QContextMenuEvent::Keyboard, {3, 3}, map->mapToGlobal(QPoint(3, 3)));
    QCoreApplication::sendEvent(QApplication::focusWidget(), &menuKey); // the window system turns the key into this
    EVENTUALLY(map->findChild<QMenu *>(QStringLiteral("mapMenu")));
    const auto *menu = map->findChild<QMenu *>(QStringLiteral("mapMenu"));
    chooseIn(*menu, menu->findChild<QAction *>(QStringLiteral("mapGoHere")));
    answerYes();
    QVERIFY2(m_it->flies([&] { return apart(goal) < 2; }), qPrintable(result()));
    EVENTUALLY2(result() == QStringLiteral("Go here: accepted"), qPrintable(result()));
    picture("keys-place");
}

/// By the menu and by the key of its entry.
void KeyboardFlightTest::switchesTheCipher()
{
    press(Qt::Key_S, Qt::AltModifier);
    chooseIn(*m_it->find<QMenu>("menuSecurity"), m_it->window->suites().action(SuiteId::Aes256Gcm));
    EVENTUALLY(m_it->view().session->info.suite == SuiteId::Aes256Gcm);
    EVENTUALLY2(m_it->strip("stripLock").startsWith(QStringLiteral("AES-256-GCM")), qPrintable(m_it->strip("stripLock")));
    const QAction *back = m_it->window->suites().action(SuiteId::ChaCha20Poly1305);
    EVENTUALLY(!m_it->window->suites().pending());
    press(back);
    EVENTUALLY(m_it->view().session->info.suite == SuiteId::ChaCha20Poly1305);
    QCOMPARE(m_it->view().session->stats.rx.forged, std::uint64_t(0));
}

void KeyboardFlightTest::returnsAndLands()
{
    hold("returnButton");
    EVENTUALLY2(m_it->strip("stripMode") == QStringLiteral("RTL"), qPrintable(result()));
    hold("landButton");
    EVENTUALLY2(m_it->strip("stripMode") == QStringLiteral("LAND"), qPrintable(result()));
    QVERIFY(m_it->flies([this] { return m_it->strip("stripArmed") == QStringLiteral("DISARMED"); }));
    QVERIFY(std::abs(m_it->vehicle().altitudeRelative) < 1);
    picture("keys-landed");
}

void KeyboardFlightTest::replaysTheRecording()
{
    // Two writes later the landing is in the file.
    const QString file = QString::fromStdString(m_it->view().snapshot->recording.file);
    for (int write = 0; write < 2; ++write) {
        const qint64 before = QFileInfo(file).size();
        EVENTUALLY(QFileInfo(file).size() > before);
    }
    press(m_it->find<QAction>("actionReplay"));
    const QDialog *dialog = waitForDialog("recordingsDialog");
    const auto *list = dialog->findChild<QAbstractItemView *>(QStringLiteral("recordingView"));
    const auto ciphers = [list] { return list->model()->index(0, RecordingModel::Ciphers).data().toString(); };
    EVENTUALLY2(ciphers().contains(QStringLiteral("AES-256-GCM")), qPrintable(ciphers()));
    press(Qt::Key_Return);
    EVENTUALLY(m_it->view().isReplay() && m_it->view().snapshot->replay && m_it->view().snapshot->replay->index);
    const Duration length = m_it->view().snapshot->replay->index->length;
    tabTo("replayPlay");
    press(Qt::Key_Space);
    EVENTUALLY(!m_it->view().snapshot->replay->playing);
    tabTo("replayLine");
    press(Qt::Key_End);
    EVENTUALLY(!m_it->view().snapshot->replay->seeking && m_it->view().snapshot->replay->position > length / 2);
    EVENTUALLY2(
        m_it->view().vehicle && m_it->strip("stripArmed") == QStringLiteral("DISARMED"),
        qPrintable(QStringLiteral("%1, vehicle %2").arg(m_it->strip("stripArmed")).arg(m_it->view().vehicle != nullptr)));
    QVERIFY(!m_it->find<HoldButton>("landButton")->isEnabled()); // nothing of a recording can be commanded
    picture("keys-replay");
    tabTo("sourceEnd");
    press(Qt::Key_Space);
    EVENTUALLY(!m_it->view().isReplay());
}

/// Without a question: nothing is armed.
void KeyboardFlightTest::quits()
{
    EVENTUALLY(m_it->isSealed());
    keyDown(Qt::Key_Q, Qt::ControlModifier); // no window is left for its release
    EVENTUALLY(!m_it->window->isVisible());
}

SKYSEAL_TEST_WIDGETS(KeyboardFlightTest)
#include "keyboard_flight_test.moc"
