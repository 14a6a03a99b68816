// skyseal-air --signing: sets up, checks or removes MAVLink signing of the vehicle, over the vehicle's link, while no agent
// uses that.
#pragma once

#include "app/common/options.h"

namespace skyseal::app {

void declareSigning(Options &options);
/// Reads the options, runs until the outcome is known, and reports it. Returns the exit status.
int runSigning(Options &options);

} // namespace skyseal::app
