// The command line that repeats a sweep: on any machine, and pasted into a shell.
#pragma once

#include "core/experiment/plan.h"

#include <QtCore/QStringList>

namespace skyseal::app {

/// The words, quoted for a POSIX shell where they need it, and separated by spaces.
QString shellText(const QStringList &words);

/// All options of such a plan for skyseal-cli sweep, none of them left to a default. Without the links of --link and --vehicle.
QStringList sweepArguments(const experiment::Plan &plan);

/// "clean" or the impairment, for each condition of the plan, as options.
QStringList linkArguments(const experiment::Plan &plan);
/// "--suites" and their names, in the order of the plan.
QStringList suiteArguments(const experiment::Plan &plan);

} // namespace skyseal::app
