#include "core/sim/mission_server.h"

#include "core/mavlink/messages.h"

namespace skyseal::sim {

using namespace mavlink;

MissionServer::MissionServer(Autopilot &autopilot, ParameterServer &parameters, FrameQueue &outbox)
    : m_autopilot(autopilot), m_outbox(outbox), m_plan(autopilot, parameters), m_fence(autopilot),
      m_rally(autopilot), m_transfers{ItemTransfer(m_plan, outbox, autopilot.texts(), autopilot.flight().type.firmware),
                                      ItemTransfer(m_fence, outbox, autopilot.texts(), autopilot.flight().type.firmware),
                                      ItemTransfer(m_rally, outbox, autopilot.texts(), autopilot.flight().type.firmware)}
{}

ItemTransfer *MissionServer::transfer(const FrameSender &peer, std::uint8_t type)
{
    if (type < m_transfers.size())
        return &m_transfers[type];
    acknowledge(peer, MAV_MISSION_UNSUPPORTED, type);
    return nullptr;
}

void MissionServer::handleCount(TimePoint now, const FrameSender &peer, std::uint16_t count, std::uint8_t type)
{
    if (ItemTransfer *list = transfer(peer, type))
        list->handleCount(now, peer, count);
}

void MissionServer::handleItem(TimePoint now, const FrameSender &peer, std::uint16_t sequence, const StoredItem &item,
                               std::uint8_t type)
{
    if (ItemTransfer *list = transfer(peer, type))
        list->handleItem(now, peer, sequence, item);
}

void MissionServer::handleRequestList(const FrameSender &peer, std::uint8_t type)
{
    if (ItemTransfer *list = transfer(peer, type))
        list->handleRequestList(peer);
}

void MissionServer::handleRequest(const FrameSender &peer, std::uint16_t sequence, std::uint8_t type, bool asInt)
{
    if (ItemTransfer *list = transfer(peer, type))
        list->handleRequest(peer, sequence, asInt);
}

void MissionServer::handleClear(const FrameSender &peer, std::uint8_t type)
{
    if (type == MAV_MISSION_TYPE_ALL) {
        std::uint8_t result = MAV_MISSION_ACCEPTED;
        for (ItemTransfer &list : m_transfers) {
            if (const std::uint8_t one = list.clear(peer); one != MAV_MISSION_ACCEPTED)
                result = one;
        }
        acknowledge(peer, result, type);
    } else if (ItemTransfer *list = transfer(peer, type)) {
        acknowledge(peer, list->clear(peer), type);
    }
}

void MissionServer::handleAck(const FrameSender &peer, std::uint8_t result, std::uint8_t type)
{
    if (type < m_transfers.size()) // an answer to an acknowledgement could go on for ever
        m_transfers[type].handleAck(peer, result);
}

void MissionServer::handleSetCurrent(std::uint16_t sequence)
{
    if (m_autopilot.modes().mission().setCurrent(sequence)) {
        MissionCurrent out;
        out.seq = sequence;
        m_outbox.send(out);
        m_reportedCurrent = sequence;
    }
}

void MissionServer::acknowledge(const FrameSender &peer, std::uint8_t result, std::uint8_t type)
{
    acknowledgeItems(m_outbox, peer, result, type);
}

void MissionServer::reportProgress()
{
    MissionRunner &mission = m_autopilot.modes().mission();
    if (const auto reached = mission.takeReached()) {
        MissionItemReached out;
        out.seq = *reached;
        m_outbox.send(out);
        m_autopilot.texts().say(Severity::Info, "Reached command #" + std::to_string(*reached));
    }
    if (mission.current() != m_reportedCurrent) {
        m_reportedCurrent = mission.current();
        MissionCurrent out;
        out.seq = m_reportedCurrent;
        m_outbox.send(out);
    }
}

void MissionServer::handleDeadline(TimePoint now)
{
    for (ItemTransfer &list : m_transfers)
        list.handleDeadline(now);
}

TimePoint MissionServer::nextDeadline() const
{
    TimePoint next = kNever;
    for (const ItemTransfer &list : m_transfers)
        next = std::min(next, list.nextDeadline());
    return next;
}

MissionServer::StoredLists MissionServer::stored() const
{
    StoredLists lists;
    for (std::size_t i = 0; i < kLists; ++i)
        lists[i] = m_transfers[i].list().stored();
    return lists;
}

void MissionServer::restore(StoredLists lists)
{
    for (std::size_t i = 0; i < kLists; ++i)
        m_transfers[i].list().replace(std::move(lists[i]));
}

} // namespace skyseal::sim
