// One message as one line for people: names of enum entries, units, angles as the definitions have them.
#pragma once

#include "core/mavlink/field_value.h"
#include "core/mavlink/frame.h"

#include <string>

namespace skyseal::mavlink {

/// "1/1 HEARTBEAT type=MAV_TYPE_QUADROTOR … custom_mode=4": system and component, the name, the fields.
std::string messageText(const Frame &frame, const Dialect &dialect);

/// A field's value as people read it: the entry's name, the set bits' names joined by "|", or the number with its unit.
/// Arrays in brackets, text in quotes with unprintable bytes as \xNN.
std::string fieldText(const Frame &frame, const FieldInfo &field, const Dialect &dialect);

} // namespace skyseal::mavlink
