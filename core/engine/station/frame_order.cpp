#include "core/engine/station/frame_order.h"

namespace skyseal::engine {

bool FrameOrder::note(const mavlink::Frame &frame, const channel::Delivery &delivery)
{
    channel::RecordPosition &newest = m_newest[slotOf(frame)];
    const bool isNewest = delivery.position >= newest;
    if (isNewest)
        newest = delivery.position;
    return isNewest && delivery.freshness == channel::Freshness::Fresh;
}

std::size_t FrameOrder::slotOf(const mavlink::Frame &frame)
{
    const std::uint32_t sender = frame.systemId() * 131u + frame.componentId();
    return (frame.messageId() + sender * 31u) % kSlots;
}

} // namespace skyseal::engine
