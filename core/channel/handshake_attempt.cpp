#include "core/channel/handshake_attempt.h"

#include <algorithm>

namespace skyseal::channel {

HandshakeAttempt::Place &HandshakeAttempt::placeAt(const Path &path)
{
    const auto found = std::find_if(places.begin(), places.end(), [&](const Place &place) { return place.path == path; });
    if (found != places.end())
        return *found;
    if (places.size() == kMaxPlaces) {
        const auto unproven = std::find_if(places.begin(), places.end(), [](const Place &place) { return !place.proven; });
        places.erase(unproven == places.end() ? places.begin() : unproven);
    }
    Place &place = places.emplace_back();
    place.path = path;
    return place;
}

void HandshakeAttempt::stopCallingAt(std::span<const Path> paths)
{
    std::erase_if(places, [paths](const Place &place) {
        return !place.answerDue && std::ranges::find(paths, place.path) != paths.end();
    });
}

} // namespace skyseal::channel
