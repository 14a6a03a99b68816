// Recognises MAVLink frames that were sealed in place (core/channel/PROTOCOL.md, section 12). It is here because it needs
// both the channel and MAVLink. No state.
#pragma once

#include "core/channel/inline_frame.h"
#include "core/mavlink/frame_scanner.h"

namespace skyseal::engine {

/// True for a whole frame with the flags of one sealed in place; only the channel can read it.
inline bool isSealedInPlace(const mavlink::ScanItem &item)
{
    const bool whole = item.fault == mavlink::FrameFault::UnknownIncompatFlags
        || item.fault == mavlink::FrameFault::UnknownMessage;
    return !item.frame && whole && channel::looksInline(item.bytes);
}

} // namespace skyseal::engine
