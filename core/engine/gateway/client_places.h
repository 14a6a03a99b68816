// Decides which UDP client gives its place to a new one when all places of a link are taken. No I/O and no clock.
//
// UDP source ports cost nothing, so that one host could take all places and keep them with a datagram now and then. A host that
// holds more than its share gives up the place that was silent the longest, at once; a host that holds its share frees places
// of its own only. Otherwise a place is freed after some silence: programs send a heartbeat each second.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"

#include <optional>
#include <span>

namespace skyseal::engine {

struct ClientPlace
{
    Path path;
    TimePoint heardAt;
};

/// Applies only when all places are taken.
inline constexpr std::size_t kShareOfHost = 8;
inline constexpr Duration kReplaceAfter = std::chrono::seconds(5);

/// The place that a client at `newcomer` gets; nullopt if none may be freed.
std::optional<Path> placeToFree(std::span<const ClientPlace> places, const Address &newcomer, TimePoint now);

} // namespace skyseal::engine
