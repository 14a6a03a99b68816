#include "ui/text/aircraft_text.h"

#include "core/engine/text/qt_text.h"
#include "core/vehicle/geodesy.h"

#include <QtCore/QCoreApplication>

#include <cmath>

namespace skyseal::ui {

namespace {

/// The translation context of this file.
struct AircraftText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::AircraftText)
};

/// As exact as aircraft report their altitude.
UnitScale wholeAltitudes(UnitSystem units)
{
    UnitScale scale = altitudeScale(units);
    scale.decimals = 0;
    return scale;
}

} // namespace

AircraftSight sightOf(const vehicle::Aircraft &aircraft, const vehicle::Position &own)
{
    AircraftSight out{.name = engine::fromStd(aircraft.callsign)};
    if (out.name.isEmpty())
        out.name = QStringLiteral("%1").arg(aircraft.address, 6, 16, QLatin1Char('0')).toUpper();
    out.address = aircraft.address;
    out.metres = vehicle::distanceMetres(aircraft.position, own);
    out.metresAbove = aircraft.position.altitude - own.altitude;
    const bool apartInHeight = std::abs(out.metresAbove) >= kNearMetresInHeight; // false for an unknown height
    out.isNear = out.metres < kNearMetres && !apartInHeight;
    return out;
}

std::optional<AircraftSight> nearestOf(const vehicle::VehicleState &vehicle)
{
    std::optional<AircraftSight> nearest;
    for (const vehicle::Aircraft &aircraft : vehicle.traffic) {
        const AircraftSight sight = sightOf(aircraft, vehicle.position);
        if (sight.isNear && (!nearest || sight.metres < nearest->metres))
            nearest = sight;
    }
    return nearest;
}

QString aircraftText(const AircraftSight &sight, UnitSystem units)
{
    const QString sign = sight.metresAbove >= 0 ? QStringLiteral("+") : QString();
    const QString height = std::isnan(sight.metresAbove) ? AircraftText::tr("altitude unknown")
                                                         : sign + figureIn(wholeAltitudes(units), sight.metresAbove).text();
    const QString text = QStringLiteral("%1 · %2").arg(sight.name, height);
    return sight.isNear ? AircraftText::tr("%1 · near").arg(text) : text;
}

} // namespace skyseal::ui
