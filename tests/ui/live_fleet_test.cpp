// Several vehicles over one real sealed link, by clicks and keys: what is commanded goes to the selected one alone, and what
// the other one reports names it.
#include "sealed_window.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/alert_row.h"
#include "ui/vehicles/vehicle_list_model.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::ui;

class LiveFleetTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { QVERIFY2(!m_failed, "an earlier step of the flight failed"); }
    void cleanup() { m_failed = m_failed || QTest::currentTestFailed(); }
    void cleanupTestCase() { m_it.reset(); }

    void bothAreListed();
    void selectedOneTakesOffAlone();
    void alertNamesTheOtherOne();
    void parameterGoesToTheSelectedOne();
    void selectedOneLandsAlone();

private:
    const vehicle::VehicleState &state(std::uint8_t systemId) const
    {
        const auto &all = m_it->view().snapshot->vehicles;
        const auto at = std::ranges::find_if(all, [&](const auto &one) { return one.state.systemId == systemId; });
        if (at == all.end())
            qFatal("no vehicle %d", systemId);
        return at->state;
    }
    std::uint8_t selected() const { return m_it->vehicle().systemId; }
    QTreeView &list() const { return *m_it->find<QTreeView>("vehicleList"); }
    QModelIndex rowOf(int systemId, int column = 0) const
    {
        const auto *model = list().model();
        for (int row = 0; row < model->rowCount(); ++row)
            if (model->index(row, 0).data(VehicleListModel::SystemIdRole).toInt() == systemId)
                return model->index(row, column);
        return {};
    }
    QString cell(int systemId, int column) const { return rowOf(systemId, column).data().toString(); }
    QString alert() const
    {
        const auto &first = m_it->find<AlertRow>("alertRow0")->alert();
        return first ? first->text : QString();
    }
    void openList() const
    {
        QTest::mouseClick(m_it->find<StripItem>("stripVehicle"), Qt::LeftButton);
        EVENTUALLY(list().isVisible() && rowOf(2).isValid());
    }

    std::unique_ptr<SealedWindow> m_it;
    bool m_failed = false;
};

void LiveFleetTest::initTestCase()
{
    m_it = std::make_unique<SealedWindow>();
    QVERIFY(m_it->open({m_it->groundLink()}));
    m_it->startVehicles({QStringLiteral("--vehicles"), QStringLiteral("2"), QStringLiteral("--rate"), QStringLiteral("2")});
    m_it->startAgent();
    EVENTUALLY(m_it->isReadyToFly());
    EVENTUALLY_EQUAL(m_it->view().snapshot->vehicles.size(), std::size_t(2));
    EVENTUALLY(state(1).home.known() && state(2).home.known());
}

void LiveFleetTest::bothAreListed()
{
    openList();
    for (const int systemId : {1, 2}) {
        EVENTUALLY_EQUAL(cell(systemId, VehicleListRow::Lock), QStringLiteral("Sealed · ChaCha20-Poly1305"));
        QCOMPARE(cell(systemId, VehicleListRow::Armed), QStringLiteral("Disarmed"));
        QCOMPARE(cell(systemId, VehicleListRow::Alerts), QStringLiteral("–"));
    }
    m_it->hands->picture(QStringLiteral("live-fleet"));
}

void LiveFleetTest::selectedOneTakesOffAlone()
{
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(rowOf(2)).center());
    EVENTUALLY_EQUAL(selected(), std::uint8_t(2));
    EVENTUALLY_EQUAL(m_it->strip("stripVehicle"), QStringLiteral("Vehicle 2"));
    EVENTUALLY2(m_it->find<HoldButton>("armButton")->accessibleName().endsWith(QStringLiteral(", vehicle 2")),
                qPrintable(m_it->find<HoldButton>("armButton")->accessibleName()));
    m_it->setMode(QStringLiteral("GUIDED"));
    m_it->hands->hold("armButton");
    EVENTUALLY(state(2).armed);
    m_it->hands->hold("takeOffButton");
    QVERIFY(m_it->flies([this] { return state(2).altitudeRelative > 9; }));
    QVERIFY(!state(1).armed);
    QVERIFY(state(1).mode != "GUIDED");
    QVERIFY(std::abs(state(1).altitudeRelative) < 1);
    EVENTUALLY_EQUAL(cell(2, VehicleListRow::Armed), QStringLiteral("Armed"));
    QCOMPARE(cell(1, VehicleListRow::Armed), QStringLiteral("Disarmed"));
}

/// The battery of the flying one runs low while the operator looks at the other one.
void LiveFleetTest::alertNamesTheOtherOne()
{
    m_it->fetchParameters();
    m_it->setParameter(QStringLiteral("SIM_BATT_VOLTAGE"), QStringLiteral("11.15"));
    m_it->show("workspace_fly");
    openList();
    list().setFocus();
    QTest::keyClick(&list(), Qt::Key_Home);
    for (int i = 0; i < 2 && list().currentIndex().row() != rowOf(1).row(); ++i)
        QTest::keyClick(&list(), Qt::Key_Down);
    QTest::keyClick(&list(), Qt::Key_Return);
    EVENTUALLY_EQUAL(selected(), std::uint8_t(1));
    EVENTUALLY2(alert().startsWith(QStringLiteral("Vehicle 2: Battery low: ")), qPrintable(alert()));
    EVENTUALLY_EQUAL(cell(2, VehicleListRow::Alerts), QStringLiteral("1 · warning"));
    QCOMPARE(cell(1, VehicleListRow::Alerts), QStringLiteral("–"));
    QVERIFY(state(1).batteryPercent > 90);
    m_it->hands->picture(QStringLiteral("live-fleet-alert"));
}

void LiveFleetTest::parameterGoesToTheSelectedOne()
{
    m_it->fetchParameters();
    m_it->setParameter(QStringLiteral("SIM_BATT_VOLTAGE"), QStringLiteral("11.4"));
    EVENTUALLY2(state(1).batteryPercent < 50, qPrintable(QString::number(state(1).batteryPercent)));
    QVERIFY(state(2).batteryPercent < 25);
    m_it->show("workspace_fly");
}

void LiveFleetTest::selectedOneLandsAlone()
{
    EVENTUALLY2(m_it->find<HoldButton>("landButton")->accessibleName().endsWith(QStringLiteral(", vehicle 1")),
                qPrintable(m_it->find<HoldButton>("landButton")->accessibleName()));
    QCOMPARE(state(2).mode, std::string("GUIDED"));
    openList();
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(rowOf(2)).center());
    EVENTUALLY(m_it->find<HoldButton>("landButton")->accessibleName().endsWith(QStringLiteral(", vehicle 2")));
    const std::string modeOfOther = state(1).mode;
    m_it->hands->hold("landButton");
    EVENTUALLY_EQUAL(state(2).mode, std::string("LAND"));
    QVERIFY(m_it->flies([this] { return !state(2).armed; }));
    QCOMPARE(state(1).mode, modeOfOther);
    QCOMPARE(m_it->view().session->stats.rx.forged, std::uint64_t(0));
}

SKYSEAL_TEST_WIDGETS(LiveFleetTest)
#include "live_fleet_test.moc"
