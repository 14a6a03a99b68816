// The number by which the owner of an endpoint names a session.
#pragma once

#include <cstdint>

namespace skyseal::channel {

/// One session of an endpoint. Not reused in the lifetime of the endpoint, and not changed by a new address, suite or epoch.
enum class SessionId : std::uint32_t {};

} // namespace skyseal::channel
