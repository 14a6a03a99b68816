// Generated from resources/dialects.
#pragma once

#include "core/mavlink/message_info.h"

namespace skyseal::mavlink::builtin {

std::span<const MessageInfo> messages();
std::span<const EnumInfo> enums();
/// MAV_CMD whose parameters 5 and 6 are no place, by rising number.
std::span<const std::uint16_t> commandsWithoutPlace();

} // namespace skyseal::mavlink::builtin
