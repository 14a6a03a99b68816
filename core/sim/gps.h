// A satellite receiver: finds its first fix after a while, reports five times a second with a lag, and errs by a slowly
// wandering metre.
#pragma once

#include "core/sim/airframe.h"
#include "core/sim/faults.h"
#include "core/sim/noise.h"

namespace skyseal::sim {

struct GpsReport
{
    bool fixed = false; ///< three-dimensional fix
    int satellites = 0;
    double hdop = 99.99;
    double vdop = 99.99;
    Vector3 position;          ///< m, NED from the origin
    Vector3 velocity;          ///< m/s, NED
    Vector3 glitch;            ///< m, NED: part of `position`, the error that a fault adds
    std::uint64_t takenAt = 0; ///< µs of flight time
};

class Gps
{
public:
    /// `firstFix` in seconds after power-on.
    Gps(std::uint64_t seed, double firstFix) : m_noise(seed, 2), m_firstFix(firstFix) {}

    /// Moves on by `dt` seconds; `time` is the flight time in µs. A disabled receiver loses its fix and starts again.
    void step(double dt, std::uint64_t time, const BodyState &truth, const Faults &faults);

    const GpsReport &report() const { return m_report; }

private:
    void takeReport(std::uint64_t time, const BodyState &truth, const Vector3 &glitch);

    Noise m_noise;
    double m_firstFix;
    double m_searching = 0; ///< s since power-on or loss
    double m_untilReport = 0;
    Drift m_north{0.35, 40}, m_east{0.35, 40}, m_down{0.7, 40};
    GpsReport m_report;
    GpsReport m_next; ///< taken 0.2 s before it is reported
};

} // namespace skyseal::sim
