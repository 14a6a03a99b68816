#include "core/base/number_text.h"

#include <charconv>
#include <cmath>

namespace skyseal {

namespace {

template<typename... Format> std::string written(auto value, Format... format)
{
    if (std::isnan(value))
        return "nan"; // without the sign that some processors give it
    char out[400];    // the largest double has 309 digits before the point
    return {out, std::to_chars(out, out + sizeof out, value, format...).ptr};
}

} // namespace

std::string numberText(double value)
{
    return written(value);
}

std::string numberText(float value)
{
    return written(value);
}

std::string fixedText(double value, int decimals)
{
    std::string text = written(value, std::chars_format::fixed, decimals);
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos)
        text.erase(0, 1);
    return text;
}

std::string shortNumber(double value, int decimals)
{
    std::string text = fixedText(value, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.')
            text.pop_back();
    }
    return text;
}

std::string significantText(double value, int digits)
{
    return written(value == 0 ? 0.0 : value, std::chars_format::general, digits);
}

std::optional<double> finiteNumber(std::string_view text)
{
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-'))
            return std::nullopt;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace skyseal
