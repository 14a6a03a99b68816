#include "core/vehicle/mission_client.h"

#include "core/vehicle/result_text.h"

#include <cmath>
#include <type_traits>

namespace skyseal::vehicle {

namespace {

MissionItem toItem(const mavlink::MissionItemInt &m)
{
    return {m.seq,      m.command,  m.frame, m.current != 0, m.autocontinue != 0, {m.param1, m.param2, m.param3, m.param4},
            m.x * 1e-7, m.y * 1e-7, m.z};
}

MissionItem toItem(const mavlink::MissionItem &m)
{
    return {m.seq,
            m.command,
            m.frame,
            m.current != 0,
            m.autocontinue != 0,
            {m.param1, m.param2, m.param3, m.param4},
            static_cast<double>(m.x),
            static_cast<double>(m.y),
            m.z};
}

} // namespace

bool MissionClient::perform(TimePoint now, RequestId id, const Request &request)
{
    if (const auto *write = std::get_if<WriteMission>(&request)) {
        if (begin(id, MissionTransfer::Upload))
            upload(now, write->items);
    } else if (std::holds_alternative<ReadMission>(request)) {
        if (begin(id, MissionTransfer::Download))
            download(now);
    } else if (std::holds_alternative<ClearMission>(request)) {
        if (begin(id, MissionTransfer::Clear))
            clear(now);
    } else {
        return false;
    }
    return true;
}

bool MissionClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    // Messages for other stations and other mission types (fence, rally points) are consumed without effect.
    const auto take = [&]<typename Message>(std::type_identity<Message>, auto handle) {
        const auto m = unpack<Message>(frame);
        if (addressing().isForUs(m.target_system, m.target_component) && m.mission_type == mavlink::MAV_MISSION_TYPE_MISSION)
            handle(m);
        return true;
    };
    using std::type_identity;
    switch (frame.messageId()) {
    case mavlink::MissionCount::kId:
        return take(type_identity<mavlink::MissionCount>(), [&](const auto &m) { handleCount(now, m.count); });
    case mavlink::MissionRequest::kId:
        return take(type_identity<mavlink::MissionRequest>(), [&](const auto &m) { handleItemRequest(now, m.seq, false); });
    case mavlink::MissionRequestInt::kId:
        return take(type_identity<mavlink::MissionRequestInt>(), [&](const auto &m) { handleItemRequest(now, m.seq, true); });
    case mavlink::MissionItem::kId:
        return take(type_identity<mavlink::MissionItem>(), [&](const auto &m) { handleItem(now, toItem(m)); });
    case mavlink::MissionItemInt::kId:
        return take(type_identity<mavlink::MissionItemInt>(), [&](const auto &m) { handleItem(now, toItem(m)); });
    case mavlink::MissionAck::kId:
        return take(type_identity<mavlink::MissionAck>(), [&](const auto &m) { handleAck(now, m.type); });
    default: return false;
    }
}

void MissionClient::upload(TimePoint now, std::vector<MissionItem> items)
{
    if (items.size() > kMaxItems)
        return finish(false, "a mission has at most " + std::to_string(kMaxItems) + " items");
    m_items = std::move(items);
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        if (!(std::abs(m_items[i].latitude) <= 90 && std::abs(m_items[i].longitude) <= 180))
            return finish(false, "item " + std::to_string(i) + " is not on the globe");
        m_items[i].sequence = static_cast<std::uint16_t>(i);
    }
    m_phase = Phase::Announcing;
    announce(now);
}

void MissionClient::download(TimePoint now)
{
    m_items.clear();
    m_phase = Phase::RequestingCount;
    requestCount(now);
}

void MissionClient::clear(TimePoint now)
{
    m_phase = Phase::Clearing;
    sendClear(now);
}

void MissionClient::handleCount(TimePoint now, std::uint16_t count)
{
    if (m_phase != Phase::RequestingCount)
        return;
    m_expected = count;
    m_items.clear();
    m_attempts = 0;
    if (count == 0) {
        sendAck();
        finish(true);
        return;
    }
    m_phase = Phase::Downloading;
    requestItem(now);
}

void MissionClient::handleItemRequest(TimePoint now, std::uint16_t sequence, bool asInteger)
{
    if (m_phase != Phase::Announcing && m_phase != Phase::Uploading)
        return;
    if (sequence >= m_items.size())
        return; // the vehicle ends the transfer or runs into its own time-out
    m_phase = Phase::Uploading;
    m_attempts = 0;
    m_deadline = now + (sequence + 1u == m_items.size() ? kUploadedTimeout : kRequestTimeout);
    sendItem(m_items[sequence], asInteger || (state().capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_INT) != 0);
}

void MissionClient::handleItem(TimePoint now, const MissionItem &item)
{
    if (m_phase != Phase::Downloading || item.sequence != m_items.size())
        return; // a repeated answer to an earlier request
    m_items.push_back(item);
    m_attempts = 0;
    if (m_items.size() < m_expected)
        return requestItem(now);
    sendAck();
    finish(true);
}

void MissionClient::handleAck(TimePoint now, std::uint8_t result)
{
    switch (m_phase) {
    case Phase::Idle: return;
    case Phase::Announcing:
        // Acceptance of an earlier upload, unless this one is empty.
        if (result == mavlink::MAV_MISSION_ACCEPTED && !m_items.empty())
            return;
        break;
    case Phase::Uploading:
        // Caused by a duplicated item; the vehicle continues to request the item that it needs.
        if (result == mavlink::MAV_MISSION_INVALID_SEQUENCE) {
            m_deadline = now + kRequestTimeout;
            return;
        }
        break;
    case Phase::RequestingCount:
    case Phase::Downloading:
        if (result == mavlink::MAV_MISSION_ACCEPTED)
            return;
        break;
    case Phase::Clearing: break;
    }
    finish(result == mavlink::MAV_MISSION_ACCEPTED,
           result == mavlink::MAV_MISSION_ACCEPTED ? std::string() : missionResultText(result));
}

void MissionClient::handleDeadline(TimePoint now)
{
    if (now < m_deadline || giveUp())
        return;
    switch (m_phase) {
    case Phase::Idle: break;
    case Phase::Announcing: announce(now); break;
    case Phase::Uploading:
        if (++m_rounds >= kUploadRounds)
            return finish(false, "the vehicle stopped asking for items");
        m_phase = Phase::Announcing;
        announce(now);
        break;
    case Phase::RequestingCount: requestCount(now); break;
    case Phase::Downloading:
        m_requestFloats = m_items.empty() && m_attempts >= 3 ? !m_requestFloats : m_requestFloats;
        requestItem(now);
        break;
    case Phase::Clearing: sendClear(now); break;
    }
}

bool MissionClient::begin(RequestId id, MissionTransfer transfer)
{
    if (m_phase != Phase::Idle) {
        report(MissionResult{id, addressing().system, transfer, false, "another mission transfer is under way"});
        return false;
    }
    m_request = id;
    m_transfer = transfer;
    m_attempts = 0;
    m_rounds = 0;
    m_requestFloats = false;
    return true;
}

void MissionClient::announce(TimePoint now)
{
    mavlink::MissionCount message;
    message.count = static_cast<std::uint16_t>(m_items.size());
    send(message);
    ++m_attempts;
    m_deadline = now + kAnswerTimeout;
}

void MissionClient::requestCount(TimePoint now)
{
    mavlink::MissionRequestList message;
    send(message);
    ++m_attempts;
    m_deadline = now + kAnswerTimeout;
}

void MissionClient::requestItem(TimePoint now)
{
    const auto request = [&](auto message) {
        message.seq = static_cast<std::uint16_t>(m_items.size());
        send(message);
    };
    if (m_requestFloats)
        request(mavlink::MissionRequest{});
    else
        request(mavlink::MissionRequestInt{});
    ++m_attempts;
    m_deadline = now + kItemTimeout;
}

void MissionClient::sendItem(const MissionItem &item, bool asInteger)
{
    const auto fill = [&](auto message) {
        message.seq = item.sequence;
        message.frame = item.frame;
        message.command = item.command;
        message.current = item.current;
        message.autocontinue = item.autoContinue;
        message.param1 = item.parameters[0];
        message.param2 = item.parameters[1];
        message.param3 = item.parameters[2];
        message.param4 = item.parameters[3];
        message.z = item.altitude;
        return message;
    };
    if (asInteger) {
        auto message = fill(mavlink::MissionItemInt{});
        message.x = static_cast<std::int32_t>(std::llround(item.latitude * 1e7));
        message.y = static_cast<std::int32_t>(std::llround(item.longitude * 1e7));
        send(message);
    } else {
        auto message = fill(mavlink::MissionItem{});
        message.x = static_cast<float>(item.latitude);
        message.y = static_cast<float>(item.longitude);
        send(message);
    }
}

void MissionClient::sendClear(TimePoint now)
{
    mavlink::MissionClearAll message;
    send(message);
    ++m_attempts;
    m_deadline = now + kAnswerTimeout;
}

void MissionClient::sendAck()
{
    mavlink::MissionAck message;
    message.type = mavlink::MAV_MISSION_ACCEPTED;
    send(message);
}

void MissionClient::finish(bool ok, std::string reason, bool changeUnanswered)
{
    if (ok) {
        if (m_transfer == MissionTransfer::Clear)
            m_items.clear();
        m_mission = std::make_shared<const std::vector<MissionItem>>(std::move(m_items));
    }
    m_items.clear();
    m_phase = Phase::Idle;
    m_deadline = kNever;
    report(MissionResult{m_request, addressing().system, m_transfer, ok, std::move(reason), changeUnanswered});
}

bool MissionClient::giveUp()
{
    if (m_phase == Phase::Idle || m_attempts < kAttempts)
        return false;
    std::string reason = "no answer to " + std::to_string(kAttempts) + " attempts";
    if (m_phase == Phase::Downloading)
        reason += " for item " + std::to_string(m_items.size());
    finish(false, std::move(reason), m_transfer != MissionTransfer::Download);
    return true;
}

} // namespace skyseal::vehicle
