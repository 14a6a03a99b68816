#include "core/vehicle/plan_copy.h"

#include "core/vehicle/mission_place.h"
#include "core/vehicle/reasons.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace skyseal::vehicle {

namespace {

bool isNear(double a, double b, double tolerance = 0)
{
    return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance;
}

/// Both as the vehicle returns them.
bool isEqual(const MissionItem &a, const MissionItem &b)
{
    return a.command == b.command && a.frame == b.frame && a.autoContinue == b.autoContinue && isNear(a.latitude, b.latitude)
        && isNear(a.longitude, b.longitude) && isNear(a.altitude, b.altitude)
        && std::equal(std::begin(a.parameters), std::end(a.parameters), std::begin(b.parameters),
                      [](float x, float y) { return isNear(x, y); });
}

/// `sent` by this station, `kept` by a vehicle, which rounds, and drops what it does not use.
bool isLike(const MissionItem &sent, const MissionItem &kept)
{
    constexpr double kPlaces = 10, kMetres = 0.1; // of MISSION_ITEM_INT's units; of the altitude
    if (sent.command != kept.command)
        return false;
    if (hasPlace(sent) != hasPlace(kept))
        return false;
    const double tolerance = kPlaces / integerScale(sent);
    if (hasPlace(sent)
        && !(isNear(sent.latitude, kept.latitude, tolerance) && isNear(sent.longitude, kept.longitude, tolerance)))
        return false;
    return !hasAltitude(sent) || isNear(sent.altitude, kept.altitude, kMetres);
}

} // namespace

bool PlanCopy::isWatched(TimePoint now) const
{
    return m_outdated.empty() && m_items && m_namesIds && m_id && now >= m_settled && now - m_idHeard <= kFresh;
}

void PlanCopy::begin()
{
    m_isBusy = true;
    m_disturbed = {};
    m_answeredId = 0;
}

void PlanCopy::end(TimePoint now, MissionItems items, bool changed)
{
    m_items = std::move(items);
    m_isRead = !changed;
    m_isBusy = false;
    m_outdated = std::exchange(m_disturbed, {});
    m_isChangedByOther = !m_outdated.empty();
    m_settled = changed ? now + kSettling : now;
    m_id = m_answeredId != 0 ? std::optional(m_answeredId) : std::nullopt;
    m_isIdAnswered = m_answeredId != 0;
    m_total.reset();
}

void PlanCopy::fail(TimePoint now, bool mayHaveChanged)
{
    m_isBusy = false;
    if (!mayHaveChanged)
        return;
    m_settled = now + kSettlingFailed;
    if (m_items && m_outdated.empty())
        m_outdated = reasons::kPlanIncomplete;
}

void PlanCopy::handleCurrent(TimePoint now, std::uint32_t id, std::optional<std::uint16_t> total)
{
    if (m_isBusy)
        return;
    const bool settling = now < m_settled;
    const bool isEmpty = m_items && m_items->empty();
    if (id != 0 || m_namesIds || m_id.value_or(0) == 0) { // otherwise the vehicle names ids only in its answers
        const bool firstNamed = m_id == 0 && !m_namesIds && !isEmpty;
        if (!m_id || firstNamed || (settling && !m_isIdAnswered))
            m_id = id;
        else if (!settling && m_id != id)
            changedByOther(reasons::kPlanChanged);
        if (!settling)
            m_id = id;
        m_namesIds = m_namesIds || id != 0;
        m_idHeard = now;
    }
    if (!total || settling)
        return;
    if (m_total ? m_total != total : m_items && *total != m_items->size() && *total + 1u != m_items->size()) {
        const bool hasStarted = !m_items && m_total == 0; // its autopilot, which loads the list from its store
        if (!hasStarted)
            changedByOther(m_total ? reasons::kPlanCount(*total, *m_total) : reasons::kPlanChanged);
    }
    m_total = total;
}

void PlanCopy::handleCount(std::uint16_t count, std::uint32_t id)
{
    if (id != 0 && m_id.value_or(0) != 0 ? id != m_id : m_items && count != m_items->size())
        changedByOther(reasons::kPlanChanged);
}

void PlanCopy::handleItem(const MissionItem &item, bool skipsHome)
{
    if (!m_items || (skipsHome && item.sequence == 0))
        return;
    if (item.sequence >= m_items->size())
        return changedByOther(reasons::kPlanChanged);
    const MissionItem &known = (*m_items)[item.sequence];
    if (!(m_isRead ? isEqual(known, item) : isLike(known, item)))
        changedByOther(reasons::kPlanChanged);
}

void PlanCopy::handleChange(TimePoint now, std::uint32_t id, bool isToUs)
{
    if (isToUs && (m_isBusy || now < m_settled))
        return;
    if (id == 0 || id != m_id)
        changedByOther(reasons::kPlanChanged);
}

bool PlanCopy::matches(const std::vector<MissionItem> &read, const MissionItems &expected, bool skipsHome) const
{
    const bool isSent = m_items == expected && !m_isRead;
    const std::ptrdiff_t first = skipsHome && !read.empty() && !expected->empty() ? 1 : 0;
    return m_disturbed.empty()
        && std::equal(expected->begin() + first, expected->end(), read.begin() + first, read.end(), isSent ? isLike : isEqual);
}

void PlanCopy::changedByOther(Reason reason)
{
    m_isChangedByOther = true;
    m_outdated = reason;
    m_disturbed = std::move(reason);
}

} // namespace skyseal::vehicle
