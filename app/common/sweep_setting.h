// The setting of a sweep: experiment::machineSetting() plus the properties of the program.
#pragma once

#include "core/experiment/results.h"
#include "core/link/link_url.h"

#include <QtCore/QString>

#include <optional>

namespace skyseal::app {

/// `command`: the command line that repeats the sweep.
experiment::Setting describeSetting(const char *version, const QString &command);

/// The entry "message_mix", which must be the same of two sweeps that are compared. `link`: that of a vehicle with its agent;
/// `autopilot`: that of an autopilot beside the sweep's own agent, which flies `flight` unless that is empty; neither of them:
/// the sweep's own simulator.
std::string messageMix(const std::optional<link::LinkUrl> &link, const std::optional<link::LinkUrl> &autopilot,
                       const std::string &flight);

} // namespace skyseal::app
