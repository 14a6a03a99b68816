#include "core/sim/flight_mode.h"

#include <array>

namespace skyseal::sim {

namespace {

struct Row
{
    FlightMode mode;
    std::string_view name;
    bool needsPosition;
    bool allowsArming;
    bool manualThrottle;
};

constexpr std::array<Row, 8> kModes{{
    {FlightMode::Stabilize, "STABILIZE", false, true, true},
    {FlightMode::AltHold, "ALT_HOLD", false, true, true},
    {FlightMode::Auto, "AUTO", true, false, false},
    {FlightMode::Guided, "GUIDED", true, true, false},
    {FlightMode::Loiter, "LOITER", true, true, true},
    {FlightMode::Rtl, "RTL", true, false, false},
    {FlightMode::Land, "LAND", false, false, false},
    {FlightMode::Brake, "BRAKE", true, false, false},
}};

const Row &row(FlightMode mode)
{
    for (const Row &candidate : kModes) {
        if (candidate.mode == mode)
            return candidate;
    }
    return kModes[0];
}

} // namespace

std::optional<FlightMode> flightMode(std::uint32_t number)
{
    for (const Row &candidate : kModes) {
        if (static_cast<std::uint32_t>(candidate.mode) == number)
            return candidate.mode;
    }
    return std::nullopt;
}

std::string_view name(FlightMode mode)
{
    return row(mode).name;
}

bool needsPosition(FlightMode mode)
{
    return row(mode).needsPosition;
}

bool allowsArming(FlightMode mode, int autoOptions)
{
    return mode == FlightMode::Auto ? (autoOptions & 1) != 0 : row(mode).allowsArming;
}

bool hasManualThrottle(FlightMode mode)
{
    return row(mode).manualThrottle;
}

} // namespace skyseal::sim
