#include "core/sim/item_transfer.h"

#include "core/mavlink/messages.h"

namespace skyseal::sim {

using namespace mavlink;

namespace {

constexpr Duration kAskAgain = std::chrono::milliseconds(500);
constexpr int kMostAsked = 16; // eight seconds, as ArduPilot waits

} // namespace

void ItemTransfer::handleCount(TimePoint now, const FrameSender &peer, std::uint16_t count)
{
    if (m_receiving && !m_sender.sameSender(peer))
        return acknowledge(peer, MAV_MISSION_DENIED);
    if (count > m_list.most()) {
        m_texts.say(Severity::Warning, "Only " + std::to_string(m_list.most()) + " items are supported");
        return acknowledge(peer, MAV_MISSION_NO_SPACE);
    }
    if (count == 0)
        return acknowledge(peer, clear(peer));
    m_receiving = true;
    m_sender = peer;
    m_expected = count;
    m_incoming.clear();
    m_incoming.reserve(count);
    m_finishedCount = 0;
    m_asked = 0;
    askFor(now);
}

void ItemTransfer::askFor(TimePoint now)
{
    m_askAgain = now + kAskAgain;
    ++m_asked;
    const auto sequence = static_cast<std::uint16_t>(m_incoming.size());
    const auto ask = [&](auto out) {
        out.target_system = m_sender.system;
        out.target_component = m_sender.component;
        out.seq = sequence;
        out.mission_type = m_list.type();
        m_outbox.send(out);
    };
    if (m_sender.version == 1)
        ask(MissionRequest{});
    else
        ask(MissionRequestInt{});
}

void ItemTransfer::handleItem(TimePoint now, const FrameSender &peer, std::uint16_t sequence, const StoredItem &item)
{
    if (!m_receiving)
        return handleLateItem(peer, sequence);
    if (!m_sender.sameSender(peer))
        return acknowledge(peer, MAV_MISSION_DENIED);
    if (sequence != m_incoming.size()) {
        if (m_firmware == Firmware::Px4)
            return askFor(now);
        return acknowledge(peer, MAV_MISSION_INVALID_SEQUENCE); // the expected item is requested again later
    }
    if (const auto error = m_list.check(sequence, item))
        return finish(static_cast<std::uint8_t>(*error));
    m_incoming.push_back(item);
    m_asked = 0;
    if (m_incoming.size() < m_expected)
        return askFor(now);
    if (!m_list.replace(std::move(m_incoming)))
        return finish(MAV_MISSION_ERROR);
    if (const char *text = m_list.receivedText())
        m_texts.say(Severity::Info, text);
    m_finishedBy = peer;
    m_finishedCount = m_expected;
    finish(MAV_MISSION_ACCEPTED);
}

void ItemTransfer::handleLateItem(const FrameSender &peer, std::uint16_t sequence)
{
    // The last item again: our answer was lost.
    if (m_finishedCount != 0 && m_finishedBy.sameSender(peer) && sequence + 1 == m_finishedCount)
        acknowledge(peer, MAV_MISSION_ACCEPTED);
    else if (m_firmware == Firmware::ArduPilot)
        acknowledge(peer, MAV_MISSION_ERROR);
}

void ItemTransfer::finish(std::uint8_t result)
{
    m_receiving = false;
    m_incoming = {};
    acknowledge(m_sender, result);
}

void ItemTransfer::handleRequestList(const FrameSender &peer)
{
    if (m_receiving)
        return acknowledge(peer, MAV_MISSION_DENIED);
    m_sent = 0;
    MissionCount out;
    out.target_system = peer.system;
    out.target_component = peer.component;
    out.mission_type = m_list.type();
    out.count = static_cast<std::uint16_t>(m_list.size());
    m_outbox.send(out);
}

void ItemTransfer::handleRequest(const FrameSender &peer, std::uint16_t sequence, bool asInt)
{
    if (m_receiving)
        return acknowledge(peer, MAV_MISSION_DENIED);
    if (sequence >= m_list.size())
        return acknowledge(peer, MAV_MISSION_INVALID_SEQUENCE);
    // PX4 sends the items in their order only; the last one again, if it was lost (mavlink_mission.cpp).
    if (m_firmware == Firmware::Px4 && sequence != m_sent && sequence + 1 != m_sent)
        return acknowledge(peer, MAV_MISSION_ERROR);
    m_sent = static_cast<std::uint16_t>(sequence + 1);
    const StoredItem item = m_list.item(sequence);
    const auto fill = [&](auto &out) {
        out.target_system = peer.system;
        out.target_component = peer.component;
        out.seq = sequence;
        out.frame = item.frame;
        out.command = item.command;
        out.current = m_list.current() == sequence;
        out.autocontinue = item.autocontinue;
        out.param1 = item.parameters[0];
        out.param2 = item.parameters[1];
        out.param3 = item.parameters[2];
        out.param4 = item.parameters[3];
        out.z = item.z;
        out.mission_type = m_list.type();
    };
    if (asInt) {
        MissionItemInt out;
        fill(out);
        out.x = item.x;
        out.y = item.y;
        m_outbox.send(out);
        return;
    }
    mavlink::MissionItem out;
    fill(out);
    const double scale = integerScale(item.command);
    out.x = static_cast<float>(item.x / scale);
    out.y = static_cast<float>(item.y / scale);
    m_outbox.send(out);
}

std::uint8_t ItemTransfer::clear(const FrameSender &peer)
{
    if (m_receiving && !m_sender.sameSender(peer))
        return MAV_MISSION_DENIED;
    if (m_list.inUse())
        return MAV_MISSION_DENIED;
    m_receiving = false;
    m_incoming = {};
    m_finishedCount = 0;
    return m_list.replace({}) ? MAV_MISSION_ACCEPTED : MAV_MISSION_ERROR;
}

void ItemTransfer::handleAck(const FrameSender &peer, std::uint8_t result)
{
    if (m_receiving && m_sender.sameSender(peer) && result != MAV_MISSION_ACCEPTED)
        m_receiving = false;
}

void ItemTransfer::handleDeadline(TimePoint now)
{
    if (!m_receiving || now < m_askAgain)
        return;
    if (m_asked < kMostAsked)
        return askFor(now);
    m_texts.say(Severity::Warning, std::string(m_list.name()) + " upload timeout");
    finish(MAV_MISSION_OPERATION_CANCELLED);
}

void ItemTransfer::acknowledge(const FrameSender &peer, std::uint8_t result)
{
    acknowledgeItems(m_outbox, peer, result, m_list.type());
}

void acknowledgeItems(FrameQueue &outbox, const FrameSender &peer, std::uint8_t result, std::uint8_t type)
{
    MissionAck out;
    out.target_system = peer.system;
    out.target_component = peer.component;
    out.type = result;
    out.mission_type = type;
    outbox.send(out);
}

} // namespace skyseal::sim
