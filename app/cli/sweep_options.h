// Parses and checks the command line of a sweep.
#pragma once

#include "core/engine/station/station_config.h"
#include "core/experiment/flight_plan.h"
#include "core/experiment/plan.h"
#include "core/experiment/verdicts.h"
#include "core/link/link_url.h"

#include <QtCore/QStringList>

#include <optional>
#include <vector>

namespace skyseal::app {

struct SweepOptions
{
    experiment::Plan plan;
    std::optional<link::LinkUrl> link; ///< empty: the sweep's own agent
    std::optional<link::LinkUrl>
        vehicle;                   ///< of that agent, to an autopilot that runs already; empty: the sweep's own simulator
    experiment::FlightPlan flight; ///< only with `vehicle`
    engine::StationConfig station;
    std::vector<experiment::Expectation> expectations;
    /// Words of a command line that repeats the sweep: the arguments, and as options what was drawn at random or depends on
    /// this machine, such as the suites of its libraries and the link for its number of cores.
    QStringList repeatedBy;
    QString folder;              ///< empty: no files
    std::optional<double> until; ///< half width of the interval that ends the sweep: 0.03
    bool forecast = false;       ///< say how long that would take
    bool json = false;
};

/// An exit status if there is nothing to do: help was printed, or the usage is wrong.
std::optional<int> readSweepOptions(const QString &name, const QStringList &arguments, SweepOptions &out);

} // namespace skyseal::app
