#include "ui/text/units.h"

#include <QtCore/QLocale>

#include <cmath>
#include <utility>

namespace skyseal::ui {

namespace {

const QChar kMinus(0x2212);

// Of the international foot, mile and nautical mile.
constexpr double kFeetPerMetre = 1 / 0.3048, kMetresPerMile = 1609.344, kMetresPerNauticalMile = 1852;

QString scaled(double value, const char *const (&names)[4])
{
    std::size_t step = 0;
    while (value >= 999.5 && step < 3) {
        value /= 1000;
        ++step;
    }
    return withUnit(withDecimalPoint(QString::number(value, 'f', value < 9.95 && step > 0 ? 1 : 0)),
                    QLatin1String(names[step]));
}

} // namespace

QString withUnit(const QString &number, const QString &unit)
{
    return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit;
}

QString withDecimalPoint(QString number)
{
    return number.replace(QLatin1Char('.'), QLocale().decimalPoint());
}

QString dash()
{
    return QString(QChar(0x2013));
}

QString number(double value, int decimals)
{
    if (!std::isfinite(value))
        return dash();
    QString text = QString::number(std::abs(value), 'f', decimals);
    const bool isZero = text.toDouble() == 0.0;
    if (value < 0 && !isZero)
        text.prepend(kMinus);
    return withDecimalPoint(std::move(text));
}

QString grouped(std::uint64_t value)
{
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() & ~QLocale::OmitGroupSeparator);
    return locale.toString(static_cast<qulonglong>(value));
}

UnitScale altitudeScale(UnitSystem units)
{
    return units == UnitSystem::Metric ? UnitScale{1, "m", 1} : UnitScale{kFeetPerMetre, "ft", 0};
}

UnitScale speedScale(UnitSystem units)
{
    switch (units) {
    case UnitSystem::Imperial: return {3600 / kMetresPerMile, "mph", 1};
    case UnitSystem::Aviation: return {3600 / kMetresPerNauticalMile, "kt", 1};
    case UnitSystem::Metric: break;
    }
    return {1, "m/s", 1};
}

UnitScale climbScale(UnitSystem units)
{
    return units == UnitSystem::Metric ? UnitScale{1, "m/s", 1} : UnitScale{60 * kFeetPerMetre, "ft/min", 0};
}

UnitScale smallDistanceScale(UnitSystem units)
{
    return units == UnitSystem::Metric ? UnitScale{1, "m", 0} : UnitScale{kFeetPerMetre, "ft", 0};
}

UnitScale largeDistanceScale(UnitSystem units)
{
    switch (units) {
    case UnitSystem::Imperial: return {1 / kMetresPerMile, "mi", 2};
    case UnitSystem::Aviation: return {1 / kMetresPerNauticalMile, "NM", 2};
    case UnitSystem::Metric: break;
    }
    return {0.001, "km", 1};
}

UnitScale distanceScale(double metres, UnitSystem units)
{
    const double longest = units == UnitSystem::Metric ? 9999.5
        : units == UnitSystem::Imperial                ? kMetresPerMile
                                                       : kMetresPerNauticalMile / 2;
    return std::abs(metres) >= longest ? largeDistanceScale(units) : smallDistanceScale(units);
}

Figure figureIn(const UnitScale &scale, double value)
{
    return {number(value * scale.factor, scale.decimals), QString::fromLatin1(scale.name)};
}

Figure altitudeFigure(double metres, UnitSystem units)
{
    return figureIn(altitudeScale(units), metres);
}

Figure distanceFigure(double metres, UnitSystem units)
{
    return figureIn(distanceScale(metres, units), metres);
}

Figure speedFigure(double metresPerSecond, UnitSystem units)
{
    return figureIn(speedScale(units), metresPerSecond);
}

Figure climbFigure(double metresPerSecond, UnitSystem units)
{
    return figureIn(climbScale(units), metresPerSecond);
}

Figure headingFigure(double degrees)
{
    if (!std::isfinite(degrees))
        return {dash(), QStringLiteral("°")};
    const int whole = ((static_cast<int>(std::lround(degrees)) % 360) + 360) % 360;
    return {QStringLiteral("%1").arg(whole, 3, 10, QLatin1Char('0')), QStringLiteral("°")};
}

QString durationText(double seconds)
{
    if (!std::isfinite(seconds) || seconds < 0)
        return dash();
    const auto whole = static_cast<qint64>(seconds);
    const QLatin1Char zero('0');
    if (whole >= 3600) {
        return QStringLiteral("%1:%2:%3").arg(whole / 3600).arg(whole / 60 % 60, 2, 10, zero).arg(whole % 60, 2, 10, zero);
    }
    return QStringLiteral("%1:%2").arg(whole / 60, 2, 10, zero).arg(whole % 60, 2, 10, zero);
}

QString rateText(double bytesPerSecond)
{
    return scaled(bytesPerSecond, {"B/s", "kB/s", "MB/s", "GB/s"});
}

QString sizeText(std::uint64_t bytes)
{
    return scaled(static_cast<double>(bytes), {"B", "kB", "MB", "GB"});
}

QString latencyText(double seconds)
{
    if (!std::isfinite(seconds))
        return dash();
    if (seconds < 0.00995)
        return withUnit(number(seconds * 1000, 1), QStringLiteral("ms"));
    return withUnit(QString::number(std::lround(seconds * 1000)), QStringLiteral("ms"));
}

} // namespace skyseal::ui
