// The state of a connection to a broker, for reports.
#pragma once

#include <cstdint>
#include <string>

namespace skyseal::mqtt {

struct PublishCount
{
    std::uint64_t sent = 0;    ///< messages: written to the connection, or for events confirmed by the broker
    std::uint64_t dropped = 0; ///< see PublishQueue::dropped(); also messages that a broken connection took along
};

struct PublisherStatus
{
    bool connected = false;
    std::string problem = {};      ///< why not; empty before the first attempt has ended
    std::uint64_t connections = 0; ///< that the broker accepted, since the start
    PublishCount state = {}, event = {}, raw = {};
};

} // namespace skyseal::mqtt
