#include "ui/text/coordinates.h"

#include <cmath>

namespace skyseal::ui {

namespace {

QString decimal(double degrees)
{
    constexpr int kDecimals = 6;
    return QString::number(degrees, 'f', kDecimals);
}

/// Rounded as a whole, so that no seconds read 60.0.
QString sexagesimal(double degrees, QChar positive, QChar negative)
{
    const auto tenths = std::llround(std::abs(degrees) * 36000);
    const QChar zero = QLatin1Char('0');
    return QStringLiteral("%1°%2'%3.%4\" %5")
        .arg(tenths / 36000)
        .arg(tenths / 600 % 60, 2, 10, zero)
        .arg(tenths / 10 % 60, 2, 10, zero)
        .arg(tenths % 10)
        .arg(degrees < 0 ? negative : positive);
}

QString joined(double latitude, double longitude, CoordinateFormat format, const QString &separator)
{
    if (format == CoordinateFormat::DegreesMinutesSeconds)
        return sexagesimal(latitude, QLatin1Char('N'), QLatin1Char('S')) + separator
            + sexagesimal(longitude, QLatin1Char('E'), QLatin1Char('W'));
    return decimal(latitude) + separator + decimal(longitude);
}

} // namespace

QString coordinatesText(double latitude, double longitude, CoordinateFormat format)
{
    constexpr char16_t kMinus = 0x2212;
    return joined(latitude, longitude, format, QStringLiteral(" ")).replace(QLatin1Char('-'), QChar(kMinus));
}

QString coordinatesToCopy(double latitude, double longitude, CoordinateFormat format)
{
    return joined(latitude, longitude, format, QStringLiteral(", "));
}

} // namespace skyseal::ui
