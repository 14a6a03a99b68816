// Text of numbers of any size.
#pragma once

#include <string>

namespace skyseal::vehicle {

/// Fixed notation without trailing zeros, with at most `decimals` places: "9.5", "10".
std::string shortNumber(double value, int decimals = 3);

} // namespace skyseal::vehicle
