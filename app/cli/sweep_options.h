// The command line of a sweep, read and checked.
#pragma once

#include "core/engine/station/station_config.h"
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
    std::optional<link::LinkUrl> link; ///< empty: simulator and agent of our own
    engine::StationConfig station;
    std::vector<experiment::Expectation> expectations;
    QString folder; ///< empty: no files
    bool json = false;
};

/// An exit status when there is nothing to do: help, or something is wrong.
std::optional<int> readSweepOptions(const QString &name, const QStringList &arguments, SweepOptions &out);

} // namespace skyseal::app
