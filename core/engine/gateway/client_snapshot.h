// The state of one client of the gateway for windows and reports, as a value.
#pragma once

#include <cstdint>
#include <string>

namespace skyseal::engine {

struct ClientCounters
{
    std::uint64_t forwarded = 0;    ///< frames of the client that were forwarded to vehicles
    std::uint64_t denied = 0;       ///< frames that the client may not send
    std::uint64_t tooOften = 0;     ///< questions (read-only requests) beyond the limit
    std::uint64_t notItsSystem = 0; ///< frames with a system id that the client may not use
};

struct ClientSnapshot
{
    std::string name;    ///< of the link on which it is served
    std::string address; ///< "127.0.0.1:50123"
    std::string write;   ///< "none", "all" or classes of messages
    ClientCounters counters;
};

} // namespace skyseal::engine
