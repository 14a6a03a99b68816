// The geofence: limits of height and distance by FENCE_ parameters, and uploaded areas. Detects breaches as ArduPilot's
// AC_Fence does; the autopilot acts on them.
#pragma once

#include "core/sim/fence_areas.h"
#include "core/sim/parameters.h"
#include "core/sim/situation.h"

namespace skyseal::sim {

class Fence
{
public:
    static constexpr double kGiveUp = 100; ///< m beyond the fence from which the vehicle lands instead of returning

    explicit Fence(Parameters &parameters) : m_parameters(parameters) {}

    FenceAreas &areas() { return m_areas; }
    const FenceAreas &areas() const { return m_areas; }

    /// Whether FENCE_TYPE selects anything that could be breached.
    bool present() const;
    bool enabled() const;
    void enable(bool on);
    /// Stops watching the lowest altitude until the fence is enabled again.
    void disableFloor();

    /// Looks for breaches at a flight time in µs. Returns the bits (FENCE_TYPE) of those that began since the last call, or
    /// went another 20 m further.
    std::uint8_t check(std::uint64_t time, const Situation &s);
    /// A change of the flight mode: while breached, the pilot gets ten seconds to come back.
    void beginRecovery(std::uint64_t time);

    /// Whether a destination (m, NED from the origin) is within the enabled fence.
    bool allows(const Vector3 &place, const Vector3 &home) const;
    /// Reason that prevents arming, or nullptr.
    const char *preArm(bool hasPosition) const;

    std::uint8_t breaches() const { return m_breaches; } ///< bits of FENCE_TYPE
    std::uint16_t breachCount() const { return m_count; }
    std::uint32_t breachTime() const { return m_time; } ///< ms of flight time; 0 before the first
    /// The greatest distance (m) beyond the limits of `kinds`, as of the last check.
    double breachDistance(std::uint8_t kinds) const;

private:
    struct Limit
    {
        std::uint8_t kind;   ///< bit of FENCE_TYPE
        double beyond = 0;   ///< m
        double repeatAt = 0; ///< m beyond, at which the breach counts anew
    };
    bool exceeds(std::uint64_t time, Limit &limit, double beyond);
    bool selected(std::uint8_t kind) const;
    double value(const char *name) const { return static_cast<double>(m_parameters.value(name)); }

    Parameters &m_parameters;
    FenceAreas m_areas;
    Limit m_maxAltitude{mavlink::FENCE_TYPE_ALT_MAX}, m_minAltitude{mavlink::FENCE_TYPE_ALT_MIN},
        m_circle{mavlink::FENCE_TYPE_CIRCLE}, m_polygon{mavlink::FENCE_TYPE_POLYGON};
    std::uint8_t m_breaches = 0;
    std::uint16_t m_count = 0;
    std::uint32_t m_time = 0;
    std::uint64_t m_recoveryUntil = 0; ///< µs
    bool m_floor = true;
};

} // namespace skyseal::sim
