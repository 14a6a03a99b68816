// The checklist before a flight: ticked by mouse, keys or the values of the vehicle, remembered for each vehicle, asked about
// before Arm, and open again after the flight.
#include "confirm_question.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "ui/flight/pre_arm_dialog.h"
#include "ui/flight/vehicle_commands.h"
#include "window_rig.h"

#include <QtCore/QFile>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class ChecklistBoxTest : public QObject, private WindowRig
{
    Q_OBJECT

private:
    /// On the ground, with a full battery.
    void showLanded(double time, const ChangeState &change = {})
    {
        m_station->showSealed(time, [&change](auto &state) {
            state.armed = false;
            state.batteryPercent = 95;
            if (change)
                change(state);
        });
    }

    QString write(const char *text) const
    {
        const QString path = m_folder->filePath(QStringLiteral("quad.txt"));
        QFile out(path);
        if (!out.open(QIODevice::WriteOnly) || out.write(text) < 0)
            qFatal("cannot write %s", qPrintable(path));
        return path;
    }

    /// By the file dialog.
    void choose(const QString &file) const
    {
        QTest::mouseClick(find<QPushButton>("checklistChoose"), Qt::LeftButton);
        auto *dialog = m_window->findChild<QFileDialog *>();
        QVERIFY(dialog);
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(file);
        QMetaObject::invokeMethod(dialog, "accept");
        EVENTUALLY(!m_window->findChild<QFileDialog *>());
    }

    void openList() const { QTest::mouseClick(find<QPushButton>("preArmButton"), Qt::LeftButton); }
    QListWidget &list() const { return *find<QListWidget>("checklist"); }
    bool isChecked(int row) const { return list().item(row)->checkState() == Qt::Checked; }
    QString title() const { return find<QLabel>("checklistTitle")->text(); }

    void clickBox(int row) const
    {
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                          list().visualItemRect(list().item(row)).topLeft()
                              + QPoint(10, list().visualItemRect(list().item(row)).height() / 2));
    }

    void holdArm() const
    {
        auto *arm = find<HoldButton>("armButton");
        const auto presses = [arm] { // a press just after a command has no effect
            QTest::mousePress(arm, Qt::LeftButton);
            if (!arm->isHeld())
                QTest::mouseRelease(arm, Qt::LeftButton);
            return arm->isHeld();
        };
        EVENTUALLY(presses());
        EVENTUALLY(!arm->isHeld());
        QTest::mouseRelease(arm, Qt::LeftButton);
    }

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void itemsAreTickedByHandAndByValues()
    {
        showLanded(1, [](auto &state) { state.batteryPercent = 80; });
        openList();
        QVERIFY(!list().isVisible());
        QVERIFY2(title().contains(QStringLiteral("vehicle 1")), qPrintable(title()));
        choose(write("Propellers tight\nArea clear\nBattery full [battery_percent>=90]\n"));
        QVERIFY(list().isVisible());
        QCOMPARE(title(), QStringLiteral("Checklist quad.txt: 0 of 3 done"));
        clickBox(0);
        QVERIFY(isChecked(0));
        list().setCurrentRow(1);
        list().setFocus();
        QTest::keyClick(&list(), Qt::Key_Space);
        QVERIFY(isChecked(1));
        clickBox(2); // the vehicle answers it
        QVERIFY(!isChecked(2));
        QVERIFY2(list().item(2)->text().contains(QStringLiteral("not yet: battery_percent>=90")),
                 qPrintable(list().item(2)->text()));
        QCOMPARE(title(), QStringLiteral("Checklist quad.txt: 2 of 3 done"));
        showLanded(2);
        QVERIFY(isChecked(2));
        QVERIFY(list().item(2)->text().contains(QStringLiteral("automatic")));
        showLanded(3, [](auto &state) { state.messageAge = 12; });
        QVERIFY(!isChecked(2)); // nobody knows
        clickBox(0);
        QVERIFY(!isChecked(0));
    }

    void armAsksWhileSomethingIsOpen()
    {
        showLanded(1);
        openList();
        choose(write("Propellers tight\nBattery full [battery_percent>=90]\n"));
        holdArm();
        auto *box = find<QMessageBox>("confirmCommand");
        QVERIFY(m_station->commands.empty());
        QVERIFY(box->informativeText().contains(QStringLiteral("Propellers tight")));
        QVERIFY(!box->informativeText().contains(QStringLiteral("Battery full")));
        QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
        QVERIFY(m_station->commands.empty());
        EVENTUALLY(!m_window->findChild<QMessageBox *>(QStringLiteral("confirmCommand")));
        find<QAction>("actionArm")->trigger(); // asks always, and says the same
        box = find<QMessageBox>("confirmCommand");
        QVERIFY(box->informativeText().contains(QStringLiteral("Propellers tight")));
        box->button(QMessageBox::Yes)->click(); // never forbids
        QCOMPARE(m_station->commands.size(), std::size_t(1));
        EVENTUALLY(!m_window->findChild<QMessageBox *>(QStringLiteral("confirmCommand")));

        clickBox(0);
        holdArm();
        QVERIFY(!m_window->findChild<QMessageBox *>(QStringLiteral("confirmCommand")));
        QCOMPARE(m_station->commands.size(), std::size_t(2));
        QVERIFY(std::holds_alternative<vehicle::Arm>(m_station->commands[1].second));
    }

    /// Holding Arm must not do nothing because another question is open, perhaps behind the window.
    void questionToArmTakesThePlaceOfAnother()
    {
        showLanded(1);
        openList();
        choose(write("Propellers tight\nArea clear\n"));
        find<QAction>("actionLand")->trigger();
        QVERIFY(test::shownQuestion(*m_window)->text().contains(QStringLiteral("Land")));
        const auto asked = [this] {
            const auto *box = test::shownQuestion(*m_window);
            return box && box->text().contains(QStringLiteral("checklist")) ? box->informativeText() : QString();
        };
        holdArm();
        EVENTUALLY(asked().contains(QStringLiteral("Propellers tight")));
        clickBox(0); // the question says what is open when it was asked last
        holdArm();
        EVENTUALLY(!asked().isEmpty() && !asked().contains(QStringLiteral("Propellers tight")));
        QVERIFY(asked().contains(QStringLiteral("Area clear")));
        QVERIFY(m_station->commands.empty());
    }

    void ticksEndWithTheFlight()
    {
        showLanded(1);
        openList();
        choose(write("Propellers tight\n"));
        clickBox(0);
        m_station->showSealed(2); // armed
        QVERIFY(isChecked(0));
        showLanded(3);
        QVERIFY(!isChecked(0));
    }

    void eachVehicleHasItsOwnAndItIsRemembered()
    {
        showLanded(1);
        openList();
        const QString file = write("Propellers tight\nBattery [volts>3]\n");
        choose(file);
        const QString problem = find<QLabel>("checklistProblems")->text();
        QVERIFY2(problem.startsWith(QStringLiteral("quad.txt:2:10: expected a field's name")), qPrintable(problem));
        showLanded(2, [](auto &state) { state.systemId = 2; });
        QVERIFY(!list().isVisible());
        QVERIFY(title().contains(QStringLiteral("vehicle 2")));

        open(); // the program starts again
        showLanded(3);
        openList();
        QCOMPARE(title(), QStringLiteral("Checklist quad.txt: 0 of 2 done"));
        QTest::mouseClick(find<QPushButton>("checklistRemove"), Qt::LeftButton);
        QVERIFY(!list().isVisible());
        open();
        showLanded(4);
        openList();
        QVERIFY(!list().isVisible());
    }

    void lostFileIsSaidAndAskedAbout()
    {
        showLanded(1);
        openList();
        const QString file = write("Propellers tight\n");
        choose(file);
        QVERIFY(QFile::remove(file));
        open();
        showLanded(2);
        holdArm();
        QVERIFY(find<QMessageBox>("confirmCommand")->informativeText().contains(QStringLiteral("cannot be read")));
        openList();
        QVERIFY(find<QLabel>("checklistProblems")->text().contains(file + QStringLiteral(" cannot be read: ")));
    }
};

SKYSEAL_TEST_WIDGETS(ChecklistBoxTest)
#include "checklist_box_test.moc"
