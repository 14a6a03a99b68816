#include "core/engine/gateway/client_places.h"

#include "core/link/address_text.h"

#include <algorithm>

namespace skyseal::engine {

std::optional<Path> placeToFree(std::span<const ClientPlace> places, const Address &newcomer, TimePoint now)
{
    const auto placesOf = [&](const Address &host) {
        return static_cast<std::size_t>(
            std::ranges::count_if(places, [&](const ClientPlace &place) { return link::isSameHost(place.path.remote, host); }));
    };
    const auto mostSilent = [&](auto &&mayBeFreed) {
        const ClientPlace *found = nullptr;
        for (const ClientPlace &place : places) {
            if ((!found || place.heardAt < found->heardAt) && mayBeFreed(place))
                found = &place;
        }
        return found ? std::optional(found->path) : std::nullopt;
    };
    const auto isSilent = [&](const ClientPlace &place) { return now - place.heardAt >= kReplaceAfter; };

    if (placesOf(newcomer) >= kShareOfHost)
        return mostSilent(
            [&](const ClientPlace &place) { return isSilent(place) && link::isSameHost(place.path.remote, newcomer); });
    const auto ofGreedyHost = mostSilent([&](const ClientPlace &place) { return placesOf(place.path.remote) > kShareOfHost; });
    return ofGreedyHost ? ofGreedyHost : mostSilent(isSilent);
}

} // namespace skyseal::engine
