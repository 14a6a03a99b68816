// A mission as MAVLink describes it: a list of items, the first of which is home.
#pragma once

#include "core/sim/geo_frame.h"
#include "core/sim/vehicle_type.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace skyseal::sim {

/// An item as the vehicle stores it: MISSION_ITEM_INT without its addressing.
struct StoredItem
{
    std::uint8_t frame = 0;    ///< MAV_FRAME
    std::uint16_t command = 0; ///< MAV_CMD
    bool autocontinue = true;
    std::array<float, 4> parameters{};
    std::int32_t x = 0; ///< latitude in 1e-7 degrees, or a parameter
    std::int32_t y = 0; ///< longitude in 1e-7 degrees, or a parameter
    float z = 0;        ///< altitude in m, in the item's frame, or a parameter

    bool operator==(const StoredItem &) const = default;
};

/// Why an item cannot be part of a mission, numbered as MAV_MISSION_RESULT.
enum class ItemError : std::uint8_t {
    UnsupportedFrame = mavlink::MAV_MISSION_UNSUPPORTED_FRAME,
    Unsupported = mavlink::MAV_MISSION_UNSUPPORTED,
    Invalid = mavlink::MAV_MISSION_INVALID,
    InvalidX = mavlink::MAV_MISSION_INVALID_PARAM5_X,
    InvalidY = mavlink::MAV_MISSION_INVALID_PARAM6_Y,
    InvalidZ = mavlink::MAV_MISSION_INVALID_PARAM7
};

/// Whether a frame (MAV_FRAME) measures from the globe: latitude, longitude and any kind of altitude.
bool isGlobalFrame(std::uint8_t frame);
/// By what x and y of a MISSION_ITEM are multiplied in a MISSION_ITEM_INT: 1e7 if the command has a place, else 1.
double integerScale(std::uint16_t command);
/// Whether latitude and longitude are within their ranges.
bool isOnGlobe(const StoredItem &item);

/// nullopt when this type of vehicle can fly it.
std::optional<ItemError> checkItem(const StoredItem &item, const VehicleType &type);
/// Whether the command has a place of its own.
bool hasPlace(std::uint16_t command);

/// Whether the item is a place to be at, rather than something to do on the way.
bool isNavigation(const StoredItem &item);

/// Where an item lies. Zero latitude and longitude mean "here", as ArduPilot reads them; heights are above sea level in
/// the global frames and above home in the relative ones.
Vector3 placeOf(const StoredItem &item, const GeoFrame &world, const Vector3 &home, const Vector3 &here);

using Mission = std::vector<StoredItem>;
inline constexpr std::size_t kMostMissionItems = 724;

} // namespace skyseal::sim
