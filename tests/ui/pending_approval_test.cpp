// A plain vehicle that may be an impostor of a known agent: it is named in strip, panel and map, commands are disabled, and it
// is accepted only after a confirmation that explains the consequences.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "ui/security/allow_plain.h"
#include "ui/status/strip_item.h"
#include "window_rig.h"

#include <QtCore/QDir>
#include <QtWidgets/QLabel>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class PendingApprovalTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void pendingVehicleWaitsForTheOperator()
    {
        QVERIFY(!find<QWidget>("allowPlainButton")->isVisible());
        m_station->show(pendingApprovalSnapshot());
        QVERIFY(find<QLabel>("emptyTitle")->text().contains(QStringLiteral("Vehicle 1 is not sealed")));
        QVERIFY(find<QLabel>("emptyText")->text().contains(QStringLiteral("impersonating air-1")));
        QVERIFY(find<StripItem>("stripLock")->text().contains(QStringLiteral("Not sealed")));
        QVERIFY(find<StripItem>("stripLock")->toolTip().contains(QStringLiteral("air-1")));
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Not sealed, needs approval"));
        for (const char *name : {"armButton", "takeOffButton", "landButton", "setModeButton"}) {
            QVERIFY2(!find<HoldButton>(name)->isEnabled(), name);
            QVERIFY2(find<HoldButton>(name)->toolTip().contains(QStringLiteral("not sealed")), name);
        }

        // Approval by the button or the menu opens a question whose default answer is Cancel.
        const auto *button = find<QPushButton>("allowPlainButton");
        QVERIFY(button->isVisible() && button->text().contains(QStringLiteral("vehicle 1")));
        QTest::mouseClick(find<QPushButton>("allowPlainButton"), Qt::LeftButton);
        auto *box = find<QMessageBox>("confirmPlain");
        QCOMPARE(static_cast<QWidget *>(box->defaultButton()), static_cast<QWidget *>(box->button(QMessageBox::Cancel)));
        QTest::keyClick(box, Qt::Key_Escape);
        EVENTUALLY(!m_window->findChild<QMessageBox *>(QStringLiteral("confirmPlain")));
        QVERIFY(m_station->allowedClear.empty());
        auto *menu = find<QMenu>("menuAllowPlain");
        Q_EMIT find<QMenu>("menuSecurity")->aboutToShow();
        QVERIFY(menu->menuAction()->isEnabled());
        Q_EMIT menu->aboutToShow();
        QCOMPARE(menu->actions().size(), 1);
        menu->actions().front()->trigger();
        QTest::mouseClick(find<QMessageBox>("confirmPlain")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_station->allowedClear, std::vector<std::uint8_t>{1});

        engine::Snapshot taken = plainSnapshot(2);
        m_station->show(taken);
        QVERIFY(find<HoldButton>("armButton")->isEnabled());
        QVERIFY(!find<QWidget>("emptyState")->isVisible());
        Q_EMIT find<QMenu>("menuSecurity")->aboutToShow();
        QVERIFY(!menu->menuAction()->isEnabled());

        // One that was taken before its agent became known is flown no further.
        taken.time = 3;
        taken.pendingApproval = pendingApprovalSnapshot().pendingApproval;
        m_station->show(taken);
        QVERIFY(!find<HoldButton>("armButton")->isEnabled());

        // Beside another vehicle the banner says it.
        engine::Snapshot sealed = sealedSnapshot(4);
        sealed.vehicles.front().state.systemId = 2;
        sealed.pendingApproval = taken.pendingApproval;
        m_station->show(sealed);
        QVERIFY(find<HoldButton>("armButton")->isEnabled());
        m_station->notify(engine::PlaintextRefused{1, "192.0.2.66:40000", 1, "air-1"});
        QVERIFY(find<QWidget>("problemBanner")->isVisible());
        QVERIFY(find<QLabel>("problemText")->text().contains(QStringLiteral("impersonating air-1")));
        EVENTUALLY(!m_window->findChild<QMessageBox *>(QStringLiteral("confirmPlain"))); // the question before
        QTest::mouseClick(find<QPushButton>("problemRemedy"), Qt::LeftButton);
        QTest::mouseClick(find<QMessageBox>("confirmPlain")->button(QMessageBox::Yes), Qt::LeftButton);
        QCOMPARE(m_station->allowedClear.size(), std::size_t(2));
    }

    void sessionWithoutAVehicleHidesNothing()
    {
        engine::Snapshot snapshot = sealedSnapshot(1);
        snapshot.vehicles.clear();
        snapshot.pendingApproval = pendingApprovalSnapshot().pendingApproval;
        m_station->show(snapshot);
        QVERIFY(find<QLabel>("emptyTitle")->text().contains(QStringLiteral("Waiting for the autopilot behind air-1")));
        m_station->notify(engine::PlaintextRefused{1, "192.0.2.66:40000", 1, "air-1"});
        QVERIFY(find<QWidget>("problemBanner")->isVisible());
        QVERIFY(find<QLabel>("problemText")->text().contains(QStringLiteral("impersonating air-1")));
    }

    void lockPanelAndMiddleSayTheSame()
    {
        engine::Snapshot snapshot = pendingApprovalSnapshot();
        snapshot.unanswering.push_back({"air-1", "192.0.2.7:40000", "SHA256:own", 4});
        m_station->show(snapshot);
        QVERIFY2(find<StripItem>("stripLock")->text().contains(QStringLiteral("needs approval")),
                 qPrintable(find<StripItem>("stripLock")->text()));
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Not sealed, needs approval"));
        QVERIFY(find<QLabel>("emptyTitle")->text().contains(QStringLiteral("Vehicle 1 is not sealed")));
        QVERIFY(find<QPushButton>("secureHelp")->isVisible());
        QVERIFY(!find<QPushButton>("secureKeys")->isVisible());
    }

    void consentIsForTheSystemIdFromAnyAddress()
    {
        askAllowPlain(*m_station, {1, "192.0.2.66:40000", "air-1, air-2"}, m_window.get());
        auto *box = find<QMessageBox>("confirmPlain");
        const QString words = box->informativeText();
        QVERIFY2(words.contains(QStringLiteral("claims to be vehicle 1, from any address")), qPrintable(words));
        QVERIFY2(words.contains(QStringLiteral("the vehicle of air-1 or air-2")), qPrintable(words));
        for (const auto answer : {QMessageBox::Yes, QMessageBox::Cancel})
            QVERIFY(box->button(answer)->icon().isNull()); // none of them is recommended by a picture
        if (const QString folder = qEnvironmentVariable("SKYSEAL_PICTURES"); !folder.isEmpty()) {
            QVERIFY(QTest::qWaitForWindowExposed(box, test::kDeadlineMs) && QDir().mkpath(folder));
            QVERIFY(box->grab().save(QDir(folder).filePath(QStringLiteral("confirm-plain.png"))));
        }
        box->close();
    }

    void severalNamesReadAsOneSentence()
    {
        engine::Snapshot snapshot = pendingApprovalSnapshot();
        snapshot.pendingApproval.front().mayBe = "air-1, air-2, air-3";
        m_station->show(snapshot);
        const QString names = QStringLiteral("air-1, air-2 or air-3");
        for (const char *label : {"emptyText", "secureAdvice"})
            QVERIFY2(find<QLabel>(label)->text().contains(names), qPrintable(find<QLabel>(label)->text()));
        QVERIFY(find<StripItem>("stripLock")->toolTip().contains(names));
    }
};

SKYSEAL_TEST_WIDGETS(PendingApprovalTest)
#include "pending_approval_test.moc"
