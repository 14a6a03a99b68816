// Missions, fences and rally points: the item as MISSION_ITEM_INT carries it, the requests of the mission protocol and their
// result.
// https://mavlink.io/en/services/mission.html
#pragma once

#include "core/base/reason.h"
#include "core/mavlink/enums.h"
#include "core/vehicle/request_id.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace skyseal::vehicle {

/// Parameters that are not used, which the vehicle replaces by its default, are NaN.
struct MissionItem
{
    std::uint16_t sequence = 0;
    std::uint16_t command = mavlink::MAV_CMD_NAV_WAYPOINT;       ///< MAV_CMD
    std::uint8_t frame = mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT; ///< MAV_FRAME
    bool current = false;
    bool autoContinue = true;
    float parameters[4]{};
    /// Parameters 5 and 6: degrees; metres in a local frame; plain numbers of a command without a place (mission_place.h).
    double latitude = 0, longitude = 0;
    float altitude = 0; ///< metres; parameter 7 of a command without a place
    bool operator==(const MissionItem &) const = default;
};

using MissionItems = std::shared_ptr<const std::vector<MissionItem>>;

/// Whether this kind of autopilot (MAV_AUTOPILOT) keeps home as item 0 of its mission.
constexpr bool keepsHomeFirst(std::uint8_t autopilot)
{
    return autopilot == mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA;
}

/// Kinds of plans; each is a list of items of its own on the vehicle.
enum class MissionType : std::uint8_t {
    Mission = mavlink::MAV_MISSION_TYPE_MISSION,
    Fence = mavlink::MAV_MISSION_TYPE_FENCE,
    Rally = mavlink::MAV_MISSION_TYPE_RALLY
};

struct ReadMission
{
    MissionType type = MissionType::Mission;
};
struct WriteMission
{
    std::vector<MissionItem> items; ///< renumbered from 0 in this order
    MissionType type = MissionType::Mission;
    bool withoutHome = false; ///< the first item is known to be no home position, whatever it looks like
    bool overwrite = false;   ///< also a list that another station is known to have changed
    /// The list that the items were made from, if they are an edited one. Nothing is sent if the vehicle has another list by
    /// now: unless the vehicle names its list by an id, it is read again first.
    MissionItems basis = {};
};
struct ClearMission
{
    MissionType type = MissionType::Mission;
    bool overwrite = false; ///< as in WriteMission
};

enum class MissionTransfer : std::uint8_t { Upload, Download, Clear };

struct MissionResult
{
    RequestId id{};
    std::uint8_t systemId = 0;
    MissionTransfer transfer{};
    MissionType type = MissionType::Mission;
    bool ok = false;
    Reason reason = {};            ///< why it failed
    bool changeUnanswered = false; ///< an upload or clear that got no answer at all
    /// The items that the vehicle now has; null unless ok.
    MissionItems items = {};
    /// What an upload that is ok did to the first item, or what the vehicle makes of it; empty if there is nothing to say.
    Reason remark = {};
};

} // namespace skyseal::vehicle
