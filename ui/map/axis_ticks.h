// Where the axes of a drawing have lines, and their words: round numbers that differ as they are written.
#pragma once

#include "ui/text/units.h"

#include <vector>

namespace skyseal::ui {

struct AxisTick
{
    double value = 0; ///< in the unit of the axis' ends, of SI
    QString text;
};

/// From `lowest` to `highest`, at least `least` apart (0: any distance), written in `scale` without places after the point that
/// are all zero.
std::vector<AxisTick> axisTicks(double lowest, double highest, double least, UnitScale scale);

} // namespace skyseal::ui
