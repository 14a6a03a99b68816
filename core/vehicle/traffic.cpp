#include "core/vehicle/traffic.h"

#include "core/vehicle/geodesy.h"
#include "core/vehicle/known_value.h"

#include <algorithm>
#include <limits>

namespace skyseal::vehicle {

namespace {

constexpr double kDegrees = 1e-7, kMillimetres = 1e-3, kCentimetres = 1e-2, kCentidegrees = 1e-2;

/// Flags and the value of the field both say that it is not known; receivers set one or the other.
template<auto Field> double flagged(const mavlink::AdsbVehicle &m, std::uint16_t flag, double unit)
{
    return (m.flags & flag) != 0 ? known<Field>(m, unit) : kUnknown;
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
    out.position.latitude = within(flagged<&AdsbVehicle::lat>(m, ADSB_FLAGS_VALID_COORDS, kDegrees), 90);
    out.position.longitude = within(flagged<&AdsbVehicle::lon>(m, ADSB_FLAGS_VALID_COORDS, kDegrees), 180);
    out.position.altitude = flagged<&AdsbVehicle::altitude>(m, ADSB_FLAGS_VALID_ALTITUDE, kMillimetres);
    out.heading = within(flagged<&AdsbVehicle::heading>(m, ADSB_FLAGS_VALID_HEADING, kCentidegrees), 360);
    out.groundSpeed = flagged<&AdsbVehicle::hor_velocity>(m, ADSB_FLAGS_VALID_VELOCITY, kCentimetres);
    out.climb = flagged<&AdsbVehicle::ver_velocity>(m, ADSB_FLAGS_VERTICAL_VELOCITY_VALID, kCentimetres);
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
