// Aircraft in the neighbourhood of a vehicle, as the map and the alerts describe them.
#pragma once

#include "core/vehicle/vehicle_state.h"
#include "ui/text/units.h"

#include <optional>

namespace skyseal::ui {

/// An aircraft is near if it is so close on the ground and in height. One of unknown height counts as of the same.
inline constexpr double kNearMetres = 500, kNearMetresInHeight = 150;

/// Where an aircraft is, seen from the vehicle.
struct AircraftSight
{
    std::uint32_t address = 0; ///< of ICAO
    QString name;              ///< callsign, or the ICAO address in hexadecimal digits
    double metres = 0;         ///< on the ground; NaN if one of the places is unknown
    double metresAbove = 0;    ///< above the vehicle; NaN if unknown
    bool isNear = false;
};

AircraftSight sightOf(const vehicle::Aircraft &aircraft, const vehicle::Position &own);
/// The nearest one of those that are near.
std::optional<AircraftSight> nearestOf(const vehicle::VehicleState &vehicle);
/// "SWR12A · +120 m", "SWR12A · altitude unknown"; with "near" if it is.
QString aircraftText(const AircraftSight &sight, UnitSystem units);

} // namespace skyseal::ui
