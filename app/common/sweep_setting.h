// The setting of a sweep: experiment::machineSetting() plus the properties of the program.
#pragma once

#include "core/experiment/results.h"

#include <QtCore/QString>

namespace skyseal::app {

/// `command`: the command line that repeats the sweep.
experiment::Setting describeSetting(const char *version, const QString &command);

} // namespace skyseal::app
