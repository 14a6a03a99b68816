// The state of one link for windows and reports, as a value.
#pragma once

#include "core/base/path.h"
#include "core/base/reason.h"

#include <cstdint>
#include <string>

namespace skyseal::engine {

enum class LinkPhase : std::uint8_t { Closed, Opening, Listening, Connected, Waiting, Finished, Failed };

struct LinkSnapshot
{
    LinkId id{};
    std::string url;
    LinkPhase phase{};
    std::string localAddress;  ///< "0.0.0.0:14550"; always shown
    std::string remoteAddress; ///< of the newest datagram or connection
    Reason problem;            ///< of the system or the link; empty without one
    bool addressInUse = false; ///< the problem is a port that another program uses
    bool hostUnknown = false;  ///< the problem is a host name that cannot be resolved
    bool listenOnly = false;   ///< a stream of MAVSec's published code: insecure; nothing is sent to it
    bool recording = false;    ///< replays a file: nothing is sent, and frames were recorded in the past
    double rxBytesPerSecond = 0, txBytesPerSecond = 0;
    std::uint64_t rxBytes = 0, txBytes = 0, rxDatagrams = 0, txDatagrams = 0, dropped = 0;
    std::uint64_t badCrc = 0; ///< frames that failed their checksum
};

} // namespace skyseal::engine
