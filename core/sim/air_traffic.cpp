#include "core/sim/air_traffic.h"

#include "core/mavlink/enums.h"
#include "core/sim/wire_units.h"

#include <numbers>
#include <string>

namespace skyseal::sim {

namespace {

constexpr std::uint32_t kFirstAddress = 0x7c0000; // Australia's block of ICAO addresses, where the field is
constexpr double kTurn = 2 * std::numbers::pi;

} // namespace

std::optional<mavlink::AdsbVehicle> AirTraffic::nextReport()
{
    using namespace mavlink;
    const FlightContext &flight = m_autopilot.flight();
    const int count = flight.parameters.integer("SIM_ADSB_COUNT");
    if (count <= 0)
        return std::nullopt;
    const int index = m_turn++ % count;
    const double radius = flight.parameter("SIM_ADSB_RADIUS"), height = flight.parameter("SIM_ADSB_ALT");
    const double flown = kSpeed * static_cast<double>(m_autopilot.time()) * 1e-6 / std::max(radius, 1.0); // radians
    const double angle = std::fmod(flown + kTurn * index / count, kTurn);                                 // from north
    const GeoPoint place = flight.world.toGeo({radius * std::cos(angle), radius * std::sin(angle), -height});

    AdsbVehicle out;
    out.ICAO_address = kFirstAddress + static_cast<std::uint32_t>(index);
    out.lat = scaled<std::int32_t>(place.latitude, 1e7);
    out.lon = scaled<std::int32_t>(place.longitude, 1e7);
    out.altitude_type = ADSB_ALTITUDE_TYPE_GEOMETRIC;
    out.altitude = scaled<std::int32_t>(place.altitude, 1000);
    out.heading = scaled<std::uint16_t>(std::fmod(degrees(angle) + 90, 360), 100);
    out.hor_velocity = scaled<std::uint16_t>(kSpeed, 100);
    out.emitter_type = ADSB_EMITTER_TYPE_LIGHT;
    const std::string callsign = "SIM" + std::to_string(index + 1);
    std::copy(callsign.begin(), callsign.end(), out.callsign.begin());
    out.flags = ADSB_FLAGS_VALID_COORDS | ADSB_FLAGS_VALID_ALTITUDE | ADSB_FLAGS_VALID_HEADING | ADSB_FLAGS_VALID_VELOCITY
        | ADSB_FLAGS_VERTICAL_VELOCITY_VALID | ADSB_FLAGS_VALID_CALLSIGN | ADSB_FLAGS_SIMULATED;
    return out;
}

} // namespace skyseal::sim
