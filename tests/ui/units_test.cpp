// The units of the operator: figures of each system, and the window after aviation's were chosen by keys.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/flight/hold_button.h"
#include "ui/map/map_view.h"
#include "ui/map/scale_bar.h"
#include "ui/text/value_unit.h"
#include "ui/text/vehicle_text.h"
#include "ui/values/value_cell.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;

class UnitsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void figures_data()
    {
        QTest::addColumn<int>("units");
        QTest::addColumn<QStringList>("texts"); // of 100 m, 10 m/s, 2 m/s, and of 50 m, 926 m and 20 km
        QTest::newRow("metric") << 0
                                << QStringLiteral("100.0\u00a0m|10.0\u00a0m/s|2.0\u00a0m/s|50\u00a0m|926\u00a0m|20.0\u00a0km")
                                       .split(QLatin1Char('|'));
        QTest::newRow("imperial") << 1
                                  << QStringLiteral(
                                         "328\u00a0ft|22.4\u00a0mph|394\u00a0ft/min|164\u00a0ft|3038\u00a0ft|12.43\u00a0mi")
                                         .split(QLatin1Char('|'));
        QTest::newRow("aviation") << 2
                                  << QStringLiteral(
                                         "328\u00a0ft|19.4\u00a0kt|394\u00a0ft/min|164\u00a0ft|0.50\u00a0NM|10.80\u00a0NM")
                                         .split(QLatin1Char('|'));
    }

    void figures()
    {
        QFETCH(int, units);
        const auto system = static_cast<UnitSystem>(units);
        const QStringList texts{altitudeFigure(100, system).text(), speedFigure(10, system).text(),
                                climbFigure(2, system).text(),      distanceFigure(50, system).text(),
                                distanceFigure(926, system).text(), distanceFigure(20'000, system).text()};
        QTEST(texts, "texts");
        QCOMPARE(speedFigure(vehicle::kUnknown, system).value, dash());
        QCOMPARE(distanceFigure(vehicle::kUnknown, system).value, dash());
    }

    /// A value that is typed as a limit or chosen with decimals has one unit, whatever the distance.
    void valuesHaveTheirUnit()
    {
        const ValueUnit speed{.measure = Measure::Speed, .name = QStringLiteral("m/s"), .decimals = 1};
        QCOMPARE(unitName(speed, UnitSystem::Aviation), QStringLiteral("kt"));
        QCOMPARE(valueFigure(10, speed, 3, UnitSystem::Aviation).text(), QStringLiteral("19.438\u00a0kt"));
        const ValueUnit way{.measure = Measure::Distance, .name = QStringLiteral("m"), .decimals = 0};
        QCOMPARE(valueFigure(1852, way, 0, UnitSystem::Aviation).text(), QStringLiteral("6076\u00a0ft"));
        QCOMPARE(valueFigure(1852, way, -1, UnitSystem::Aviation).text(), QStringLiteral("1.00\u00a0NM"));
        const ValueUnit volts{.name = QStringLiteral("V"), .decimals = 2};
        QCOMPARE(valueFigure(12, volts, -1, UnitSystem::Aviation).text(), QStringLiteral("12.00\u00a0V"));
    }

    void scaleBarIsRound_data()
    {
        QTest::addColumn<double>("least"); // metres
        QTest::addColumn<QStringList>("texts");
        QTest::newRow("near") << 30.0 << QStringLiteral("50\u00a0m|100\u00a0ft|100\u00a0ft").split(QLatin1Char('|'));
        QTest::newRow("between") << 600.0 << QStringLiteral("1\u00a0km|2000\u00a0ft|2000\u00a0ft").split(QLatin1Char('|'));
        QTest::newRow("a mile") << 700.0 << QStringLiteral("1\u00a0km|5000\u00a0ft|0.5\u00a0NM").split(QLatin1Char('|'));
        QTest::newRow("far") << 15'000.0 << QStringLiteral("20\u00a0km|10\u00a0mi|10\u00a0NM").split(QLatin1Char('|'));
    }

    void scaleBarIsRound()
    {
        QFETCH(double, least);
        QFETCH(QStringList, texts);
        for (const UnitSystem units : {UnitSystem::Metric, UnitSystem::Imperial, UnitSystem::Aviation}) {
            const ScaleBar bar = scaleBar(least, units);
            QCOMPARE(bar.text, texts[static_cast<int>(units)]);
            QVERIFY(bar.metres >= least && bar.metres < 5.001 * least);
        }
    }

    void commandsNameTheirAltitude()
    {
        QCOMPARE(commandText(vehicle::TakeOff{10}, UnitSystem::Metric), QStringLiteral("Take off to 10\u00a0m"));
        QCOMPARE(commandText(vehicle::TakeOff{10}, UnitSystem::Aviation), QStringLiteral("Take off to 33\u00a0ft"));
        QCOMPARE(commandText(vehicle::ChangeAltitude{30.48, true}, UnitSystem::Imperial),
                 QStringLiteral("Change altitude to 100\u00a0ft"));
    }

    void aviationIsChosenByKeys()
    {
        setUp();
        m_station->showSealed(1);
        find<QAction>("actionSettings")->trigger();
        auto *dialog = m_window->findChild<SettingsDialog *>();
        EVENTUALLY(dialog && dialog->isVisible());
        auto *units = dialog->findChild<QComboBox *>(QStringLiteral("settingUnits"));
        units->setFocus();
        QTest::keyClicks(units, QStringLiteral("avi"));
        QCOMPARE(dialog->settings().units, UnitSystem::Aviation);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);

        EVENTUALLY(!m_window->findChild<SettingsDialog *>());
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), test::kDeadlineMs));
        m_station->showSealed(2);
        EVENTUALLY_EQUAL(find<ValueCell>("value_alt_rel")->unit(), QStringLiteral("ft"));
        QCOMPARE(find<ValueCell>("value_ground_speed")->unit(), QStringLiteral("kt"));
        QCOMPARE(find<ValueCell>("value_distance_home")->unit(), QStringLiteral("ft"));
        QCOMPARE(find<MapView>("map")->units(), UnitSystem::Aviation);
        QCOMPARE(find<QDoubleSpinBox>("takeOffAltitude")->suffix(), QStringLiteral(" ft"));
        auto *takeOff = find<HoldButton>("takeOffButton");
        QTest::mousePress(takeOff, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_station->commands.size(), std::size_t(1));
        QTest::mouseRelease(takeOff, Qt::LeftButton);
        QCOMPARE(std::get<vehicle::TakeOff>(m_station->commands[0].second).altitude, 10.0);
        QCOMPARE(find<QLabel>("commandResult")->text(), QStringLiteral("Take off to 33\u00a0ft: requested…"));
        const auto *items = find<QTreeView>("missionView")->model();
        QVERIFY(items->rowCount() > 1);
        QVERIFY(items->index(1, 4).data().toString().endsWith(QStringLiteral("\u00a0ft")));
        m_store->sync();
        QCOMPARE(loadSettings(*m_store).units, UnitSystem::Aviation);

        // Looking into the settings again changes nothing.
        find<QAction>("actionSettings")->trigger();
        dialog = m_window->findChild<SettingsDialog *>();
        EVENTUALLY(dialog && dialog->isVisible());
        QVERIFY(!dialog->findChild<QComboBox *>(QStringLiteral("settingUnits"))->currentText().isEmpty());
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        EVENTUALLY(!m_window->findChild<SettingsDialog *>());
        QCOMPARE(find<MapView>("map")->units(), UnitSystem::Aviation);
        m_store->sync();
        QCOMPARE(loadSettings(*m_store).units, UnitSystem::Aviation);
        tearDown();
    }
};

SKYSEAL_TEST_WIDGETS(UnitsTest)
#include "units_test.moc"
