// Example of a micro-protocol, for recipes_test: request and result of a PING. https://mavlink.io/en/services/ping.html
#pragma once

#include "core/base/reason.h"
#include "core/vehicle/request_id.h"

#include <cstdint>

namespace skyseal::vehicle {

struct Ping
{};

struct PingResult
{
    RequestId id{};
    std::uint8_t systemId = 0;
    bool ok = false;
    double trip = 0; ///< seconds
    Reason reason = {};
};

} // namespace skyseal::vehicle
