// One word for each state, reason and result, for scripts; they are part of the programs' interface and never change.
#pragma once

#include "core/engine/station/event.h"

#include <string_view>

namespace skyseal::engine {

std::string_view word(LinkPhase phase);
std::string_view word(Security security);
std::string_view word(channel::DownReason reason);
std::string_view word(channel::SwitchFailure failure);
std::string_view word(channel::RefusalReason reason);
std::string_view word(channel::PeerRole role);

} // namespace skyseal::engine
