#include "ui/flight/add_waypoint_dialog.h"

#include "core/vehicle/mission_edit.h"
#include "ui/flight/vehicle_commands.h"

namespace skyseal::ui {

namespace {

constexpr float kAltitude = 30; ///< metres: offered where no item of the mission says one

std::vector<vehicle::MissionItem> missionOf(const VehicleCommands &commands)
{
    return commands.mission() ? *commands.mission() : std::vector<vehicle::MissionItem>();
}

QString hintOf(const std::vector<vehicle::MissionItem> &mission, const QString &where)
{
    const std::size_t place = vehicle::placeOfNextWaypoint(mission);
    const QString text = place < mission.size()
        ? AddWaypointDialog::tr(
            "%1\nHold the button for half a second. The waypoint is put before the last item of the mission, "
            "and the whole mission is sent to the vehicle.")
        : AddWaypointDialog::tr("%1\nHold the button for half a second. The waypoint becomes the last item of the mission, and "
                                "the whole mission is sent to the vehicle.");
    return text.arg(where);
}

} // namespace

AddWaypointDialog::AddWaypointDialog(VehicleCommands &commands, UnitSystem units, double latitude, double longitude,
                                     const QString &where, QWidget *parent)
    : AltitudeDialog(commands, units, vehicle::altitudeBeforeNextWaypoint(missionOf(commands)).value_or(kAltitude),
                     {.id = QStringLiteral("addWaypointDialog"),
                      .title = tr("Add to the mission"),
                      .hint = hintOf(missionOf(commands), where),
                      .verb = tr("Add and send"),
                      .highest = kHighestFlown},
                     parent),
      m_latitude(latitude), m_longitude(longitude)
{}

void AddWaypointDialog::command(VehicleCommands &commands, std::uint8_t systemId, double metres)
{
    commands.addWaypoint(systemId, m_latitude, m_longitude, static_cast<float>(metres));
}

} // namespace skyseal::ui

#include "moc_add_waypoint_dialog.cpp"
