// Real autopilots as they were recorded: what is known of them at a time of their flight, field by field.
#include "tests/support/test_runner.h"
#include "recorded_flight.h"

#include "core/vehicle/state_fields.h"

using namespace skyseal;
using namespace skyseal::vehicle;

namespace {

/// As the JSON has it, numbers rounded to one decimal.
QString textOf(const VehicleState &state, const QString &name)
{
    if (name == QLatin1String("pre_arm"))
        return !state.preArmOk ? QStringLiteral("null") : *state.preArmOk ? QStringLiteral("ok") : QStringLiteral("fails");
    if (name == QLatin1String("reasons"))
        return QString::number(state.preArmReasons.size());
    if (name == QLatin1String("last_text"))
        return state.texts.empty() ? QString() : QString::fromStdString(state.texts.back().text);
    const StateField *field = findStateField(name.toStdString());
    if (!field)
        return QStringLiteral("no such field");
    if (field->kind == StateField::Kind::Text)
        return QString::fromStdString(field->text(state));
    const double value = field->number(state);
    return std::isnan(value) ? QStringLiteral("null") : QString::number(std::round(value * 10) / 10 + 0.0);
}

} // namespace

class RecordedVehiclesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knows_data();
    void knows();
};

void RecordedVehiclesTest::knows_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("values");
    const auto row = [](const char *what, const char *file, double seconds, const char *values) {
        QTest::newRow(what) << file << seconds << values;
    };
    const char *const copter = "arducopter-4.7-dev.tlog", *const quadplane = "quadplane-4.7-dev.tlog",
                      *const px4 = "px4-quadrotor-1.19.tlog", *const vtol = "px4-vtol-1.19.tlog";
    row("ArduCopter, before its monitor has measured", copter, 2.4, "battery_v=null|battery_a=null|battery_percent=null");
    row("ArduCopter, just started", copter, 2.8,
        "mode=STABILIZE|armed=0|battery_v=12.6|battery_percent=100|gps_fix=0|hdop=null|lat=null|alt=null|ekf_ok=null|"
        "mission_current=null|pre_arm=fails|firmware=ArduCopter 4.7.0-dev|last_text=RC7: SaveWaypoint LOW");
    row("ArduCopter, with a fix, without an estimate", copter, 15,
        "gps_fix=6|satellites=10|hdop=1.2|lat=47.4|lon=8.5|alt=488.1|ekf_ok=0|battery_v=12.6|battery_percent=100");
    row("ArduCopter, flying", copter, 49, "mode=GUIDED|armed=1|ekf_ok=1|alt_rel=5.1|battery_percent=98|lat=47.4");
    row("ArduCopter, landed", copter, 74, "mode=LAND|armed=0|last_text=Disarming motors");
    row("quadplane on the ground", quadplane, 1.2,
        "mode=QLOITER|armed=0|battery_v=null|battery_a=null|battery_percent=null|ekf_ok=1|pre_arm=ok|mission_current=null|"
        "firmware=ArduPlane 4.7.0-dev");
    row("quadplane flying", quadplane, 10, "mode=QLAND|armed=1|battery_v=null|ekf_ok=1");
    row("PX4 at rest", px4, 0.9,
        "mode=LOITER|armed=0|ekf_ok=1|pre_arm=ok|reasons=0|battery_v=16.2|battery_a=null|battery_percent=100|gps_fix=3|"
        "mission_current=null|firmware=PX4 1.19.0-alpha|lat=47.4|heading=0");
    row("PX4 taking off", px4, 8, "mode=TAKEOFF|armed=1|ekf_ok=1|last_text=Takeoff detected");
    row("PX4 landing", px4, 20, "mode=LAND|armed=1|ekf_ok=1|last_text=Landing at current position");
    row("PX4 landed", px4, 31.5, "mode=LOITER|armed=0|ekf_ok=1|pre_arm=ok|reasons=0|last_text=Disarmed by landing");
    row("PX4 VTOL at rest", vtol, 1.0, "mode=LOITER|armed=0|ekf_ok=1|pre_arm=ok|battery_v=16.2|battery_a=null");
    row("PX4 VTOL landing", vtol, 15, "mode=LAND|armed=1|ekf_ok=1|last_text=Landing at current position");
}

void RecordedVehiclesTest::knows()
{
    QFETCH(QString, file);
    QFETCH(double, seconds);
    QFETCH(QString, values);
    const auto state = RecordedFlight(file, seconds).state();
    QVERIFY(state);
    QStringList actual;
    for (const QString &value : values.split(QLatin1Char('|'))) {
        const QString name = value.section(QLatin1Char('='), 0, 0);
        actual << name + QLatin1Char('=') + textOf(*state, name);
    }
    QCOMPARE(actual.join(QLatin1Char('|')), values);
}

SKYSEAL_TEST_APPLESS(RecordedVehiclesTest)
#include "recorded_vehicles_test.moc"
