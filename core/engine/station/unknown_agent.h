// An agent that announces itself and is not among the known peers.
#pragma once

#include <string>

namespace skyseal::engine {

/// An agent announces itself with a key that is not among the known peers. The announcement does not contain the key.
struct UnknownAgent
{
    std::string remoteAddress;
};

} // namespace skyseal::engine
