// Transfer of one list of items by MAVLink's mission protocol (https://mavlink.io/en/services/mission.html), the vehicle's
// side: upload, download and clear, with the repetitions that a lossy link needs. Lists of different types transfer
// independently.
#pragma once

#include "core/base/clock.h"
#include "core/sim/frame_queue.h"
#include "core/sim/frame_sender.h"
#include "core/sim/item_list.h"

namespace skyseal::sim {

class ItemTransfer
{
public:
    ItemTransfer(ItemList &list, FrameQueue &outbox, StatusTexts &texts, Firmware firmware)
        : m_list(list), m_outbox(outbox), m_texts(texts), m_firmware(firmware)
    {}

    const ItemList &list() const { return m_list; }
    ItemList &list() { return m_list; }

    void handleCount(TimePoint now, const FrameSender &peer, std::uint16_t count);
    /// MISSION_ITEM and MISSION_ITEM_INT of an upload.
    void handleItem(TimePoint now, const FrameSender &peer, std::uint16_t sequence, const StoredItem &item);
    void handleRequestList(const FrameSender &peer);
    /// MISSION_REQUEST, answered in floats, and MISSION_REQUEST_INT.
    void handleRequest(const FrameSender &peer, std::uint16_t sequence, bool asInt);
    /// Empties the list and ends an upload of the same peer. Returns a MAV_MISSION_RESULT, for the acknowledgement.
    std::uint8_t clear(const FrameSender &peer);
    /// MISSION_ACK of the station: it gave up an upload.
    void handleAck(const FrameSender &peer, std::uint8_t result);

    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const { return m_receiving ? m_askAgain : kNever; }

private:
    void askFor(TimePoint now);
    void handleLateItem(const FrameSender &peer, std::uint16_t sequence);
    void finish(std::uint8_t result);
    void acknowledge(const FrameSender &peer, std::uint8_t result);

    ItemList &m_list;
    FrameQueue &m_outbox;
    StatusTexts &m_texts;
    const Firmware m_firmware;

    bool m_receiving = false;
    FrameSender m_sender;
    std::uint16_t m_expected = 0; ///< items that are to come in all
    std::vector<StoredItem> m_incoming;
    TimePoint m_askAgain = kNever;
    int m_asked = 0;          ///< times that the present item was asked for
    FrameSender m_finishedBy; ///< whose last upload was accepted, with how many items: its last item may come twice
    std::uint16_t m_finishedCount = 0;
    std::uint16_t m_sent = 0; ///< PX4: items of the download so far
};

/// MISSION_ACK of a MAV_MISSION_RESULT.
void acknowledgeItems(FrameQueue &outbox, const FrameSender &peer, std::uint8_t result, std::uint8_t type);

} // namespace skyseal::sim
