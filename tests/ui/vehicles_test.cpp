// The list of all vehicles: what it says of each, its order and filter, and the selection by mouse and keyboard. Fifty vehicles
// cost only what changes. Other panels name the vehicle that they read and write.
#include "scripted_snapshots.h"
#include "tests/support/test_runner.h"
#include "ui/status/strip_item.h"
#include "ui/vehicles/vehicles_panel.h"
#include "window_rig.h"

#include <QtTest/QAbstractItemModelTester>
#include <QtTest/QSignalSpy>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

using Row = VehicleListRow;

/// Sealed vehicles that differ in battery and kind: every second one is a rover, every fifth one disarmed.
engine::Snapshot fleet(double time, int count)
{
    engine::Snapshot snapshot = sealedSnapshot(time);
    const engine::VehicleSnapshot one = snapshot.vehicles.front();
    snapshot.vehicles.clear();
    for (int i = 1; i <= count; ++i) {
        engine::VehicleSnapshot &made = snapshot.vehicles.emplace_back(one);
        made.state.systemId = static_cast<std::uint8_t>(i);
        made.state.type = i % 2 ? mavlink::MAV_TYPE_QUADROTOR : mavlink::MAV_TYPE_GROUND_ROVER;
        made.state.armed = i % 5 != 0;
        made.state.batteryPercent = 30 + (i * 7) % 60;
    }
    return snapshot;
}

ViewState viewOfVehicle(const engine::Snapshot &snapshot, std::uint8_t id)
{
    return viewOf(std::make_shared<const engine::Snapshot>(snapshot), id);
}

std::vector<VehicleListRow> rowsOf(const engine::Snapshot &snapshot, std::uint8_t selected)
{
    const auto shared = std::make_shared<const engine::Snapshot>(snapshot);
    std::vector<VehicleListRow> out;
    for (const auto &vehicle : shared->vehicles) {
        out.push_back(vehicleListRowOf(viewOf(shared, vehicle.state.systemId), {}));
        out.back().selected = vehicle.state.systemId == selected;
    }
    return out;
}

} // namespace

class VehiclesTest : public QObject, private WindowRig
{
    Q_OBJECT

private:
    QTreeView &list() const { return *find<QTreeView>("vehicleList"); }
    QLineEdit &filter() const { return *find<QLineEdit>("vehicleFilter"); }
    QString countText() const { return find<QLabel>("vehicleCount")->text(); }
    std::uint8_t selected() const { return m_window->view().vehicle->state.systemId; }

    /// The numbers of the vehicles, from above.
    QList<int> order() const
    {
        QList<int> out;
        for (int row = 0; row < list().model()->rowCount(); ++row)
            out << list().model()->index(row, 0).data(VehicleListModel::SystemIdRole).toInt();
        return out;
    }

    QPoint placeOf(int systemId, int column = Row::Mode) const
    {
        const auto row = static_cast<int>(order().indexOf(systemId));
        return list().visualRect(list().model()->index(row, column)).center();
    }

    void clickColumn(int column) const
    {
        QHeaderView *header = list().header();
        const QPoint middle(header->sectionViewportPosition(column) + header->sectionSize(column) / 2, header->height() / 2);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, middle);
    }

    void reveal() const
    {
        find<QDockWidget>("dockVehicles")->raise();
        EVENTUALLY(m_window->findChild<VehiclesPanel *>()->isExposed());
    }

private Q_SLOTS:
    void init()
    {
        setUp();
        QTest::mouseMove(m_window.get(), QPoint(2, 2)); // not over the list
    }
    void cleanup() { tearDown(); }

    void rowSaysHowAVehicleIs()
    {
        engine::Snapshot snapshot = fleet(1, 2);
        snapshot.vehicles[0].state.batteryPercent = 12;
        snapshot.vehicles[0].state.firmware = "ArduCopter 4.7.0";
        snapshot.vehicles[0].state.components = {{.id = 100, .type = mavlink::MAV_TYPE_CAMERA},
                                                 {.id = 154, .type = mavlink::MAV_TYPE_GIMBAL},
                                                 {.id = 191, .type = mavlink::MAV_TYPE_GENERIC}};
        const auto alert = [](AlertKind kind, std::uint8_t systemId, AlertSeverity severity) {
            return Alert{.id = {kind, systemId}, .severity = severity, .text = {}, .details = {}};
        };
        const std::vector<Alert> alerts{alert(AlertKind::LowBattery, 1, AlertSeverity::Severe),
                                        alert(AlertKind::ModeChanged, 1, AlertSeverity::Information),
                                        alert(AlertKind::ModeChanged, 2, AlertSeverity::Information)};
        const Row row = vehicleListRowOf(viewOfVehicle(snapshot, 1), alerts);
        QCOMPARE(row[Row::Vehicle].text, QStringLiteral("1 · air-1"));
        QCOMPARE(row[Row::Kind].tip, QStringLiteral("ArduCopter 4.7.0\ncamera 100\ngimbal 154\ncompanion computer 191"));
        QCOMPARE(row[Row::Mode].text, QStringLiteral("GUIDED"));
        QCOMPARE(row[Row::Armed].text, QStringLiteral("Armed"));
        QCOMPARE(row[Row::Battery].text, QStringLiteral("12 % · low"));
        QVERIFY(row[Row::Battery].tone == CellTone::Alarm);
        QCOMPARE(row[Row::Link].text, QStringLiteral("100 %"));
        QCOMPARE(row[Row::LastFrame].text, QStringLiteral("< 1 s"));
        QCOMPARE(row[Row::Lock].text, QStringLiteral("Sealed · ChaCha20-Poly1305"));
        QCOMPARE(row[Row::Alerts].text, QStringLiteral("2 · severe"));

        snapshot.vehicles[1].session.reset();
        snapshot.vehicles[1].state.messageAge = 12.6;
        snapshot.vehicles[1].state.batteryPercent = vehicle::kUnknown;
        const Row old = vehicleListRowOf(viewOfVehicle(snapshot, 2), alerts);
        QCOMPARE(old[Row::Vehicle].text, QStringLiteral("2"));
        QCOMPARE(old[Row::Battery].text, QStringLiteral("–"));
        QCOMPARE(old[Row::Link].text, QStringLiteral("lost"));
        QCOMPARE(old[Row::LastFrame].text, QStringLiteral("12 s"));
        QCOMPARE(old[Row::Lock].text, QStringLiteral("Not sealed"));
        QVERIFY(old[Row::Mode].tone == CellTone::Dim);
        QCOMPARE(old[Row::Alerts].text, QStringLiteral("1 · notice"));
    }

    void modelIsSoundAndNotifiesWhatChanges()
    {
        VehicleListModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        VehicleListOrder order;
        QAbstractItemModelTester orderTester(&order, QAbstractItemModelTester::FailureReportingMode::QtTest);
        order.setSourceModel(&model);
        order.sort(Row::Battery);
        model.setVehicles(rowsOf(fleet(1, 50), 1));
        order.renew();
        QCOMPARE(order.rowCount(), 50);

        QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
        QSignalSpy moved(&order, &QAbstractItemModel::layoutChanged);
        for (int frame = 0; frame < 10; ++frame) // all fifty move, but none of these cells looks different
            model.setVehicles(rowsOf(fleet(1 + frame * 0.1, 50), 1));
        QCOMPARE(changed.size(), 0);
        engine::Snapshot next = fleet(2, 50);
        enterMode(next.vehicles[6].state, "RTL");
        next.vehicles[6].state.batteryPercent = 19;
        model.setVehicles(rowsOf(next, 1));
        QCOMPARE(changed.size(), 2);
        QCOMPARE(changed.back().at(0).toModelIndex(), model.index(6, Row::Battery));
        changed.clear();
        model.setVehicles(rowsOf(next, 2));
        QCOMPARE(changed.size(), 2 * Row::Columns); // the mark is of a whole row
        QCOMPARE(moved.size(), 0);
        QVERIFY(order.isOutdated());

        next.vehicles.erase(next.vehicles.begin() + 3, next.vehicles.begin() + 9);
        model.setVehicles(rowsOf(next, 1));
        QCOMPARE(model.rowCount(), 44);
        model.setVehicles(rowsOf(fleet(3, 50), 1)); // they come back below the others
        QCOMPARE(model.rowOf(4), 44);
        order.renew();
        QVERIFY(!order.isOutdated());
        model.setVehicles({});
        QCOMPARE(order.rowCount(), 0);
    }

    void clickSelectsForTheWholeWindow()
    {
        m_station->show(fleet(1, 50));
        reveal();
        QCOMPARE(selected(), std::uint8_t(1));
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOf(3));
        QCOMPARE(selected(), std::uint8_t(3));
        QCOMPARE(find<StripItem>("stripVehicle")->text(), QStringLiteral("Vehicle 3"));
        // More than a colour: bold, a shape, and a word for screen readers.
        const QModelIndex own = list().model()->index(static_cast<int>(order().indexOf(3)), 0);
        QVERIFY(own.data(Qt::FontRole).value<QFont>().bold());
        QVERIFY(!own.siblingAtRow(0).data(Qt::FontRole).value<QFont>().bold());
        QCOMPARE(own.data(Qt::AccessibleTextRole).toString(), QStringLiteral("Vehicle 3 · air-1, selected"));
        const auto shape = [](const QModelIndex &at) {
            return at.data(Qt::DecorationRole).value<QIcon>().pixmap(16, 16).toImage();
        };
        QVERIFY(shape(own) != shape(own.siblingAtRow(0)));
        QCOMPARE(shape(own).size(), shape(own.siblingAtRow(0)).size()); // the text does not move
    }

    void tipOfTheBatteryListsAll()
    {
        engine::Snapshot snapshot = fleet(1, 1);
        snapshot.vehicles[0].state.batteries = {{.id = 0, .voltage = 22.84, .current = 12.5, .percent = 61},
                                                {.id = 1, .function = mavlink::MAV_BATTERY_FUNCTION_PAYLOAD, .voltage = 12.1}};
        m_station->show(snapshot);
        QString tip = find<StripItem>("stripBattery")->toolTip();
        QCOMPARE(tip.replace(QChar::Nbsp, QLatin1Char(' ')),
                 QStringLiteral("Battery 1: 22.8 V · 12.5 A · 61 %\nBattery 2 (payload): 12.1 V · – A · – %"));
    }

    void enterSelectsAndArrowsDoNot()
    {
        m_station->show(fleet(1, 50));
        QTest::mouseClick(find<StripItem>("stripVehicle"), Qt::LeftButton);
        QVERIFY(list().hasFocus());
        QTest::keyClick(&list(), Qt::Key_Down);
        QTest::keyClick(&list(), Qt::Key_Down);
        QCOMPARE(selected(), std::uint8_t(1)); // commands still go there
        QTest::keyClick(&list(), Qt::Key_Return);
        QCOMPARE(selected(), std::uint8_t(3));
    }

    void typingFilters()
    {
        engine::Snapshot snapshot = fleet(1, 50);
        enterMode(snapshot.vehicles[41].state, "RTL");
        m_station->show(snapshot);
        reveal();
        list().setFocus();
        QTest::keyClicks(&list(), QStringLiteral("r"));
        QTest::keyClicks(&filter(), QStringLiteral("tl"));
        QCOMPARE(filter().text(), QStringLiteral("rtl"));
        QCOMPARE(order(), QList<int>{42});
        QCOMPARE(countText(), QStringLiteral("1 of 50"));
        QTest::keyClick(&filter(), Qt::Key_Enter);
        QCOMPARE(selected(), std::uint8_t(42));
        QTest::keyClick(&filter(), Qt::Key_Escape);
        QCOMPARE(order().size(), 50);
        QTest::keyClicks(&filter(), QStringLiteral("rover disarmed"));
        QCOMPARE(order(), (QList<int>{10, 20, 30, 40, 50}));
        QTest::keyClick(&filter(), Qt::Key_Escape);
        QTest::keyClicks(&filter(), QStringLiteral("armed"));
        QCOMPARE(order().size(), 40); // none of those that are disarmed
        QTest::keyClick(&filter(), Qt::Key_Escape);
        QTest::keyClicks(&filter(), QStringLiteral("4"));
        QCOMPARE(order(), (QList<int>{4, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49}));
        QTest::keyClicks(&filter(), QStringLiteral("x"));
        QVERIFY(find<QLabel>("vehiclesEmpty")->isVisible());
        QVERIFY(find<QLabel>("vehiclesEmpty")->text().contains(QStringLiteral("4x")));
        QVERIFY(!find<QPushButton>("vehiclesConnect")->isVisible());
    }

    void orderFollowsTheColumnButNotUnderThePointer()
    {
        engine::Snapshot snapshot = fleet(1, 6); // 37, 44, 51, 58, 65, 72 %
        m_station->show(snapshot);
        reveal();
        QCOMPARE(order(), (QList<int>{1, 2, 3, 4, 5, 6}));
        clickColumn(Row::Battery);
        QCOMPARE(order(), (QList<int>{1, 2, 3, 4, 5, 6}));
        clickColumn(Row::Battery);
        QCOMPARE(order(), (QList<int>{6, 5, 4, 3, 2, 1}));

        QTest::mouseMove(list().viewport(), placeOf(5));
        EVENTUALLY(list().viewport()->underMouse());
        snapshot.time = 2;
        snapshot.vehicles[5].state.batteryPercent = 20; // the first one would be the last
        snapshot.vehicles.push_back(snapshot.vehicles.front());
        snapshot.vehicles.back().state.systemId = 7;
        snapshot.vehicles.back().state.batteryPercent = 99; // and a new one the first
        m_station->show(snapshot);
        QCOMPARE(order(), (QList<int>{6, 5, 4, 3, 2, 1, 7}));
        QVERIFY2(countText().contains(QStringLiteral("kept")), qPrintable(countText()));
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOf(6));
        QCOMPARE(selected(), std::uint8_t(6)); // the one that the pointer was at

        QTest::mouseMove(m_window.get(), QPoint(2, 2));
        EVENTUALLY(!list().viewport()->underMouse());
        snapshot.time = 3;
        m_station->show(snapshot);
        QCOMPARE(order(), (QList<int>{7, 5, 4, 3, 2, 1, 6}));
        QCOMPARE(countText(), QStringLiteral("7 of 7"));
    }

    void attackAndAlertsShowInTheRowOfTheirVehicle()
    {
        m_station->show(fleet(1, 3));
        reveal();
        m_station->notify(engine::PlaintextRefused{2, "192.0.2.66:40000", 5, {}});
        m_station->show(fleet(2, 3));
        const auto cell = [&](int systemId, int column) {
            return list().model()->index(static_cast<int>(order().indexOf(systemId)), column).data().toString();
        };
        QVERIFY2(cell(2, Row::Lock).startsWith(QStringLiteral("Under attack")), qPrintable(cell(2, Row::Lock)));
        QVERIFY(cell(1, Row::Lock).startsWith(QStringLiteral("Sealed")));
        QCOMPARE(cell(2, Row::Alerts), QStringLiteral("1 · warning"));
        QCOMPARE(cell(1, Row::Alerts), QStringLiteral("–"));
    }

    void lostVehicleIsRemovedFromTheList()
    {
        const auto *remove = find<QPushButton>("vehicleRemove");
        engine::Snapshot snapshot = fleet(1, 3);
        m_station->show(snapshot);
        reveal();
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOf(2));
        QVERIFY(!remove->isEnabled());
        QVERIFY(remove->toolTip().contains(QStringLiteral("whose link is lost")));
        snapshot.time = 2;
        snapshot.vehicles[1].state.lost = true;
        snapshot.vehicles[1].state.messageAge = 3600;
        m_station->show(snapshot);
        EVENTUALLY(remove->isEnabled());
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOf(3));
        QVERIFY(!remove->isEnabled()); // it is heard
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOf(2));
        QTest::mouseClick(find<QPushButton>("vehicleRemove"), Qt::LeftButton);
        QCOMPARE(m_station->forgotten, std::vector<std::uint8_t>{2});
    }

    void emptyListSaysWhatToDo()
    {
        m_station->show(waitingSnapshot());
        reveal();
        QVERIFY(find<QLabel>("vehiclesEmpty")->isVisible());
        QVERIFY(find<QPushButton>("vehiclesConnect")->isVisible());
        QTest::mouseClick(find<QPushButton>("vehiclesConnect"), Qt::LeftButton);
        QVERIFY(m_window->findChild<QWidget *>(QStringLiteral("linkDialog")));
    }

    void panelsNameTheVehicleAmongSeveral()
    {
        m_station->show(fleet(1, 1));
        auto *fetch = find<QPushButton>("parameterFetch"), *read = find<QPushButton>("missionRead"),
             *send = find<QPushButton>("missionSend");
        QCOMPARE(fetch->text(), QStringLiteral("Fetch"));
        QCOMPARE(read->text(), QStringLiteral("Read from the vehicle"));
        const auto header = [&] { return find<QTreeView>("parameterView")->model()->headerData(1, Qt::Horizontal).toString(); };
        QCOMPARE(header(), QStringLiteral("Value"));
        find<QDockWidget>("dockMission")->raise();
        EVENTUALLY(send->isVisible() && send->visibleRegion().contains(send->rect().center()));
        const int width = send->width();
        m_station->show(fleet(2, 3));
        reveal();
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, placeOf(2));
        QCOMPARE(fetch->text(), QStringLiteral("Fetch · 2"));
        QCOMPARE(fetch->accessibleName(), QStringLiteral("Fetch the parameters, vehicle 2"));
        QCOMPARE(read->text(), QStringLiteral("Read from the vehicle · 2"));
        QCOMPARE(send->text(), QStringLiteral("Send a file… · 2"));
        QCOMPARE(header(), QStringLiteral("Value · vehicle 2"));
        QCOMPARE(send->width(), width);
    }

    void parametersThatMatchAreCounted()
    {
        m_station->show(sealedSnapshot(1));
        const auto *count = find<QLabel>("parameterCount");
        QCOMPARE(count->text(), QStringLiteral("12 of 12"));
        QTest::keyClicks(find<QLineEdit>("parameterFilter"), QStringLiteral("fs_"));
        QCOMPARE(find<QTreeView>("parameterView")->model()->rowCount(), 2);
        QCOMPARE(count->text(), QStringLiteral("2 of 12"));
    }

    /// A value that is being typed must not reach the vehicle that is selected meanwhile.
    void typedParameterDoesNotGoToAnotherVehicle()
    {
        m_station->show(fleet(1, 2));
        auto *view = find<QTreeView>("parameterView");
        const QModelIndex value = view->model()->index(0, 1);
        view->setCurrentIndex(value);
        view->setFocus();
        QTest::keyClick(view, Qt::Key_F2);
        auto *editor = view->findChild<QLineEdit *>();
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral("7"));
        auto *menu = find<QMenu>("menuChooseVehicle");
        Q_EMIT menu->aboutToShow(); // it fills itself then
        menu->actions().at(1)->trigger();
        QCOMPARE(selected(), std::uint8_t(2));
        if (auto *still = view->findChild<QLineEdit *>())
            QTest::keyClick(still, Qt::Key_Return);
        QVERIFY(m_station->written.empty());
    }
};

SKYSEAL_TEST_WIDGETS(VehiclesTest)
#include "vehicles_test.moc"
