// Determines whether a frame of a session is the newest of its kind: a late record must not replace a newer displayed value
// (the order of the records is authenticated, that of MAVLink's sequence numbers is not).
#pragma once

#include "core/channel/delivery.h"
#include "core/mavlink/frame.h"

#include <array>
#include <cstdint>

namespace skyseal::engine {

class FrameOrder
{
public:
    /// Notes the frame of a record. Returns true if it may set present values: the record is fresh, and no newer one carried a
    /// message of this kind from this sender.
    bool note(const mavlink::Frame &frame, const channel::Delivery &delivery);

private:
    static constexpr std::size_t kSlots = 256;
    /// If two kinds share a slot, a late frame may be missing on the display, without other effects.
    static std::size_t slotOf(const mavlink::Frame &frame);

    std::array<channel::RecordPosition, kSlots> m_newest{};
};

} // namespace skyseal::engine
