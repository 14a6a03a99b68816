// Generated from resources/dialects.
#pragma once

#include "core/mavlink/message_info.h"

namespace skyseal::mavlink::builtin {

std::span<const MessageInfo> messages();
std::span<const EnumInfo> enums();

} // namespace skyseal::mavlink::builtin
