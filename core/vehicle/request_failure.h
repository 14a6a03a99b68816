// The end of a request that could not be sent to a vehicle.
#pragma once

#include "core/vehicle/event.h"
#include "core/vehicle/request.h"

#include <string>

namespace skyseal::vehicle {

/// The result event with which this request fails. `reason` is a text for people.
Event failureOf(RequestId id, std::uint8_t systemId, const Request &request, std::string reason);

} // namespace skyseal::vehicle
