#include "core/vehicle/short_number.h"

#include <cstdio>

namespace skyseal::vehicle {

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
