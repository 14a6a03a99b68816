// The flight modes: what the simulation flies, and the numbers and names that each firmware gives them.
#pragma once

#include "core/sim/vehicle_type.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace skyseal::sim {

/// Numbered as ArduCopter's modes as far as it has them.
enum class FlightMode : std::uint32_t {
    Stabilize = mavlink::COPTER_MODE_STABILIZE,
    AltHold = mavlink::COPTER_MODE_ALT_HOLD,
    Auto = mavlink::COPTER_MODE_AUTO,
    Guided = mavlink::COPTER_MODE_GUIDED, ///< of PX4: AUTO.LOITER, which DO_REPOSITION moves
    Loiter = mavlink::COPTER_MODE_LOITER,
    Rtl = mavlink::COPTER_MODE_RTL,
    Land = mavlink::COPTER_MODE_LAND,
    Brake = mavlink::COPTER_MODE_BRAKE,
    Manual = 100,
    FlyByWireA,
    Circle,
    TakeOff,
    Hold,
    Steering,
    Offboard
};

struct ModeRow
{
    FlightMode mode;
    std::uint32_t number;  ///< custom_mode of HEARTBEAT
    std::string_view name; ///< as the firmware spells it
    bool needsPosition;
    bool allowsArming; ///< AUTO of ArduPilot also depends on AUTO_OPTIONS
    bool manualThrottle;
};

/// The modes of one type of vehicle. The first is that of power-on.
class ModeTable
{
public:
    constexpr ModeTable(std::span<const ModeRow> rows, FlightMode fallback) : m_rows(rows), m_fallback(fallback) {}

    std::span<const ModeRow> rows() const { return m_rows; }
    /// nullptr if the vehicle has no such mode.
    const ModeRow *find(FlightMode mode) const;
    const ModeRow *withNumber(std::uint32_t number) const;
    /// The row of a mode that the vehicle has, or of the first.
    const ModeRow &row(FlightMode mode) const;
    /// The mode itself, or what this type of vehicle does in its stead when a failsafe wants it.
    FlightMode available(FlightMode mode) const { return find(mode) ? mode : m_fallback; }

private:
    std::span<const ModeRow> m_rows;
    FlightMode m_fallback;
};

const ModeTable &modeTable(const VehicleType &type);

} // namespace skyseal::sim
