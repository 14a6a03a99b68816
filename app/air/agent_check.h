// skyseal-air --check: says in words what is wrong with a set-up, without starting the agent.
#pragma once

#include "app/air/agent_options.h"

namespace skyseal::app {

/// Prints a sentence for each problem. Returns the exit status: kDone if there is none, otherwise kNotReached.
int checkSetup(const AgentSetup &setup);

} // namespace skyseal::app
