#include "ui/text/coordinates.h"

#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace skyseal::ui {

namespace {

/// The translation context of this file.
struct CoordinatesText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::Coordinates)
};

QString decimal(double degrees)
{
    constexpr int kDecimals = 6;
    return QString::number(degrees, 'f', kDecimals);
}

/// Rounded as a whole, so that no seconds read 60.0.
QString sexagesimal(double degrees, const QString &positive, const QString &negative)
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

/// Letters of north, east, south and west.
using Letters = std::array<QString, 4>;

QString joined(double latitude, double longitude, CoordinateFormat format, const QString &separator, const Letters &letters)
{
    if (format == CoordinateFormat::DegreesMinutesSeconds)
        return sexagesimal(latitude, letters[0], letters[2]) + separator + sexagesimal(longitude, letters[1], letters[3]);
    return decimal(latitude) + separator + decimal(longitude);
}

/// A place in the grid of its standard zone, which differs around Norway and Svalbard, or in the polar grid.
/// https://geographiclib.sourceforge.io/C++/doc/classGeographicLib_1_1UTMUPS.html
struct GridPlace
{
    int zone = 0; ///< 0: polar
    bool north = true;
    double easting = 0, northing = 0; ///< metres
    std::string mgrs;                 ///< to the metre: zone and band, two letters of the square, ten digits
};

/// Nothing for a latitude beyond the poles or a value that is no number.
std::optional<GridPlace> gridPlace(double latitude, double longitude)
{
    if (!std::isfinite(latitude) || !std::isfinite(longitude))
        return std::nullopt;
    constexpr int kMetreDigits = 5;
    try {
        GridPlace out;
        GeographicLib::UTMUPS::Forward(latitude, longitude, out.zone, out.north, out.easting, out.northing);
        GeographicLib::MGRS::Forward(out.zone, out.north, out.easting, out.northing, latitude, kMetreDigits, out.mgrs);
        return out;
    } catch (const GeographicLib::GeographicErr &) {
        return std::nullopt;
    }
}

QString metres(double value)
{
    return QString::number(std::llround(value));
}

/// With the hemisphere in words: a single letter could be that of a band, and band S is in the north.
QString utmText(const GridPlace &place)
{
    const QString hemisphere = place.north ? CoordinatesText::tr("north") : CoordinatesText::tr("south");
    const QString zone = place.zone == 0 ? QStringLiteral("UPS") : QString::number(place.zone);
    return CoordinatesText::tr("%1 %2 %3 mE %4 mN").arg(zone, hemisphere, metres(place.easting), metres(place.northing));
}

/// As GeographicLib writes it, in lower case, which no band has.
QString utmToCopy(const GridPlace &place)
{
    const QString zone = place.zone == 0 ? QString() : QString::number(place.zone);
    return QStringLiteral("%1%2 %3 %4")
        .arg(zone, place.north ? QStringLiteral("n") : QStringLiteral("s"), metres(place.easting), metres(place.northing));
}

QString mgrsText(const GridPlace &place)
{
    const QString text = QString::fromStdString(place.mgrs);
    const qsizetype square = text.size() - 12; // the zone of the polar grid has no number
    return QStringLiteral("%1 %2 %3 %4").arg(text.left(square), text.mid(square, 2), text.mid(square + 2, 5), text.right(5));
}

} // namespace

QString compassLetter(Compass direction)
{
    switch (direction) {
    case Compass::North: return CoordinatesText::tr("N", "north");
    case Compass::East: return CoordinatesText::tr("E", "east");
    case Compass::South: return CoordinatesText::tr("S", "south");
    case Compass::West: break;
    }
    return CoordinatesText::tr("W", "west");
}

QString coordinatesText(double latitude, double longitude, CoordinateFormat format)
{
    if (format == CoordinateFormat::Utm || format == CoordinateFormat::Mgrs) {
        const auto place = gridPlace(latitude, longitude);
        if (!place)
            return dash();
        return format == CoordinateFormat::Utm ? utmText(*place) : mgrsText(*place);
    }
    constexpr char16_t kMinus = 0x2212;
    const Letters letters{compassLetter(Compass::North), compassLetter(Compass::East), compassLetter(Compass::South),
                          compassLetter(Compass::West)};
    QString text = joined(latitude, longitude, format, QStringLiteral(" "), letters);
    return withDecimalPoint(text.replace(QLatin1Char('-'), QChar(kMinus)));
}

QString coordinatesToCopy(double latitude, double longitude, CoordinateFormat format)
{
    if (format == CoordinateFormat::Utm || format == CoordinateFormat::Mgrs) {
        const auto place = gridPlace(latitude, longitude);
        if (!place)
            return {};
        return format == CoordinateFormat::Utm ? utmToCopy(*place) : QString::fromStdString(place->mgrs);
    }
    return joined(latitude, longitude, format, QStringLiteral(", "),
                  {QStringLiteral("N"), QStringLiteral("E"), QStringLiteral("S"), QStringLiteral("W")});
}

QString widestCoordinates(CoordinateFormat format)
{
    const double latitude = format == CoordinateFormat::Utm ? -82 : -10.1; // "UPS south" is longer than a zone
    return coordinatesText(latitude, -110.5, format);
}

} // namespace skyseal::ui
