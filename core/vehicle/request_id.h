// Number of a request to a vehicle. The result of the request carries it, so that the requester can tell its own results from
// others.
#pragma once

#include <cstdint>

namespace skyseal::vehicle {

/// Unique per station; 0 belongs to no request.
enum class RequestId : std::uint32_t {};

} // namespace skyseal::vehicle
