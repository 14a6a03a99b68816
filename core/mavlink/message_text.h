// One message as one line of text: names of enum entries, units, angles as in the definitions.
#pragma once

#include "core/mavlink/field_value.h"
#include "core/mavlink/frame.h"

#include <string>

namespace skyseal::mavlink {

/// "1/1 HEARTBEAT type=MAV_TYPE_QUADROTOR … custom_mode=4": system and component, the name, the fields.
std::string messageText(const Frame &frame, const Dialect &dialect);

/// Readable value of a field: the entry's name, the set bits' names joined by "|", or the number with its unit.
/// Arrays in brackets, text in quotes with unprintable bytes as \xNN.
std::string fieldText(const Frame &frame, const FieldInfo &field, const Dialect &dialect);

} // namespace skyseal::mavlink
