// Decides which UDP client gives its place to a new one when all places of a link are taken. No I/O and no clock.
//
// UDP source ports cost nothing, so that one host could take all places and keep them with an occasional datagram. A host with
// more than its share loses the place that has been silent longest, at once; a new client of a host with a full share can only
// replace a client of that host. Otherwise a place is freed after some silence: programs send a heartbeat each second.
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

/// These apply only when all places are taken.
inline constexpr std::size_t kShareOfHost = 8;
inline constexpr Duration kReplaceAfter = std::chrono::seconds(5);

/// The place that a client at `newcomer` gets; nullopt if none may be freed.
std::optional<Path> placeToFree(std::span<const ClientPlace> places, const Address &newcomer, TimePoint now);

} // namespace skyseal::engine
