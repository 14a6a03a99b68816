// Where and with what something was measured, as a publication has to state it.
#pragma once

#include "core/experiment/results.h"

namespace skyseal::experiment {

/// Machine, processor and its features, system, load, libraries, compiler and build of this program. The caller adds what
/// only it knows: version, command line, time, seed.
Setting machineSetting();

} // namespace skyseal::experiment
