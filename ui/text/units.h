// Values as people read them: rounded, with a unit, and a dash where nothing is known.
#pragma once

#include <QtCore/QString>

#include <cstdint>

namespace skyseal::ui {

/// Aviation: altitudes in feet, speeds in knots, climb rates in feet per minute, distances in nautical miles. Distances below
/// half a nautical mile are in feet, so that no display needs a third unit of length.
enum class UnitSystem : int { Metric, Imperial, Aviation };

/// A unit in which people read values of SI.
struct UnitScale
{
    double factor;    ///< from the number in SI
    const char *name; ///< "ft"
    int decimals;     ///< of a value beside others, as in the grid of values
};

/// Units of altitudes, speeds and climb rates.
UnitScale altitudeScale(UnitSystem units);
UnitScale speedScale(UnitSystem units);
UnitScale climbScale(UnitSystem units);
/// Unit of a distance of about this many metres, and the units it is one of: the small one, and the large one for long
/// distances.
UnitScale distanceScale(double metres, UnitSystem units);
UnitScale smallDistanceScale(UnitSystem units);
UnitScale largeDistanceScale(UnitSystem units);

/// A number and its unit, which no line break parts; the number alone if the unit is empty.
QString withUnit(const QString &number, const QString &unit);
/// A number as command lines write it, with the decimal point of the window's language.
QString withDecimalPoint(QString number);

/// A value and its unit, apart, because units are drawn dimmed.
struct Figure
{
    QString value, unit;
    QString text() const { return withUnit(value, unit); }
};

/// The placeholder for a value that is not known.
QString dash();

/// `value` with `decimals` places; a dash for NaN. Never "-0.0".
QString number(double value, int decimals);
/// Digits in groups as the locale writes them: "2,481".
QString grouped(std::uint64_t value);

/// `value` of SI in this unit.
Figure figureIn(const UnitScale &scale, double value);
Figure altitudeFigure(double metres, UnitSystem units);
Figure distanceFigure(double metres, UnitSystem units);
Figure speedFigure(double metresPerSecond, UnitSystem units);
Figure climbFigure(double metresPerSecond, UnitSystem units);
Figure headingFigure(double degrees);
/// "03:21", "1:02:07".
QString durationText(double seconds);
/// "3.2 kB/s".
QString rateText(double bytesPerSecond);
/// "12 MB".
QString sizeText(std::uint64_t bytes);
/// "12 ms"; a dash when not known.
QString latencyText(double seconds);

} // namespace skyseal::ui
