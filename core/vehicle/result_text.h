// Text for people of the result codes of MAVLink, and of numbers.
#pragma once

#include <cstdint>
#include <string>

namespace skyseal::vehicle {

/// MAV_RESULT: "denied", "not supported", …
std::string commandResultText(std::uint8_t result);
/// MAV_MISSION_RESULT: "no space left for the mission", …
std::string missionResultText(std::uint8_t result);

/// Fixed notation without trailing zeros, with at most `decimals` places: "9.5", "10".
std::string shortNumber(double value, int decimals = 3);

} // namespace skyseal::vehicle
