// Watches the limits of the values that the operator has chosen for the grid, and makes alerts of values beyond them. No
// widgets and no clock; times are seconds on any steady clock.
#pragma once

#include "ui/alerts/alert.h"
#include "ui/value_choice.h"
#include "ui/view_state.h"

#include <map>
#include <vector>

namespace skyseal::ui {

/// A value has to be beyond its limit for a second, and then within it for three, so that one that swings around the limit
/// makes one alert. Neither time runs while the value is old or unknown.
class LimitWatch
{
public:
    static constexpr double kBegins = 1, kEnds = 3; ///< seconds
    /// Vehicles that are watched, the selected one first: anybody may invent others on a plain link.
    static constexpr std::size_t kMostVehicles = 16;

    /// Begins anew if the values are others.
    void setChoices(const ValueChoices &choices, UnitSystem units);
    /// Takes the view of the station. Returns all alerts that last, one for each vehicle and value.
    const std::vector<Alert> &check(const ViewState &live, double now);
    /// Forgets all vehicles.
    void startOver();

private:
    /// A value of one vehicle over time.
    struct Course
    {
        LimitSide reported{}, seen{};
        double since = 0; ///< in which it is seen on this side
        double number = 0;
        int times = 0; ///< that it has been reported
    };
    using Place = std::pair<std::uint8_t, std::uint16_t>; ///< system id, and number of the value

    void checkVehicle(const ViewState &view, double now);
    Alert alertFor(const Place &place, const Course &course) const;

    ValueChoices m_choices;
    UnitSystem m_units = UnitSystem::Metric;
    std::map<Place, Course> m_courses;
    std::vector<Alert> m_alerts;
    double m_checked = -1; ///< time of the last check
};

} // namespace skyseal::ui
