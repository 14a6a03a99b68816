// Remarks with a severity, which the journal takes from a prefix of the line (sd-daemon(3)). Main thread.
#pragma once

#include "core/mavlink/enums.h"

#include <string>

namespace skyseal::app {

/// Prints a line on stderr, where that is the journal with its severity. `severity`: MAV_SEVERITY, whose numbers are those of
/// syslog.
void remark(const std::string &line, unsigned severity);

} // namespace skyseal::app
