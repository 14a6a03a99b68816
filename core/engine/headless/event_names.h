// The keyword of each state and reason for scripts; part of the programs' interface.
#pragma once

#include "core/channel/events.h"
#include "core/engine/common/link_snapshot.h"

#include <string_view>

namespace skyseal::engine {

std::string_view keyword(LinkPhase phase);
std::string_view keyword(Carrier carrier);
std::string_view keyword(channel::Framing framing);
std::string_view keyword(channel::DownReason reason);
std::string_view keyword(channel::SwitchFailure failure);
std::string_view keyword(channel::RefusalReason reason);

} // namespace skyseal::engine
