// The length that the scale bar of the map shows.
#pragma once

#include "ui/map/nice_step.h"
#include "ui/text/units.h"

namespace skyseal::ui {

/// A length for the scale bar: its text and its metres.
struct ScaleBar
{
    QString text;
    double metres;
};

/// The shortest round length of at least `least` metres.
inline ScaleBar scaleBar(double least, UnitSystem units)
{
    const auto length = [least](const UnitScale &scale) {
        const double round = niceStep(least * scale.factor);
        return ScaleBar{withUnit(withDecimalPoint(QString::number(round)), QLatin1String(scale.name)), round / scale.factor};
    };
    // Beside a single length, the large unit reads well from half or one of it on.
    const double longest = (units == UnitSystem::Aviation ? 0.5 : 1) / largeDistanceScale(units).factor;
    const ScaleBar small = length(smallDistanceScale(units));
    return small.metres < longest ? small : length(largeDistanceScale(units));
}

} // namespace skyseal::ui
