#include "ui/text/pre_arm_text.h"

#include "core/engine/station/vehicle_snapshot.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct PreArmText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::PreArmText)
};

struct Remedy
{
    const char *word; ///< in the vehicle's text, without regard to case
    const char *text;
};

/// The first row applies of which a word of the text begins with `word`, so that narrow rows stand before wide ones.
constexpr Remedy kRemedies[] = {
    {"not armable", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Set a mode that allows arming, such as LOITER or GUIDED.")},
    {"another mode", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Set a mode that allows arming, such as Hold or Position.")},
    {"safety", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Press the vehicle's safety switch until its light stays on.")},
    {"rc not calibrated",
     QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Calibrate the radio: move each stick and switch to both ends.")},
    {"radio failsafe", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Switch on the transmitter and check its receiver.")},
    {"rc not found", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Switch on the transmitter and check its receiver.")},
    {"throttle below failsafe",
     QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Switch on the transmitter and check its receiver.")},
    {"throttle", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Lower the throttle stick fully.")},
    {"compass not calibrated", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Calibrate the compass away from metal.")},
    {"compass offsets", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Calibrate the compass away from metal.")},
    {"compass",
     QT_TRANSLATE_NOOP("skyseal::ui::PreArmText",
                       "Move the vehicle away from metal, cables and magnets; calibrate the compass if the failure persists.")},
    {"mag field", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Move the vehicle away from metal, cables and magnets.")},
    {"fence requires position",
     QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Wait for the GPS and the EKF, or disable the fence.")},
    {"fence", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Place the vehicle inside its fence, or correct the fence.")},
    {"hdop", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Wait for more satellites, under an open sky.")},
    {"gps", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Wait for a 3D fix under an open sky; check the GPS cable.")},
    {"position estimate",
     QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Wait for the GPS and the EKF, or set a mode that needs no position.")},
    {"ekf", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Keep the vehicle still until its estimate has settled.")},
    {"ahrs", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Keep the vehicle still until its estimate has settled.")},
    {"gyro", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Keep the vehicle still; restart it if the failure persists.")},
    {"accel",
     QT_TRANSLATE_NOOP("skyseal::ui::PreArmText",
                       "Keep the vehicle still; calibrate the accelerometers if the failure persists.")},
    {"baro", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Shield the barometer from wind and light; restart the vehicle.")},
    {"board", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Check the power supply of the autopilot.")},
    {"battery", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Charge or change the battery; check BATT_ARM_VOLT.")},
    {"logging", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Check that the SD card is inserted and has free space.")},
    {"sd card", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Check that the SD card is inserted and has free space.")},
    {"mission", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Send a mission that suits this vehicle.")},
    {"terrain", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Wait until the terrain data have been loaded.")},
    {"leaning", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Place the vehicle on level ground.")},
    {"internal error",
     QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Restart the autopilot, and do not fly until the cause is known.")},
    {"not landed", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Wait until the vehicle has detected the landing.")},
    {"motor", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Check the motor and frame parameters, and the ESCs.")},
    {"esc", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Check the power and the cables of the ESCs.")},
    {"servo", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Correct the parameter named in the message.")},
    {"check ", QT_TRANSLATE_NOOP("skyseal::ui::PreArmText", "Correct the parameter named in the message.")},
};

} // namespace

PreArm preArmOf(const ViewState &view)
{
    if (!view.vehicle || view.stale())
        return PreArm::Unknown;
    const vehicle::VehicleState &state = view.vehicle->state;
    if (state.armed)
        return PreArm::Armed;
    if (!state.preArmReasons.empty() || state.preArmOk == false)
        return PreArm::Refused;
    return state.preArmOk ? PreArm::Ok : PreArm::Unknown;
}

QString preArmText(const ViewState &view)
{
    switch (preArmOf(view)) {
    case PreArm::Unknown: return PreArmText::tr("Pre-arm: unknown");
    case PreArm::Ok: return PreArmText::tr("Pre-arm: ok");
    case PreArm::Armed: return PreArmText::tr("Pre-arm: armed");
    case PreArm::Refused: break;
    }
    const auto reasons = static_cast<int>(view.vehicle->state.preArmReasons.size());
    if (reasons == 0)
        return PreArmText::tr("Pre-arm: not ok");
    return reasons == 1 ? PreArmText::tr("Pre-arm: 1 failure") : PreArmText::tr("Pre-arm: %1 failures").arg(reasons);
}

QString widestPreArmText()
{
    return PreArmText::tr("Pre-arm: %1 failures").arg(88);
}

QString preArmSentence(const ViewState &view)
{
    switch (preArmOf(view)) {
    case PreArm::Unknown:
        if (!view.vehicle)
            return PreArmText::tr("No vehicle is connected.");
        return view.stale()
            ? PreArmText::tr("The vehicle is silent, so the state of its checks is not known.")
            : PreArmText::tr("The vehicle does not report whether its checks pass, and has not reported a failure.");
    case PreArm::Ok: return PreArmText::tr("The vehicle reports that all checks pass.");
    case PreArm::Armed: return PreArmText::tr("The vehicle is armed.");
    case PreArm::Refused: break;
    }
    return view.vehicle->state.preArmReasons.empty()
        ? PreArmText::tr("The vehicle reports that a check fails, but not which one. It repeats its failures every 30 s.")
        : PreArmText::tr("The vehicle will not arm. A failure is removed when it has not been repeated for 40 s.");
}

QString preArmRemedy(const QString &reason)
{
    const QString text = QLatin1Char(' ') + reason;
    for (const Remedy &remedy : kRemedies)
        if (text.contains(QLatin1Char(' ') + QLatin1String(remedy.word), Qt::CaseInsensitive))
            return PreArmText::tr(remedy.text);
    return PreArmText::tr("Look up the message in the autopilot's documentation.");
}

} // namespace skyseal::ui
