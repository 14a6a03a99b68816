// Where and with what a sweep was made: what experiment::machineSetting() knows, and what only the program knows.
#pragma once

#include "core/experiment/results.h"

#include <QtCore/QString>

namespace skyseal::app {

/// `command` is the command line that makes the same sweep.
experiment::Setting describeSetting(const char *version, const QString &command);

} // namespace skyseal::app
