#include "core/sim/mission_server.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/enums.h"
#include "core/sim/wire_units.h"

namespace skyseal::sim {

using namespace mavlink;

namespace {

constexpr Duration kAskAgain = std::chrono::milliseconds(500);
constexpr int kMostAsked = 16; // eight seconds, as ArduPilot waits

bool isMission(std::uint8_t type)
{
    return type == MAV_MISSION_TYPE_MISSION || type == MAV_MISSION_TYPE_ALL;
}

} // namespace

void MissionServer::handleCount(TimePoint now, const FrameSender &peer, std::uint16_t count, std::uint8_t type)
{
    if (type != MAV_MISSION_TYPE_MISSION)
        return acknowledge(peer, MAV_MISSION_UNSUPPORTED, type);
    if (m_receiving && !m_sender.sameSender(peer))
        return acknowledge(peer, MAV_MISSION_DENIED);
    if (count > kMostMissionItems)
        return acknowledge(peer, MAV_MISSION_NO_SPACE);
    if (count == 0)
        return handleClear(peer, type);
    m_receiving = true;
    m_sender = peer;
    m_expected = count;
    m_incoming.clear();
    m_incoming.reserve(count);
    m_finishedCount = 0;
    m_asked = 0;
    askFor(now);
}

void MissionServer::askFor(TimePoint now)
{
    m_askAgain = now + kAskAgain;
    ++m_asked;
    const auto sequence = static_cast<std::uint16_t>(m_incoming.size());
    const auto fill = [&](auto &out) {
        out.target_system = m_sender.system;
        out.target_component = m_sender.component;
        out.seq = sequence;
        m_outbox.send(out);
    };
    if (m_sender.version == 1) {
        MissionRequest out;
        fill(out);
    } else {
        MissionRequestInt out;
        fill(out);
    }
}

void MissionServer::handleItem(TimePoint now, const FrameSender &peer, std::uint16_t sequence, const StoredItem &item,
                               std::uint8_t type)
{
    if (type != MAV_MISSION_TYPE_MISSION)
        return acknowledge(peer, MAV_MISSION_UNSUPPORTED, type);
    if (!m_receiving) {
        // The last item again: our answer was lost.
        if (m_finishedCount != 0 && m_finishedBy.sameSender(peer) && sequence + 1 == m_finishedCount)
            return acknowledge(peer, MAV_MISSION_ACCEPTED);
        return acknowledge(peer, MAV_MISSION_ERROR);
    }
    if (!m_sender.sameSender(peer))
        return acknowledge(peer, MAV_MISSION_DENIED);
    if (sequence < m_incoming.size())
        return; // a copy of one that we have
    if (sequence > m_incoming.size())
        return acknowledge(peer, MAV_MISSION_INVALID_SEQUENCE); // the expected item is requested again later
    if (sequence > 0) {                                         // item 0 is always home
        if (const auto error = checkItem(item))
            return finish(static_cast<std::uint8_t>(*error));
    }
    m_incoming.push_back(item);
    m_asked = 0;
    if (m_incoming.size() < m_expected)
        return askFor(now);
    m_finishedBy = peer;
    m_finishedCount = m_expected;
    m_autopilot.modes().mission().load(std::move(m_incoming));
    m_autopilot.parameters().set("MIS_TOTAL", static_cast<float>(m_expected));
    m_autopilot.texts().say(Severity::Info, "Flight plan received");
    finish(MAV_MISSION_ACCEPTED);
}

void MissionServer::finish(std::uint8_t result)
{
    m_receiving = false;
    m_incoming = {};
    acknowledge(m_sender, result);
}

void MissionServer::handleRequestList(const FrameSender &peer, std::uint8_t type)
{
    MissionCount out;
    out.target_system = peer.system;
    out.target_component = peer.component;
    out.mission_type = type;
    if (isMission(type))
        out.count = static_cast<std::uint16_t>(m_autopilot.modes().mission().mission().size());
    m_outbox.send(out);
}

void MissionServer::handleRequest(const FrameSender &peer, std::uint16_t sequence, std::uint8_t type, bool asInt)
{
    if (!isMission(type))
        return acknowledge(peer, MAV_MISSION_UNSUPPORTED, type);
    const Mission &mission = m_autopilot.modes().mission().mission();
    if (sequence >= mission.size())
        return acknowledge(peer, MAV_MISSION_INVALID_SEQUENCE, type);
    mavlink::MissionItemInt whole;
    const StoredItem &item = mission[sequence];
    whole.frame = item.frame;
    whole.command = item.command;
    whole.x = item.x;
    whole.y = item.y;
    whole.z = item.z;
    if (sequence == 0 && m_autopilot.home()) { // item 0 is always home
        const GeoPoint home = m_autopilot.world().toGeo(*m_autopilot.home());
        whole.frame = MAV_FRAME_GLOBAL;
        whole.command = MAV_CMD_NAV_WAYPOINT;
        whole.x = scaled<std::int32_t>(home.latitude, 1e7);
        whole.y = scaled<std::int32_t>(home.longitude, 1e7);
        whole.z = static_cast<float>(home.altitude);
    }
    const auto fill = [&](auto &out) {
        out.target_system = peer.system;
        out.target_component = peer.component;
        out.seq = sequence;
        out.frame = whole.frame;
        out.command = whole.command;
        out.current = sequence == m_autopilot.modes().mission().current();
        out.autocontinue = item.autocontinue;
        out.param1 = item.parameters[0];
        out.param2 = item.parameters[1];
        out.param3 = item.parameters[2];
        out.param4 = item.parameters[3];
        out.z = whole.z;
        out.mission_type = MAV_MISSION_TYPE_MISSION;
    };
    if (asInt) {
        fill(whole);
        m_outbox.send(whole);
        return;
    }
    mavlink::MissionItem out;
    fill(out);
    const bool place = whole.command < mavlink::MAV_CMD_NAV_LAST;
    out.x = static_cast<float>(place ? whole.x * 1e-7 : whole.x);
    out.y = static_cast<float>(place ? whole.y * 1e-7 : whole.y);
    m_outbox.send(out);
}

void MissionServer::handleClear(const FrameSender &peer, std::uint8_t type)
{
    if (!isMission(type))
        return acknowledge(peer, MAV_MISSION_ACCEPTED, type); // there never is a fence or rally point to keep
    if (m_receiving && !m_sender.sameSender(peer))
        return acknowledge(peer, MAV_MISSION_DENIED, type);
    if (m_autopilot.armed() && m_autopilot.modes().current() == FlightMode::Auto)
        return acknowledge(peer, MAV_MISSION_DENIED, type); // it is being flown
    m_receiving = false;
    m_finishedCount = 0;
    m_autopilot.modes().mission().load({});
    m_autopilot.parameters().set("MIS_TOTAL", 0);
    acknowledge(peer, MAV_MISSION_ACCEPTED, type);
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

void MissionServer::handleAck(const FrameSender &peer, std::uint8_t result)
{
    if (m_receiving && m_sender.sameSender(peer) && result != MAV_MISSION_ACCEPTED)
        m_receiving = false;
}

void MissionServer::acknowledge(const FrameSender &peer, std::uint8_t result, std::uint8_t type)
{
    MissionAck out;
    out.target_system = peer.system;
    out.target_component = peer.component;
    out.type = result;
    out.mission_type = type;
    m_outbox.send(out);
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
    if (!m_receiving || now < m_askAgain)
        return;
    if (m_asked < kMostAsked)
        return askFor(now);
    m_autopilot.texts().say(Severity::Warning, "Mission upload timeout");
    finish(MAV_MISSION_OPERATION_CANCELLED);
}

} // namespace skyseal::sim
