#include "core/sim/fence.h"

#include <algorithm>

namespace skyseal::sim {

using namespace mavlink;

namespace {
constexpr double kRepeat = 20;                  // m
constexpr std::uint64_t kRecovery = 10'000'000; // µs
constexpr std::uint16_t kMostCounted = 65500;
} // namespace

bool Fence::selected(std::uint8_t kind) const
{
    return (m_parameters.integer("FENCE_TYPE") & kind) != 0;
}

bool Fence::present() const
{
    return selected(FENCE_TYPE_ALT_MAX | FENCE_TYPE_ALT_MIN | FENCE_TYPE_CIRCLE)
        || (selected(FENCE_TYPE_POLYGON) && !m_areas.empty());
}

bool Fence::enabled() const
{
    return m_parameters.flag("FENCE_ENABLE");
}

void Fence::enable(bool on)
{
    m_parameters.set("FENCE_ENABLE", on);
    m_floor = on;
    if (!on)
        m_breaches = 0;
}

void Fence::disableFloor()
{
    m_floor = false;
    m_breaches &= static_cast<std::uint8_t>(~FENCE_TYPE_ALT_MIN);
}

bool Fence::exceeds(std::uint64_t time, Limit &limit, double beyond)
{
    if (beyond < 0) {
        m_breaches &= static_cast<std::uint8_t>(~limit.kind);
        limit.beyond = 0;
        return false;
    }
    limit.beyond = beyond;
    if ((m_breaches & limit.kind) && beyond < limit.repeatAt)
        return false;
    if (m_breaches == 0)
        m_time = static_cast<std::uint32_t>(time / 1000);
    m_breaches |= limit.kind;
    m_count = std::min<std::uint16_t>(m_count + 1, kMostCounted);
    limit.repeatAt = beyond + kRepeat;
    return true;
}

std::uint8_t Fence::check(std::uint64_t time, const Situation &s)
{
    if (!enabled()) {
        m_breaches = 0;
        return 0;
    }
    m_breaches &= static_cast<std::uint8_t>(m_parameters.integer("FENCE_TYPE"));
    if (time < m_recoveryUntil)
        return 0;
    std::uint8_t fresh = 0;
    const auto look = [&](Limit &limit, double beyond) {
        if (selected(limit.kind) && exceeds(time, limit, beyond))
            fresh |= limit.kind;
    };
    look(m_maxAltitude, s.heightAboveHome() - value("FENCE_ALT_MAX"));
    if (m_floor)
        look(m_minAltitude, value("FENCE_ALT_MIN") - s.heightAboveHome());
    if (s.estimate.positionOk) { // without a position, a breach stays what it is
        const Vector3 &here = s.estimate.position;
        look(m_circle, (here - s.home).horizontal() - value("FENCE_RADIUS"));
        look(m_polygon, m_areas.allow(here) ? -1 : 0);
    }
    return fresh;
}

void Fence::beginRecovery(std::uint64_t time)
{
    if (m_breaches != 0 && m_parameters.integer("FENCE_ACTION") != 0)
        m_recoveryUntil = time + kRecovery;
}

bool Fence::allows(const Vector3 &place, const Vector3 &home) const
{
    if (!enabled())
        return true;
    const double height = home.z - place.z;
    return !(selected(FENCE_TYPE_ALT_MAX) && height > value("FENCE_ALT_MAX"))
        && !(selected(FENCE_TYPE_ALT_MIN) && height < value("FENCE_ALT_MIN"))
        && !(selected(FENCE_TYPE_CIRCLE) && (place - home).horizontal() > value("FENCE_RADIUS"))
        && !(selected(FENCE_TYPE_POLYGON) && !m_areas.allow(place));
}

const char *Fence::preArm(bool hasPosition) const
{
    if (!enabled())
        return nullptr;
    if (!present())
        return "Fences enabled, but none selected";
    if (selected(FENCE_TYPE_CIRCLE | FENCE_TYPE_POLYGON) && !hasPosition)
        return "Fence requires position";
    if (m_breaches != 0)
        return "vehicle outside fence";
    const double margin = value("FENCE_MARGIN");
    if (value("FENCE_RADIUS") < margin)
        return "FENCE_MARGIN is less than FENCE_RADIUS"; // ArduPilot's text, although it means the opposite
    if (value("FENCE_ALT_MAX") < value("FENCE_ALT_MIN"))
        return "FENCE_ALT_MAX < FENCE_ALT_MIN";
    if (value("FENCE_ALT_MAX") - value("FENCE_ALT_MIN") <= 2 * margin)
        return "FENCE_MARGIN too big";
    return nullptr;
}

double Fence::breachDistance(std::uint8_t kinds) const
{
    double most = 0;
    for (const Limit *limit : {&m_maxAltitude, &m_minAltitude, &m_circle}) {
        if (kinds & limit->kind)
            most = std::max(most, limit->beyond);
    }
    return most;
}

} // namespace skyseal::sim
