// Texts for the components of a vehicle's system, and for other systems behind an agent.
#pragma once

#include "core/engine/station/other_systems_heard.h"
#include "core/vehicle/vehicle_state.h"

#include <QtCore/QString>

namespace skyseal::engine {

/// "camera 100", "companion computer 191", …: what the component is, by its HEARTBEAT or else by its id, and its id.
QString componentText(const vehicle::Component &component);
/// "Other systems behind air-1: 51, 255".
QString otherSystemsText(const OtherSystemsHeard &heard);
/// "51, 255".
QString systemsText(const std::vector<std::uint8_t> &systems);

} // namespace skyseal::engine
