// The lock of the status strip by real input: what it says of the secure link opens beside it and leaves the map as it is.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "ui/security/link_popover.h"
#include "ui/status/strip_item.h"
#include "window_rig.h"

#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class LinkPopoverTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_store->setValue(QStringLiteral("window/workspace"), QStringLiteral("fly"));
        open(); // with the docks of Fly alone
        m_station->show(sealedSnapshot(++m_time));
    }
    void cleanup() { tearDown(); }

    void clickOpensItBesideTheLock()
    {
        const QRect map = mapArea();
        clickLock();
        QVERIFY(popover()->isVisible() && !QApplication::activeModalWidget() && !QApplication::activePopupWidget());
        const QRect area = popover()->geometry();
        const QRect anchor(lock()->mapTo(m_window.get(), QPoint()), lock()->size());
        QVERIFY(m_window->rect().contains(area));
        QVERIFY(area.top() >= anchor.bottom() && area.top() < anchor.bottom() + 8);
        QVERIFY(area.left() < anchor.right() && area.right() > anchor.left());
        QCOMPARE(mapArea(), map); // no dock took its room
        const QString facts = find<QLabel>("popoverFacts")->text();
        for (const char *word : {"air-1", "ChaCha20-Poly1305", "Fingerprint"})
            QVERIFY2(facts.contains(QLatin1String(word)), word);
        clickLock();
        QVERIFY(!popover()->isVisible());
    }

    void itFollowsTheLink()
    {
        clickLock();
        engine::Snapshot attacked = sealedSnapshot(++m_time);
        attacked.sessions.front().stats.rx.forged = attacked.sessions.front().forgedLastMinute = 87;
        attacked.security = engine::Security::UnderAttack;
        m_station->show(attacked);
        EVENTUALLY(find<QLabel>("popoverFacts")->text().contains(QStringLiteral("87 forged")));
        QVERIFY(find<QLabel>("popoverTitle")->text().contains(QStringLiteral("under attack")));
        QVERIFY(popover()->isVisible());
    }

    void escapeClosesItAndGivesTheFocusBack()
    {
        openByKeys();
        QVERIFY(popover()->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!popover()->isVisible());
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget *>(lock()));
    }

    void clickElsewhereClosesItAndStillCounts()
    {
        clickLock();
        QTest::mouseClick(find<QWidget>("stripVehicle"), Qt::LeftButton);
        QVERIFY(!popover()->isVisible());
        QVERIFY(find<QDockWidget>("dockVehicles")->isVisible()); // as without the popover
    }

    void clickInsideKeepsIt()
    {
        clickLock();
        QTest::mouseClick(find<QLabel>("popoverTitle"), Qt::LeftButton);
        QVERIFY(popover()->isVisible());
    }

    void itsButtonLeadsToThePanel()
    {
        auto *dock = find<QDockWidget>("dockSecure");
        QVERIFY(!dock->isVisible());
        openByKeys();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        EVENTUALLY(dock->isVisible());
        QVERIFY(!popover()->isVisible());
    }

    void itStaysAtTheLock()
    {
        clickLock();
        m_window->resize(1024, 700);
        const auto isBelow = [this] {
            const QRect anchor(lock()->mapTo(m_window.get(), QPoint()), lock()->size());
            const QRect area = popover()->geometry();
            return m_window->rect().contains(area) && area.top() >= anchor.bottom() && area.right() > anchor.left();
        };
        EVENTUALLY(isBelow());
    }

    void inLabThePanelIsShown()
    {
        QTest::keyClick(m_window.get(), Qt::Key_4, Qt::ControlModifier);
        clickLock();
        QVERIFY(!popover()->isVisible());
        EVENTUALLY(find<QDockWidget>("dockSecure")->isVisible());
    }

private:
    StripItem *lock() const { return find<StripItem>("stripLock"); }
    LinkPopover *popover() const { return find<LinkPopover>("linkPopover"); }
    QRect mapArea() const { return find<MapView>("map")->geometry(); }
    void clickLock() { QTest::mouseClick(lock(), Qt::LeftButton); }
    void openByKeys()
    {
        lock()->setFocus(Qt::TabFocusReason);
        QTest::keyClick(lock(), Qt::Key_Return);
        QVERIFY(popover()->isVisible());
    }

    double m_time = 0;
};

SKYSEAL_TEST_WIDGETS(LinkPopoverTest)
#include "link_popover_test.moc"
