#include "core/sim/gps.h"

#include <utility>

namespace skyseal::sim {

namespace {

constexpr double kPeriod = 0.2; // s between reports, and the age of each
constexpr int kFullSky = 14;

} // namespace

void Gps::step(double dt, std::uint64_t time, const BodyState &truth, const Faults &faults)
{
    m_searching = faults.gpsDisabled ? 0 : m_searching + dt;
    m_untilReport -= dt;
    if (m_untilReport > 0)
        return;
    m_untilReport += kPeriod;
    m_report = std::exchange(m_next, {});
    takeReport(time, truth, faults.gpsGlitch);
}

void Gps::takeReport(std::uint64_t time, const BodyState &truth, const Vector3 &glitch)
{
    const double north = m_north.step(m_noise, kPeriod);
    const double east = m_east.step(m_noise, kPeriod);
    const double down = m_down.step(m_noise, kPeriod);

    // Four satellites make the fix; the rest of the sky comes in over the next ten seconds.
    const double progress = m_firstFix > 0 ? m_searching / m_firstFix : 2;
    m_next.fixed = m_searching > 0 && progress >= 1;
    m_next.takenAt = time;
    if (!m_next.fixed) {
        m_next.satellites = static_cast<int>(progress * 4);
        return;
    }
    const double since = m_searching - m_firstFix;
    const int outlook = kFullSky - (m_noise.uniform() < 0.1 ? 1 : 0);
    m_next.satellites = std::min(6 + static_cast<int>(since * 0.8), outlook);
    m_next.hdop = 0.5 + 4.0 / m_next.satellites;
    m_next.vdop = m_next.hdop * 1.4;
    m_next.position = truth.position + Vector3{north, east, down} + glitch;
    m_next.glitch = glitch;
    m_next.velocity = truth.velocity + Vector3{m_noise.normal(0.03), m_noise.normal(0.03), m_noise.normal(0.05)};
}

} // namespace skyseal::sim
