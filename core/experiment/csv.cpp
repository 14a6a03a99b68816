#include "core/experiment/csv.h"

#include "core/base/number_text.h"

#include <cmath>

namespace skyseal::experiment {

std::string csvNumber(double value)
{
    return std::isfinite(value) ? numberText(value) : std::string();
}

std::string csvText(const std::string &text)
{
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

} // namespace skyseal::experiment
