// Stands for the extended Kalman filter: its estimate is the truth with the small, slowly wandering errors of a good
// filter, and its health follows the GPS as ArduPilot's EKF3 does.
#pragma once

#include "core/sim/airframe.h"
#include "core/sim/estimate.h"
#include "core/sim/gps.h"

namespace skyseal::sim {

/// Ratios of the innovations to their limits; 1 is the limit.
struct FilterVariances
{
    double velocity = 0;
    double horizontal = 0;
    double vertical = 0;
    double compass = 0;
};

class Estimator
{
public:
    explicit Estimator(std::uint64_t seed) : m_noise(seed, 3) {}

    /// Moves on by `dt` seconds.
    void step(double dt, const BodyState &truth, const GpsReport &gps, bool compassFailed);

    const Estimate &estimate() const { return m_estimate; }
    const FilterVariances &variances() const { return m_variances; }
    /// Whether the GPS jumped away and is not followed.
    bool glitching() const { return m_glitchingFor > 0; }
    /// EKF_STATUS_FLAGS as EKF_STATUS_REPORT carries them.
    std::uint16_t flags() const;

private:
    void followGps(double dt, bool fixed);
    /// A position that jumps away is refused at first, and followed when it stays there.
    void followGlitch(double dt, const Vector3 &glitch);

    Noise m_noise;
    Drift m_north{0.12, 25}, m_east{0.12, 25}, m_down{0.10, 40};
    Drift m_northSpeed{0.025, 1}, m_eastSpeed{0.025, 1}, m_downSpeed{0.02, 1};
    Drift m_roll{radians(0.12), 8}, m_pitch{radians(0.12), 8}, m_yaw{radians(0.4), 15};
    double m_age = 0;     ///< s since power-on
    double m_withFix = 0; ///< s of uninterrupted fixes
    double m_withoutFix = 0;
    Vector3 m_glitch;            ///< m, NED: error of the GPS that the estimate has taken over
    double m_glitchDistance = 0; ///< m from there to where the GPS is now
    double m_glitchingFor = 0;   ///< s
    Estimate m_estimate;
    FilterVariances m_variances;
};

} // namespace skyseal::sim
