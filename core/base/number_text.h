// Numbers as text for machines: in files, protocols, command lines and figures they have a decimal point, whatever the locale
// of the desktop is. The functions of C, and std::to_string(), follow the locale, so that no floating-point number goes through
// them (tests/arch/numbers_test). The window, which has the decimal point of its language, writes numbers by ui/text/units.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace skyseal {

/// The shortest text that reads back to the same value: "0.1", "1e+22", "nan", "-inf".
std::string numberText(double value);
std::string numberText(float value);

/// With exactly `decimals` places: "9.50". Zero has no sign.
std::string fixedText(double value, int decimals);

/// With at most `decimals` places and no trailing zeros: "9.5", "10".
std::string shortNumber(double value, int decimals = 3);

/// With at most `digits` significant digits, no trailing zeros, and an exponent if the number is very large or very small:
/// "0.0125", "1.5e+06". Zero has no sign.
std::string significantText(double value, int digits);

/// A finite decimal number, also with a plus sign, that fills the whole text; nullopt otherwise.
std::optional<double> finiteNumber(std::string_view text);

} // namespace skyseal
