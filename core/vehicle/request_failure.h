// The end of a request that could not be sent to a vehicle.
#pragma once

#include "core/base/reason.h"
#include "core/vehicle/event.h"
#include "core/vehicle/request.h"

namespace skyseal::vehicle {

/// The result event with which this request fails.
Event failureOf(RequestId id, std::uint8_t systemId, const Request &request, Reason reason);

} // namespace skyseal::vehicle
