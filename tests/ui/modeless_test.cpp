// No dialog keeps the pilot from Land and RTL: each is opened as an operator does, and the window commands beside it.
#include "fake_keyring.h"
#include "fake_pairing.h"
#include "fake_sweep.h"
#include "gallery_dialogs.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "window_rig.h"

#include <QtCore/QFile>
#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class ModelessTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_keyring = std::make_unique<FakeKeyring>();
        m_sweep = std::make_unique<FakeSweep>();
        m_window->setKeyring(*m_keyring);
        m_window->setSweep(*m_sweep);
        m_station->showSealed(1);
    }
    void cleanup() { tearDown(); }

    void landIsReachable_data()
    {
        QTest::addColumn<QKeySequence>("keys");
        QTest::addColumn<QString>("action");
        QTest::newRow("link") << QKeySequence(Qt::Key_F12) << QString();
        QTest::newRow("keys") << QKeySequence(Qt::CTRL | Qt::Key_P) << QString();
        QTest::newRow("sweep") << QKeySequence(Qt::CTRL | Qt::Key_R) << QString();
        QTest::newRow("settings") << QKeySequence() << QStringLiteral("actionSettings");
        QTest::newRow("take-off") << QKeySequence() << QStringLiteral("actionTakeOff");
        QTest::newRow("question") << QKeySequence() << QStringLiteral("actionDisarm");
        QTest::newRow("replay") << QKeySequence(QKeySequence::Open) << QString();
        QTest::newRow("about") << QKeySequence() << QStringLiteral("actionAbout");
        QTest::newRow("mission file") << QKeySequence() << QStringLiteral("missionSend");
        QTest::newRow("checklist") << QKeySequence() << QStringLiteral("preArmButton");
        QTest::newRow("picture of the charts") << QKeySequence() << QStringLiteral("chartPicture");
        QTest::newRow("file of the charts") << QKeySequence() << QStringLiteral("chartCsv");
    }

    void landIsReachable()
    {
        QFETCH(QKeySequence, keys);
        QFETCH(QString, action);
        if (action.isEmpty())
            QTest::keySequence(m_window.get(), keys);
        else if (auto *entry = m_window->findChild<QAction *>(action))
            entry->trigger();
        else
            QTest::mouseClick(find<QWidget>(qPrintable(action)), Qt::LeftButton);
        EVENTUALLY(openDialogs() == 1);
        EVENTUALLY(
            qobject_cast<QDialog *>(QApplication::activeWindow())); // the window loses the focus, which would abort a hold
        QVERIFY(!QApplication::activeModalWidget());
        auto *land = find<HoldButton>("landButton");
        QTest::mousePress(land, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::mouseRelease(land, Qt::LeftButton);
        QCOMPARE(openDialogs(), 1);
    }

    void noDialogIsModal_data()
    {
        QTest::addColumn<QString>("state");
        for (const QString &state : dialogStates()) // of each class: see accessible_names_test
            QTest::newRow(qPrintable(state)) << state;
    }
    void noDialogIsModal()
    {
        QFETCH(QString, state);
        FakePairing pairing;
        fillKeyring(*m_keyring);
        const std::unique_ptr<QWidget> dialog(openDialog(state, *m_window, *m_keyring, pairing));
        QVERIFY(dialog->isVisible());
        QVERIFY(!dialog->isModal());
        QVERIFY(!QApplication::activeModalWidget());
    }

    void fileIsReplacedOnlyIfConfirmed()
    {
        const QString path = m_folder->filePath(QStringLiteral("samples.csv"));
        const auto content = [&path] {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("none");
        };
        QFile old(path);
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        for (const auto answer : {QMessageBox::Cancel, QMessageBox::Yes}) {
            find<QAction>("chartCsv")->trigger();
            nameFile(path);
            EVENTUALLY(openDialogs() == 1);
            QVERIFY(!QApplication::activeModalWidget());
            auto *box = find<QMessageBox>("replaceFile");
            QVERIFY(box->text().contains(QStringLiteral("samples.csv")));
            QCOMPARE(content(), QByteArray("old"));
            QTest::mouseClick(box->button(answer), Qt::LeftButton);
            EVENTUALLY(!m_window->findChild<QMessageBox *>());
            QCOMPARE(content() == "old", answer == QMessageBox::Cancel);
        }
    }

    void failureToWriteIsToldBeside()
    {
        find<QAction>("chartCsv")->trigger();
        nameFile(m_folder->filePath(QStringLiteral("no <b>such</b> folder/samples.csv")));
        EVENTUALLY(m_window->findChild<QMessageBox *>());
        QVERIFY(!QApplication::activeModalWidget());
        const auto *box = m_window->findChild<QMessageBox *>();
        QVERIFY2(box->text().contains(QStringLiteral("<b>such</b>")), qPrintable(box->text()));
        QCOMPARE(box->textFormat(), Qt::PlainText);
    }

    void missingFileIsToldBeside()
    {
        QTest::mouseClick(find<QPushButton>("missionSend"), Qt::LeftButton);
        nameFile(m_folder->filePath(QStringLiteral("missing.waypoints")));
        EVENTUALLY(openDialogs() == 0);
        QVERIFY(m_station->missionWrites.empty());
        QVERIFY(find<QLabel>("missionResult")->text().contains(QStringLiteral("missing.waypoints cannot be read: ")));
    }

    void openDialogComesToTheFront()
    {
        QTest::keyClick(m_window.get(), Qt::Key_F12);
        EVENTUALLY(openDialogs() == 1);
        QTest::keyClick(m_window.get(), Qt::Key_F12);
        QCOMPARE(openDialogs(), 1);
    }

    /// Settings that changed in the panels while the dialog was open stay as they are.
    void settingsKeepWhatThePanelsSet()
    {
        find<QAction>("actionSettings")->trigger();
        find<QDoubleSpinBox>("takeOffAltitude")->setValue(42);
        auto *units = find<QComboBox>("settingUnits");
        units->setCurrentIndex(1 - units->currentIndex());
        auto *buttons = find<QDialog>("settingsDialog")->findChild<QDialogButtonBox *>();
        QTest::mouseClick(buttons->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QCOMPARE(m_window->settings().units, UnitSystem::Imperial);
        QCOMPARE(m_window->settings().takeOffAltitude, 42.0);
    }

private:
    void nameFile(const QString &path) const
    {
        auto *dialog = m_window->findChild<QFileDialog *>();
        QVERIFY(dialog);
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(path);
        QMetaObject::invokeMethod(dialog, "accept");
    }

    int openDialogs() const
    {
        int open = 0;
        for (const QDialog *dialog : m_window->findChildren<QDialog *>())
            open += dialog->isVisible();
        return open;
    }

    std::unique_ptr<FakeKeyring> m_keyring;
    std::unique_ptr<FakeSweep> m_sweep;
};

SKYSEAL_TEST_WIDGETS(ModelessTest)
#include "modeless_test.moc"
