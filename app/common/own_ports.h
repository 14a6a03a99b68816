// Links of one program that could never work together: two that listen on one port, or one that sends to a port of another.
#pragma once

#include "app/common/options.h"

#include <string>
#include <vector>

namespace skyseal::app {

struct OptionLink
{
    const char *option; ///< "ground"
    link::LinkUrl url;
};

/// Reports them as an error of usage. `program`: "the agent".
void refuseOwnPorts(Options &options, const std::string &program, const std::vector<OptionLink> &links);

} // namespace skyseal::app
