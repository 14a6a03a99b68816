#include "core/vehicle/mission_place.h"

#include "core/mavlink/builtin_tables.h"

#include <algorithm>

namespace skyseal::vehicle {

bool commandHasPlace(std::uint16_t command)
{
    return !std::ranges::binary_search(mavlink::builtin::commandsWithoutPlace(), command);
}

} // namespace skyseal::vehicle
