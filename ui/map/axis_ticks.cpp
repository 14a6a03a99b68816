#include "ui/map/axis_ticks.h"

#include "ui/map/nice_step.h"

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

std::vector<AxisTick> axisTicks(double lowest, double highest, double least, UnitScale scale)
{
    const double finest = std::pow(10.0, -scale.decimals); // two ticks that are closer could be written alike
    const double step = niceStep(std::max(least * scale.factor, finest));
    if (step >= 1)
        scale.decimals = 0;
    std::vector<AxisTick> out;
    const double last = std::floor(highest * scale.factor / step + 1e-9);
    for (double count = std::ceil(lowest * scale.factor / step - 1e-9); count <= last; ++count) {
        const double value = count * step / scale.factor;
        out.push_back({value, figureIn(scale, value).text()});
    }
    return out;
}

} // namespace skyseal::ui
