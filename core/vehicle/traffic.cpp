#include "core/vehicle/traffic.h"

#include "core/vehicle/geodesy.h"
#include "core/vehicle/known_value.h"

#include <algorithm>
#include <limits>

namespace skyseal::vehicle {

namespace {

constexpr double kDegrees = 1e-7, kMillimetres = 1e-3, kCentimetres = 1e-2, kCentidegrees = 1e-2;

/// Flags and the "invalid" value both say that a field is not known; receivers set one or the other.
template<typename Wire> double known(const mavlink::AdsbVehicle &m, std::uint16_t flag, Wire value, double unit)
{
    return (m.flags & flag) != 0 && value != std::numeric_limits<Wire>::max() ? static_cast<double>(value) * unit : kUnknown;
}

/// Callsigns have capital letters and figures; receivers fill up with spaces.
bool isCallsignLetter(char letter)
{
    return (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9');
}

Aircraft aircraftOf(const mavlink::AdsbVehicle &m)
{
    using namespace mavlink;
    Aircraft out;
    out.address = m.ICAO_address;
    out.position.latitude = within(known(m, ADSB_FLAGS_VALID_COORDS, m.lat, kDegrees), 90);
    out.position.longitude = within(known(m, ADSB_FLAGS_VALID_COORDS, m.lon, kDegrees), 180);
    out.position.altitude = known(m, ADSB_FLAGS_VALID_ALTITUDE, m.altitude, kMillimetres);
    out.heading = within(known(m, ADSB_FLAGS_VALID_HEADING, m.heading, kCentidegrees), 360);
    out.groundSpeed = known(m, ADSB_FLAGS_VALID_VELOCITY, m.hor_velocity, kCentimetres);
    out.climb = known(m, ADSB_FLAGS_VERTICAL_VELOCITY_VALID, m.ver_velocity, kCentimetres);
    if (m.flags & ADSB_FLAGS_VALID_CALLSIGN)
        for (const char letter : textOf(m.callsign))
            if (isCallsignLetter(letter))
                out.callsign += letter;
    out.simulated = (m.flags & ADSB_FLAGS_SIMULATED) != 0;
    return out;
}

} // namespace

Traffic::Entry *Traffic::placeFor(TimePoint now, std::uint32_t address, const Position &where, const Position &own)
{
    const auto same = std::ranges::find(m_entries, address, [](const Entry &entry) { return entry.aircraft.address; });
    if (same != m_entries.end())
        return &*same;
    std::erase_if(m_entries, [now](const Entry &entry) { return now - entry.heard >= kForgottenAfter; });
    if (m_entries.size() < kMost)
        return &m_entries.emplace_back();
    const auto distance = [&own](const Position &place) {
        const double metres = distanceMetres(place, own);
        return std::isnan(metres) ? std::numeric_limits<double>::infinity() : metres;
    };
    const auto farthest = std::ranges::max_element(
        m_entries, {}, [&distance](const Entry &entry) { return distance(entry.aircraft.position); });
    return distance(where) < distance(farthest->aircraft.position) ? &*farthest : nullptr;
}

void Traffic::handle(TimePoint now, const mavlink::AdsbVehicle &report, const Position &own)
{
    const Aircraft aircraft = aircraftOf(report);
    const TimePoint heard = now - std::chrono::seconds(report.tslc);
    if (now - heard >= kForgottenAfter)
        return;
    if (Entry *entry = placeFor(now, aircraft.address, aircraft.position, own))
        *entry = {aircraft, heard};
}

std::vector<Aircraft> Traffic::aircraft(TimePoint now) const
{
    std::vector<Aircraft> out;
    for (const Entry &entry : m_entries) {
        if (now - entry.heard >= kForgottenAfter)
            continue;
        out.push_back(entry.aircraft);
        out.back().age = seconds(now - entry.heard);
    }
    return out;
}

} // namespace skyseal::vehicle
