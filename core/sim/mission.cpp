#include "core/sim/mission.h"

#include "core/sim/mission_command.h"

namespace skyseal::sim {

namespace {

// MAV_FRAME_GLOBAL and its kin; the terrain frames count as relative, since the ground is flat.
bool absoluteFrame(std::uint8_t frame)
{
    return frame == 0 || frame == 5;
}
bool relativeFrame(std::uint8_t frame)
{
    return frame == 3 || frame == 6 || frame == 10 || frame == 11;
}

bool hasPlace(std::uint16_t command)
{
    using namespace mission_command;
    return command == kWaypoint || command == kLoiterUnlimited || command == kLoiterTime || command == kLand
        || command == kTakeOff;
}

} // namespace

std::optional<ItemError> checkItem(const MissionItem &item)
{
    using namespace mission_command;
    switch (item.command) {
    case kWaypoint:
    case kLoiterUnlimited:
    case kLoiterTime:
    case kReturnToLaunch:
    case kLand:
    case kTakeOff:
    case kDelay:
    case kConditionYaw:
    case kJump:
    case kChangeSpeed: break;
    default: return ItemError::Unsupported;
    }
    for (const float parameter : item.parameters) {
        if (std::isinf(parameter))
            return ItemError::Invalid; // not-a-number is fine: it means "the default"
    }
    if (!hasPlace(item.command))
        return std::nullopt;
    if (!absoluteFrame(item.frame) && !relativeFrame(item.frame))
        return ItemError::UnsupportedFrame;
    if (std::abs(static_cast<double>(item.x)) > 90e7)
        return ItemError::InvalidX;
    if (std::abs(static_cast<double>(item.y)) > 180e7)
        return ItemError::InvalidY;
    if (!std::isfinite(item.z) || std::abs(item.z) > 10000)
        return ItemError::InvalidZ;
    return std::nullopt;
}

bool isNavigation(const MissionItem &item)
{
    return item.command < mission_command::kLastNavigation;
}

Vector3 placeOf(const MissionItem &item, const LocalFrame &world, const Vector3 &home, const Vector3 &here)
{
    Vector3 place = here;
    if (item.x != 0 || item.y != 0)
        place = world.toLocal({item.x * 1e-7, item.y * 1e-7, 0});
    place.z = absoluteFrame(item.frame) ? world.origin().altitude - static_cast<double>(item.z)
                                        : home.z - static_cast<double>(item.z);
    return place;
}

} // namespace skyseal::sim
