#include "core/engine/text/system_text.h"

#include "core/engine/text/qt_text.h"
#include "core/mavlink/enums.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStringList>

namespace skyseal::engine {

namespace {

/// The translation context of the functions below.
struct SystemText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::SystemText)
};

/// By MAV_TYPE; empty for one that says nothing.
QString partTypeText(std::uint8_t type)
{
    switch (type) {
    case mavlink::MAV_TYPE_GCS: return SystemText::tr("ground station");
    case mavlink::MAV_TYPE_ONBOARD_CONTROLLER: return SystemText::tr("companion computer");
    case mavlink::MAV_TYPE_GIMBAL: return SystemText::tr("gimbal");
    case mavlink::MAV_TYPE_ADSB: return SystemText::tr("ADS-B receiver");
    case mavlink::MAV_TYPE_CAMERA: return SystemText::tr("camera");
    case mavlink::MAV_TYPE_CHARGING_STATION: return SystemText::tr("charging station");
    case mavlink::MAV_TYPE_FLARM: return SystemText::tr("FLARM receiver");
    case mavlink::MAV_TYPE_SERVO: return SystemText::tr("servo");
    case mavlink::MAV_TYPE_ODID: return SystemText::tr("remote ID");
    case mavlink::MAV_TYPE_BATTERY: return SystemText::tr("battery");
    case mavlink::MAV_TYPE_PARACHUTE: return SystemText::tr("parachute");
    case mavlink::MAV_TYPE_LOG: return SystemText::tr("logger");
    case mavlink::MAV_TYPE_OSD: return SystemText::tr("on-screen display");
    case mavlink::MAV_TYPE_IMU: return SystemText::tr("inertial sensor");
    case mavlink::MAV_TYPE_GPS: return SystemText::tr("GPS receiver");
    case mavlink::MAV_TYPE_WINCH: return SystemText::tr("winch");
    case mavlink::MAV_TYPE_ILLUMINATOR: return SystemText::tr("light");
    case mavlink::MAV_TYPE_GRIPPER: return SystemText::tr("gripper");
    case mavlink::MAV_TYPE_RADIO: return SystemText::tr("radio");
    default: return {};
    }
}

/// By MAV_COMPONENT, for components whose HEARTBEAT does not say it.
QString partOfId(std::uint8_t id)
{
    using namespace mavlink;
    if (id == MAV_COMP_ID_AUTOPILOT1)
        return SystemText::tr("autopilot");
    if (id >= MAV_COMP_ID_CAMERA && id <= MAV_COMP_ID_CAMERA6)
        return partTypeText(MAV_TYPE_CAMERA);
    if (id == MAV_COMP_ID_GIMBAL || (id >= MAV_COMP_ID_GIMBAL2 && id <= MAV_COMP_ID_GIMBAL6))
        return partTypeText(MAV_TYPE_GIMBAL);
    if (id >= MAV_COMP_ID_ONBOARD_COMPUTER && id <= MAV_COMP_ID_ONBOARD_COMPUTER4)
        return partTypeText(MAV_TYPE_ONBOARD_CONTROLLER);
    if (id == MAV_COMP_ID_TELEMETRY_RADIO)
        return partTypeText(MAV_TYPE_RADIO);
    return SystemText::tr("component");
}

} // namespace

QString componentText(const vehicle::Component &component)
{
    const QString type = partTypeText(component.type);
    return QStringLiteral("%1 %2").arg(type.isEmpty() ? partOfId(component.id) : type).arg(component.id);
}

QString otherSystemsText(const OtherSystemsHeard &heard)
{
    return SystemText::tr("Other systems behind %1: %2").arg(qt(heard.peer), systemsText(heard.systems));
}

QString systemsText(const std::vector<std::uint8_t> &systems)
{
    QStringList out;
    for (const std::uint8_t systemId : systems)
        out << QString::number(systemId);
    return out.join(QStringLiteral(", "));
}

} // namespace skyseal::engine
