// Round lengths for scales and grids.
#pragma once

#include <cmath>

namespace skyseal::ui {

/// 1, 2 or 5 times a power of ten, at least `least`.
inline double niceStep(double least)
{
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (power * factor >= least)
            return power * factor;
    return power * 10;
}

} // namespace skyseal::ui
