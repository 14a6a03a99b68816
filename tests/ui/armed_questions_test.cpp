// What an operator is asked while a vehicle is armed, so that no file chosen by mistake steers it and no sweep is begun by two
// keys.
#include "fake_sweep.h"
#include "gallery_dialogs.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/mission/mission_panel.h"
#include "ui/parameters/parameter_model.h"
#include "ui/replay/recordings_dialog.h"
#include "ui/sweep/sweep_dialog.h"
#include "window_rig.h"

#include <QtCore/QPointer>
#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class ArmedQuestionsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_window->setSweep(m_sweeps);
        m_sweeps.orders.clear();
    }
    void cleanup() { tearDown(); }

    void missionIsReplacedOnceConfirmed()
    {
        show(true);
        auto *panel = m_window->findChild<MissionPanel *>();
        panel->sendFile(missionFile(), 1);
        QVERIFY2(question("confirmSendMission")->text().contains(QStringLiteral("armed")),
                 qPrintable(question("confirmSendMission")->text()));
        QTest::keyClick(question("confirmSendMission"), Qt::Key_Escape);
        EVENTUALLY(!isAsked("confirmSendMission"));
        QVERIFY(m_station->requests.empty());

        panel->sendFile(missionFile(), 1);
        QTest::mouseClick(question("confirmSendMission")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_station->requests.size(), std::size_t(1));
        const auto *write = std::get_if<vehicle::WriteMission>(&m_station->requests.front());
        QVERIFY(write && write->items.size() == 2);
    }

    void anotherFileTakesThePlaceOfTheFirst()
    {
        show(true);
        auto *panel = m_window->findChild<MissionPanel *>();
        panel->sendFile(missionFile(), 1);
        panel->sendFile(missionFile(), 1);
        EVENTUALLY_EQUAL(m_window->findChildren<QMessageBox *>(QStringLiteral("confirmSendMission")).size(), 1);
    }

    void missionIsNotSentToAnotherVehicle()
    {
        show(true);
        m_window->findChild<MissionPanel *>()->sendFile(missionFile(), 1);
        m_station->showSealed(2, [](auto &state) { state.systemId = 2; }); // selected between the question and its answer
        m_station->requests.clear();
        QTest::mouseClick(question("confirmSendMission")->button(QMessageBox::Yes), Qt::LeftButton);
        QVERIFY(m_station->requests.empty());
        QVERIFY2(find<QLabel>("missionResult")->text().contains(QStringLiteral("Not sent")),
                 qPrintable(find<QLabel>("missionResult")->text()));
    }

    void disarmedVehicleGetsItAtOnce()
    {
        show(false);
        m_window->findChild<MissionPanel *>()->sendFile(missionFile(), 1);
        QVERIFY(!isAsked("confirmSendMission"));
        QCOMPARE(m_station->requests.size(), std::size_t(1));
    }

    void sweepOnTheLinkBeginsOnceConfirmed()
    {
        show(true);
        runSweep();
        QVERIFY(m_sweeps.orders.empty());
        QTest::keyClick(question("confirmSweep"), Qt::Key_Return); // Cancel is the default
        EVENTUALLY(!isAsked("confirmSweep"));
        QVERIFY(m_sweeps.orders.empty());

        runSweep();
        QTest::mouseClick(question("confirmSweep")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_sweeps.orders.size(), std::size_t(1));
    }

    void theNewestSweepTakesThePlaceOfTheFirst()
    {
        show(true);
        runSweep();
        const QPointer<QMessageBox> first = question("confirmSweep");
        runSweep();
        EVENTUALLY(!first);
        QCOMPARE(m_window->findChildren<QMessageBox *>(QStringLiteral("confirmSweep")).size(), 1);
        QVERIFY(m_sweeps.orders.empty()); // the first was not confirmed
        QTest::mouseClick(question("confirmSweep")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_sweeps.orders.size(), std::size_t(1));
        m_sweeps.finish();
    }

    void sweepOfADisarmedVehicleBeginsAtOnce()
    {
        show(false);
        runSweep();
        QVERIFY(!isAsked("confirmSweep"));
        QCOMPARE(m_sweeps.orders.size(), std::size_t(1));
        m_sweeps.finish();
    }

    /// During a replay no vehicle can be commanded.
    void logIsReplayedOnceConfirmed()
    {
        show(true);
        chooseLog();
        QVERIFY2(question("confirmReplay")->text().contains(QStringLiteral("Vehicle 1 is armed")),
                 qPrintable(question("confirmReplay")->text()));
        QTest::keyClick(question("confirmReplay"), Qt::Key_Return); // Cancel is the default
        EVENTUALLY(!isAsked("confirmReplay"));
        QVERIFY(m_station->replays.empty());

        chooseLog();
        QTest::mouseClick(question("confirmReplay")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_station->replays.size(), std::size_t(1));
    }

    void revokeSaysThatTheVehicleIsArmed()
    {
        FakeKeyring keyring;
        fillKeyring(keyring);
        keyring.list.peers[0].name = QStringLiteral("air-1");
        m_window->setKeyring(keyring);
        for (const bool armed : {true, false}) {
            show(armed);
            find<QAction>("actionKeys")->trigger();
            auto *dialog = find<QDialog>("keysDialog");
            EVENTUALLY(dialog->isVisible());
            dialog->findChild<QTreeView *>(QStringLiteral("peerView"))
                ->setCurrentIndex(dialog->findChild<QTreeView *>(QStringLiteral("peerView"))->model()->index(0, 0));
            QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("peerRevoke")), Qt::LeftButton);
            const QMessageBox *box = question("confirmRevoke");
            QCOMPARE(box->text(),
                     armed ? QStringLiteral("Vehicle 1 is armed. Revoke air-1?") : QStringLiteral("Revoke air-1?"));
            QCOMPARE(box->informativeText().contains(QStringLiteral("failsafes may trigger")), armed);
            dialog->close();
            EVENTUALLY(!m_window->findChild<QDialog *>(QStringLiteral("keysDialog")));
        }
        tearDown(); // before the keyring
    }

    void parameterIsWrittenOnceConfirmed()
    {
        show(true);
        typeParameter(QStringLiteral("5200"));
        EVENTUALLY(isAsked("confirmParameter"));
        QMessageBox *box = question("confirmParameter");
        QVERIFY2(box->text().contains(QStringLiteral("armed. Change BATT_CAPACITY?")), qPrintable(box->text()));
        QVERIFY2(box->informativeText().contains(QStringLiteral("from 3300 to 5200")), qPrintable(box->informativeText()));
        QVERIFY(box->defaultButton() == box->button(QMessageBox::Cancel));
        QTest::keyClick(box, Qt::Key_Return);
        EVENTUALLY(!isAsked("confirmParameter"));
        QVERIFY(m_station->written.empty());
        EVENTUALLY2(parameterState().startsWith(QStringLiteral("not written")), qPrintable(parameterState()));

        typeParameter(QStringLiteral("5200"));
        EVENTUALLY(isAsked("confirmParameter"));
        QTest::mouseClick(question("confirmParameter")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_station->written.size(), std::size_t(1));
        QVERIFY(m_station->written.front() == std::pair(std::string("BATT_CAPACITY"), 5200.0));
    }

    void parameterIsNotWrittenToAnotherVehicle()
    {
        show(true);
        typeParameter(QStringLiteral("5200"));
        EVENTUALLY(isAsked("confirmParameter"));
        m_station->showSealed(2, [](auto &state) { state.systemId = 2; });
        EVENTUALLY(!isAsked("confirmParameter"));
        QVERIFY(m_station->written.empty());
    }

    void parameterOfADisarmedVehicleIsWrittenAtOnce()
    {
        show(false);
        typeParameter(QStringLiteral("5200"));
        EVENTUALLY_EQUAL(m_station->written.size(), std::size_t(1));
        QVERIFY(!isAsked("confirmParameter"));
    }

private:
    QTreeView *parameterView() const { return find<QTreeView>("parameterView"); }
    QString parameterState() const
    {
        return parameterView()->currentIndex().siblingAtColumn(ParameterModel::State).data().toString();
    }

    /// Over the value of the third one, by keys.
    void typeParameter(const QString &value)
    {
        find<QAction>("view_dockParameters")->trigger();
        QTreeView *view = parameterView();
        EVENTUALLY(view->isVisible());
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), test::kDeadlineMs));
        view->setFocus();
        EVENTUALLY(view->hasFocus());
        view->setCurrentIndex(view->model()->index(2, ParameterModel::Value));
        QTest::keyClick(view, Qt::Key_F2);
        EVENTUALLY(view->viewport()->findChild<QLineEdit *>());
        auto *editor = view->viewport()->findChild<QLineEdit *>();
        editor->selectAll();
        QTest::keyClicks(editor, value);
        QTest::keyClick(editor, Qt::Key_Return);
    }

    void chooseLog()
    {
        find<QAction>("actionReplay")->trigger();
        EVENTUALLY(m_window->findChild<RecordingsDialog *>());
        QTest::mouseClick(find<QPushButton>("recordingOther"), Qt::LeftButton);
        EVENTUALLY(m_window->findChild<QFileDialog *>());
        Q_EMIT m_window->findChild<QFileDialog *>()->fileSelected(QStringLiteral("/else/where.tlog"));
        EVENTUALLY(!m_window->findChild<RecordingsDialog *>());
    }

    void show(bool armed)
    {
        m_station->showSealed(1, [armed](auto &state) { state.armed = armed; });
        m_station->requests.clear(); // of panels that read as soon as a vehicle is there
    }

    QString missionFile()
    {
        const QString name = m_folder->filePath(QStringLiteral("far.waypoints"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly))
            qFatal("%s cannot be written", qPrintable(name));
        file.write("QGC WPL 110\n"
                   "0\t1\t0\t16\t0\t0\t0\t0\t47.39774\t8.54559\t488\t1\n"
                   "1\t0\t3\t16\t0\t0\t0\t0\t47.60000\t8.54559\t20\t1\n");
        return name;
    }

    void runSweep()
    {
        find<QAction>("actionSweep")->trigger();
        auto *dialog = m_window->findChild<SweepDialog *>();
        QVERIFY(dialog);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        EVENTUALLY(!m_window->findChild<SweepDialog *>());
    }

    bool isAsked(const char *name) const { return m_window->findChild<QMessageBox *>(QLatin1String(name)) != nullptr; }
    QMessageBox *question(const char *name) const { return find<QMessageBox>(name); }

    FakeSweep m_sweeps;
};

SKYSEAL_TEST_WIDGETS(ArmedQuestionsTest)
#include "armed_questions_test.moc"
