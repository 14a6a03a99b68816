#include "ui/text/units.h"

#include <cmath>

namespace skyseal::ui {

namespace {

const QChar kThinSpace(0x2009);
const QChar kMinus(0x2212);

QString scaled(double value, const char *const (&names)[4])
{
    std::size_t step = 0;
    while (value >= 999.5 && step < 3) {
        value /= 1000;
        ++step;
    }
    return QString::number(value, 'f', value < 9.95 && step > 0 ? 1 : 0) + QLatin1Char(' ') + QLatin1String(names[step]);
}

} // namespace

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
    return text;
}

QString grouped(std::uint64_t value)
{
    QString text = QString::number(value);
    for (qsizetype at = text.size() - 3; at > 0; at -= 3)
        text.insert(at, kThinSpace);
    return text;
}

Figure altitudeFigure(double metres, UnitSystem units)
{
    if (units == UnitSystem::Imperial)
        return {number(metres * kFeetPerMetre, 0), QStringLiteral("ft")};
    return {number(metres, 1), QStringLiteral("m")};
}

Figure distanceFigure(double metres, UnitSystem units)
{
    if (units == UnitSystem::Imperial)
        return {number(metres * kFeetPerMetre, 0), QStringLiteral("ft")};
    if (metres >= 9999.5)
        return {number(metres / 1000, 1), QStringLiteral("km")};
    return {number(metres, 0), QStringLiteral("m")};
}

Figure speedFigure(double metresPerSecond, UnitSystem units)
{
    if (units == UnitSystem::Imperial)
        return {number(metresPerSecond * kMilesPerHourPerMetreASecond, 1), QStringLiteral("mph")};
    return {number(metresPerSecond, 1), QStringLiteral("m/s")};
}

Figure climbFigure(double metresPerSecond, UnitSystem units)
{
    if (units == UnitSystem::Imperial)
        return {number(metresPerSecond * kFeetPerMinutePerMetreASecond, 0), QStringLiteral("ft/min")};
    return {number(metresPerSecond, 1), QStringLiteral("m/s")};
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
        return QString::number(seconds * 1000, 'f', 1) + QStringLiteral(" ms");
    return QString::number(std::lround(seconds * 1000)) + QStringLiteral(" ms");
}

} // namespace skyseal::ui
