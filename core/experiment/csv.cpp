#include "core/experiment/csv.h"

#include <charconv>
#include <cmath>

namespace skyseal::experiment {

std::string csvNumber(double value)
{
    if (!std::isfinite(value))
        return {};
    char out[32];
    return {out, std::to_chars(out, out + sizeof out, value).ptr};
}

std::string csvText(const std::string &text)
{
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

} // namespace skyseal::experiment
