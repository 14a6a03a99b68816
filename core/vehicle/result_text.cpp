#include "core/vehicle/result_text.h"

#include <cstdio>
#include <iterator>
#include <string_view>

namespace skyseal::vehicle {

namespace {

constexpr std::string_view kCommandResults[] = {"accepted",
                                                "temporarily rejected",
                                                "denied",
                                                "not supported",
                                                "failed",
                                                "in progress",
                                                "cancelled",
                                                "accepted as COMMAND_LONG only",
                                                "accepted as COMMAND_INT only",
                                                "coordinate frame not supported",
                                                "this station is not in control"};

constexpr std::string_view kMissionResults[] = {"accepted",
                                                "the vehicle reports an error",
                                                "coordinate frame not supported",
                                                "command not supported",
                                                "no space left on the vehicle",
                                                "an item is invalid",
                                                "parameter 1 is invalid",
                                                "parameter 2 is invalid",
                                                "parameter 3 is invalid",
                                                "parameter 4 is invalid",
                                                "x (latitude) is invalid",
                                                "y (longitude) is invalid",
                                                "z (altitude) is invalid",
                                                "an item arrived out of sequence",
                                                "not accepting missions from this station",
                                                "cancelled"};

} // namespace

std::string commandResultText(std::uint8_t result)
{
    if (result < std::size(kCommandResults))
        return std::string(kCommandResults[result]);
    return "result " + std::to_string(result);
}

std::string missionResultText(std::uint8_t result)
{
    if (result < std::size(kMissionResults))
        return std::string(kMissionResults[result]);
    return "result " + std::to_string(result);
}

std::string shortNumber(double value, int decimals)
{
    char buffer[400]; // the longest double in fixed notation has 309 digits before the point
    std::snprintf(buffer, sizeof(buffer), "%.*f", decimals, value);
    std::string text = buffer;
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.')
            text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

} // namespace skyseal::vehicle
