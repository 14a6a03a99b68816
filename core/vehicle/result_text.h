// Small words of the vehicle layer: comparing names without case, and the numbers of MAVLink's answers as people say them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace skyseal::vehicle {

constexpr char lowerCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Equal but for the case of ASCII letters.
constexpr bool sameWord(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lowerCase(x) == lowerCase(y); });
}

/// MAV_RESULT: "denied", "not supported", …
std::string commandResultText(std::uint8_t result);
/// MAV_MISSION_RESULT: "no space left for the mission", …
std::string missionResultText(std::uint8_t result);

/// A number as people write it: "9.5", "10", with at most `decimals` places.
std::string shortNumber(double value, int decimals = 3);

} // namespace skyseal::vehicle
