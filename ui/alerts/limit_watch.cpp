#include "ui/alerts/limit_watch.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/values/value_reading.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

namespace {

/// The translation context of this file.
struct LimitWatchText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::LimitWatch)
};

constexpr double kInterval = 0.2; ///< seconds between two checks; snapshots come more often

} // namespace

void LimitWatch::setChoices(const ValueChoices &choices, UnitSystem units)
{
    m_units = units;
    if (choices == m_choices)
        return;
    m_choices = choices;
    startOver();
}

void LimitWatch::startOver()
{
    m_courses.clear();
    m_alerts.clear();
    m_checked = -1;
}

const std::vector<Alert> &LimitWatch::check(const ViewState &live, double now)
{
    if (m_checked >= 0 && now - m_checked < kInterval)
        return m_alerts;
    m_checked = now;
    std::vector<const engine::VehicleSnapshot *> watched;
    if (live.vehicle)
        watched.push_back(live.vehicle);
    for (const engine::VehicleSnapshot &vehicle : live.vehicles())
        if (watched.size() < kMostVehicles && &vehicle != live.vehicle)
            watched.push_back(&vehicle);
    std::erase_if(m_courses, [&watched](const auto &one) {
        return std::ranges::none_of(watched,
                                    [&one](const auto *vehicle) { return vehicle->state.systemId == one.first.first; });
    });
    for (const engine::VehicleSnapshot *vehicle : watched)
        checkVehicle({.snapshot = live.snapshot, .vehicle = vehicle}, now);
    m_alerts.clear();
    for (const auto &[place, course] : m_courses)
        if (course.reported != LimitSide::Within)
            m_alerts.push_back(alertFor(place, course));
    return m_alerts;
}

void LimitWatch::checkVehicle(const ViewState &view, double now)
{
    for (std::size_t i = 0; i < m_choices.size(); ++i) {
        const ValueChoice &choice = m_choices[i];
        if (!choice.low && !choice.high)
            continue;
        const ValueReading reading = readValue(choice.source, view);
        Course &course = m_courses[{view.vehicle->state.systemId, static_cast<std::uint16_t>(i)}];
        if (!std::isfinite(reading.number) || reading.isStale()) {
            course.since = now;
            continue;
        }
        course.number = reading.number;
        const LimitSide side = choice.sideOf(reading.number);
        if (side != course.seen) {
            course.seen = side;
            course.since = now;
        }
        if (side == course.reported || now - course.since < (side == LimitSide::Within ? kEnds : kBegins))
            continue;
        course.reported = side;
        if (side != LimitSide::Within)
            ++course.times;
    }
}

Alert LimitWatch::alertFor(const Place &place, const Course &course) const
{
    const ValueChoice &choice = m_choices[place.second];
    const ValueUnit unit = choice.shownUnit();
    const auto text = [&](double number) { return valueFigure(number, unit, choice.decimals, m_units).text(); };
    const bool isLow = course.reported == LimitSide::Low;
    const QString limit = text(isLow ? *choice.low : *choice.high);
    const QString what = isLow ? LimitWatchText::tr("The low limit is %1.").arg(limit)
                               : LimitWatchText::tr("The high limit is %1.").arg(limit);
    Alert alert{{AlertKind::ValueLimit, place.first, place.second},
                AlertSeverity::Warning,
                (isLow ? LimitWatchText::tr("%1 low: %2") : LimitWatchText::tr("%1 high: %2"))
                    .arg(choice.shownCaption(), text(course.number)),
                course.times == 1 ? what : LimitWatchText::tr("%1 Passed %2 times.").arg(what).arg(course.times)};
    alert.subject = static_cast<std::uint64_t>(course.reported);
    return alert;
}

} // namespace skyseal::ui
