#include "core/engine/station/call_places.h"

namespace skyseal::engine {

bool CallPlaces::isRouter(LinkId link, const Place &place, TimePoint now) const
{
    return place.isMavlink(now) && !m_sessions.contains(link);
}

} // namespace skyseal::engine
