#include "ui/text/value_unit.h"

#include <numbers>
#include <optional>

namespace skyseal::ui {

namespace {

struct Rule
{
    std::string_view unit;
    double factor;
    const char *name;
    int decimals;
    Measure measure = Measure::Plain;
};

constexpr double kDegrees = 180 / std::numbers::pi;

constexpr Rule kRules[] = {
    {"m", 1, "m", 1, Measure::Length},
    {"dm", 0.1, "m", 1, Measure::Length},
    {"cm", 0.01, "m", 1, Measure::Length},
    {"mm", 0.001, "m", 1, Measure::Length},
    {"dam", 10, "m", 0, Measure::Length},
    {"m/s", 1, "m/s", 1, Measure::Speed},
    {"dm/s", 0.1, "m/s", 1, Measure::Speed},
    {"cm/s", 0.01, "m/s", 1, Measure::Speed},
    {"mm/s", 0.001, "m/s", 1, Measure::Speed},
    {"m/s/s", 1, "m/s²", 2},
    {"rad", kDegrees, "°", 1},
    {"deg", 1, "°", 1},
    {"cdeg", 0.01, "°", 1},
    {"degE5", 1e-5, "°", 5},
    {"degE7", 1e-7, "°", 7},
    {"rad/s", kDegrees, "°/s", 1},
    {"mrad/s", kDegrees / 1000, "°/s", 1},
    {"deg/s", 1, "°/s", 1},
    {"ddeg/s", 0.1, "°/s", 1},
    {"V", 1, "V", 2},
    {"cV", 0.01, "V", 2},
    {"mV", 0.001, "V", 2},
    {"A", 1, "A", 1},
    {"cA", 0.01, "A", 1},
    {"mA", 0.001, "A", 1},
    {"%", 1, "%", 0},
    {"d%", 0.1, "%", 1},
    {"c%", 0.01, "%", 1},
    {"degC", 1, "°C", 1},
    {"cdegC", 0.01, "°C", 1},
    {"s", 1, "s", 1},
    {"ds", 0.1, "s", 1},
    {"cs", 0.01, "s", 2},
    {"us", 1, "µs", 0},
};

/// The one unit for numbers with chosen decimals and for limits; nullopt where it is the same for all.
std::optional<UnitScale> scaleOf(Measure measure, UnitSystem units)
{
    switch (measure) {
    case Measure::Length: return altitudeScale(units);
    case Measure::Distance: return smallDistanceScale(units);
    case Measure::Speed: return speedScale(units);
    case Measure::Climb: return climbScale(units);
    default: return std::nullopt;
    }
}

} // namespace

ValueUnit valueUnit(std::string_view sourceUnit, bool wholeNumber)
{
    for (const Rule &rule : kRules) {
        if (rule.unit == sourceUnit) {
            const bool stepsOfOne = wholeNumber && rule.factor == 1;
            return {rule.measure, rule.factor, QString::fromUtf8(rule.name), stepsOfOne ? 0 : rule.decimals};
        }
    }
    return {Measure::Plain, 1, QString::fromUtf8(sourceUnit.data(), static_cast<qsizetype>(sourceUnit.size())),
            wholeNumber ? 0 : 2};
}

Figure valueFigure(double metric, const ValueUnit &unit, int decimals, UnitSystem units)
{
    if (decimals < 0) {
        switch (unit.measure) {
        case Measure::Length:
            if (unit.decimals > 0 || units != UnitSystem::Metric)
                return altitudeFigure(metric, units);
            break;
        case Measure::Distance: return distanceFigure(metric, units);
        case Measure::Speed: return speedFigure(metric, units);
        case Measure::Climb: return climbFigure(metric, units);
        case Measure::Heading: return headingFigure(metric);
        case Measure::Duration: return {durationText(metric), {}};
        case Measure::Plain: break;
        }
        decimals = unit.decimals;
    }
    return {number(metric * unitFactor(unit, units), decimals), unitName(unit, units)};
}

QString unitName(const ValueUnit &unit, UnitSystem units)
{
    const auto scale = scaleOf(unit.measure, units);
    return scale ? QString::fromLatin1(scale->name) : unit.name;
}

double unitFactor(const ValueUnit &unit, UnitSystem units)
{
    const auto scale = scaleOf(unit.measure, units);
    return scale ? scale->factor : 1;
}

} // namespace skyseal::ui
