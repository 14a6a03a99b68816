// Units of values: from the unit in which a vehicle sends a value to the unit in which people read it.
#pragma once

#include "ui/text/units.h"

#include <string_view>

namespace skyseal::ui {

/// Kind of quantity, as far as its text depends on it.
enum class Measure { Plain, Length, Distance, Speed, Climb, Heading, Duration };

/// How the numbers of one source are shown.
struct ValueUnit
{
    Measure measure = Measure::Plain;
    double factor = 1; ///< from the number of the source to the metric number that is shown
    QString name;      ///< the metric unit; empty for none
    int decimals = 0;  ///< unless the operator chooses others
};

inline constexpr int kMostDecimals = 9;

/// The unit for a number in a unit of MAVLink's definitions ("cm", "degE7"). An unknown one is shown as it is.
ValueUnit valueUnit(std::string_view sourceUnit, bool wholeNumber);

/// Text of a metric number; a dash if it is not finite. Fewer than 0 decimals: those of the unit.
Figure valueFigure(double metric, const ValueUnit &unit, int decimals, UnitSystem units);

/// The unit's name in `units`, and by how much a metric number is multiplied for it.
QString unitName(const ValueUnit &unit, UnitSystem units);
double unitFactor(const ValueUnit &unit, UnitSystem units);

} // namespace skyseal::ui
