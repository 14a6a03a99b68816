// Runs a station on the command line from its start to its end: report on stdout, list of peers, signals.
#pragma once

#include "app/cli/mqtt_options.h"
#include "core/engine/headless/headless_run.h"

#include <QtCore/QString>

#include <memory>
#include <optional>
#include <vector>

namespace skyseal::app {

struct StationRun
{
    QString program; ///< begins the messages on stderr
    engine::StationConfig config = {};
    engine::RunPlan plan = {};
    std::vector<link::LinkUrl> links = {};
    bool json = false;
    QString control = {};     ///< path of the control socket; none if empty
    std::string metrics = {}; ///< HOST:PORT of the metrics; none if empty
    std::optional<BrokerPlan> broker = {};
    std::unique_ptr<engine::RunListener> report = {}; ///< in place of the monitor's
};

/// Returns the exit status.
int runStation(StationRun run);

} // namespace skyseal::app
