// Values as people read them: rounded, with a unit, and a dash where nothing is known.
#pragma once

#include <QtCore/QString>

#include <cstdint>

namespace skyseal::ui {

enum class UnitSystem : int { Metric, Imperial };

inline constexpr double kFeetPerMetre = 3.280839895;
inline constexpr double kMilesPerHourPerMetreASecond = 2.236936292;
inline constexpr double kFeetPerMinutePerMetreASecond = 196.8503937;

/// A value and its unit, apart, because units are drawn dimmed.
struct Figure
{
    QString value, unit;
    QString text() const { return unit.isEmpty() ? value : value + QLatin1Char(' ') + unit; }
};

/// The placeholder for a value that is not known.
QString dash();

/// `value` with `decimals` places; a dash for NaN. Never "-0.0".
QString number(double value, int decimals);
/// Digits in groups of three, separated by a thin space.
QString grouped(std::uint64_t value);

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
