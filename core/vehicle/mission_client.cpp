#include "core/vehicle/mission_client.h"

#include "core/vehicle/message_io.h"
#include "core/vehicle/result_text.h"

#include <cmath>

namespace skyseal::vehicle {

void MissionClient::upload(TimePoint now, std::vector<MissionItem> items, MessageQueue &outbox)
{
    if (!begin(MissionTransfer::Upload))
        return;
    if (items.size() > kMostItems)
        return finish(false, "a mission has at most " + std::to_string(kMostItems) + " items");
    m_items = std::move(items);
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        if (!(std::abs(m_items[i].latitude) <= 90 && std::abs(m_items[i].longitude) <= 180))
            return finish(false, "item " + std::to_string(i) + " is not on the globe");
        m_items[i].sequence = static_cast<std::uint16_t>(i);
    }
    m_phase = Phase::Announcing;
    announce(now, outbox);
}

void MissionClient::download(TimePoint now, MessageQueue &outbox)
{
    if (!begin(MissionTransfer::Download))
        return;
    m_items.clear();
    m_phase = Phase::AskingForCount;
    askForCount(now, outbox);
}

void MissionClient::clear(TimePoint now, MessageQueue &outbox)
{
    if (!begin(MissionTransfer::Clear))
        return;
    m_phase = Phase::Clearing;
    sendClear(now, outbox);
}

void MissionClient::handleCount(TimePoint now, std::uint16_t count, MessageQueue &outbox)
{
    if (m_phase != Phase::AskingForCount)
        return;
    m_expected = count;
    m_items.clear();
    m_attempts = 0;
    if (count == 0) {
        sendAck(outbox);
        finish(true);
        return;
    }
    m_phase = Phase::Downloading;
    askForItem(now, outbox);
}

void MissionClient::handleRequest(TimePoint now, std::uint16_t sequence, bool asInteger, MessageQueue &outbox)
{
    if (m_phase != Phase::Announcing && m_phase != Phase::Uploading)
        return;
    if (sequence >= m_items.size())
        return; // the vehicle will end it, or run into its own time-out
    m_phase = Phase::Uploading;
    m_attempts = 0;
    m_deadline = now + (sequence + 1u == m_items.size() ? kUploadedTimeout : kRequestTimeout);
    sendItem(m_items[sequence], asInteger || m_takesIntegers, outbox);
}

void MissionClient::handleItem(TimePoint now, const MissionItem &item, MessageQueue &outbox)
{
    if (m_phase != Phase::Downloading || item.sequence != m_items.size())
        return; // a repeated answer to an earlier request
    m_items.push_back(item);
    m_attempts = 0;
    if (m_items.size() < m_expected)
        return askForItem(now, outbox);
    sendAck(outbox);
    finish(true);
}

void MissionClient::handleAck(TimePoint now, std::uint8_t result, MessageQueue &)
{
    switch (m_phase) {
    case Phase::Idle: return;
    case Phase::Announcing:
        // An answer to an upload before this one, unless the vehicle refuses or there was nothing to send.
        if (result == mavlink::MAV_MISSION_ACCEPTED && !m_items.empty())
            return;
        break;
    case Phase::Uploading:
        // A duplicated item; the vehicle goes on asking for the one that it needs.
        if (result == mavlink::MAV_MISSION_INVALID_SEQUENCE) {
            m_deadline = now + kRequestTimeout;
            return;
        }
        break;
    case Phase::AskingForCount:
    case Phase::Downloading:
        if (result == mavlink::MAV_MISSION_ACCEPTED)
            return;
        break;
    case Phase::Clearing: break;
    }
    finish(result == mavlink::MAV_MISSION_ACCEPTED,
           result == mavlink::MAV_MISSION_ACCEPTED ? std::string() : missionResultText(result));
}

void MissionClient::handleDeadline(TimePoint now, MessageQueue &outbox)
{
    if (now < m_deadline || giveUp())
        return;
    switch (m_phase) {
    case Phase::Idle: break;
    case Phase::Announcing: announce(now, outbox); break;
    case Phase::Uploading:
        if (++m_rounds >= kUploadRounds)
            return finish(false, "the vehicle stopped asking for items");
        m_phase = Phase::Announcing;
        announce(now, outbox);
        break;
    case Phase::AskingForCount: askForCount(now, outbox); break;
    case Phase::Downloading:
        m_askForFloats = m_items.empty() && m_attempts >= 3 ? !m_askForFloats : m_askForFloats;
        askForItem(now, outbox);
        break;
    case Phase::Clearing: sendClear(now, outbox); break;
    }
}

std::optional<MissionResult> MissionClient::poll()
{
    if (m_results.empty())
        return std::nullopt;
    MissionResult result = std::move(m_results.front());
    m_results.pop_front();
    return result;
}

bool MissionClient::begin(MissionTransfer transfer)
{
    if (isBusy()) {
        m_results.push_back({transfer, false, "another mission transfer is under way"});
        return false;
    }
    m_transfer = transfer;
    m_attempts = 0;
    m_rounds = 0;
    m_askForFloats = false;
    return true;
}

void MissionClient::announce(TimePoint now, MessageQueue &outbox)
{
    mavlink::MissionCount message;
    message.target_system = m_addressing.system;
    message.target_component = m_addressing.component;
    message.count = static_cast<std::uint16_t>(m_items.size());
    push(outbox, message, true);
    ++m_attempts;
    m_deadline = now + kAnswerTimeout;
}

void MissionClient::askForCount(TimePoint now, MessageQueue &outbox)
{
    mavlink::MissionRequestList message;
    message.target_system = m_addressing.system;
    message.target_component = m_addressing.component;
    push(outbox, message, true);
    ++m_attempts;
    m_deadline = now + kAnswerTimeout;
}

void MissionClient::askForItem(TimePoint now, MessageQueue &outbox)
{
    const auto ask = [&](auto message) {
        message.target_system = m_addressing.system;
        message.target_component = m_addressing.component;
        message.seq = static_cast<std::uint16_t>(m_items.size());
        push(outbox, message, true);
    };
    if (m_askForFloats)
        ask(mavlink::MissionRequest{});
    else
        ask(mavlink::MissionRequestInt{});
    ++m_attempts;
    m_deadline = now + kItemTimeout;
}

void MissionClient::sendItem(const MissionItem &item, bool asInteger, MessageQueue &outbox) const
{
    const auto fill = [&](auto message) {
        message.target_system = m_addressing.system;
        message.target_component = m_addressing.component;
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
        push(outbox, message, true);
    } else {
        auto message = fill(mavlink::MissionItem{});
        message.x = static_cast<float>(item.latitude);
        message.y = static_cast<float>(item.longitude);
        push(outbox, message, true);
    }
}

void MissionClient::sendClear(TimePoint now, MessageQueue &outbox)
{
    mavlink::MissionClearAll message;
    message.target_system = m_addressing.system;
    message.target_component = m_addressing.component;
    push(outbox, message, true);
    ++m_attempts;
    m_deadline = now + kAnswerTimeout;
}

void MissionClient::sendAck(MessageQueue &outbox) const
{
    mavlink::MissionAck message;
    message.target_system = m_addressing.system;
    message.target_component = m_addressing.component;
    message.type = mavlink::MAV_MISSION_ACCEPTED;
    push(outbox, message, true);
}

void MissionClient::finish(bool ok, std::string reason)
{
    if (ok) {
        if (m_transfer == MissionTransfer::Clear)
            m_items.clear();
        m_mission = std::make_shared<const std::vector<MissionItem>>(std::move(m_items));
    }
    m_items.clear();
    m_phase = Phase::Idle;
    m_deadline = kNever;
    m_results.push_back({m_transfer, ok, std::move(reason)});
}

bool MissionClient::giveUp()
{
    if (m_phase == Phase::Idle || m_attempts < kAttempts)
        return false;
    std::string reason = "no answer to " + std::to_string(kAttempts) + " attempts";
    if (m_phase == Phase::Downloading)
        reason += " for item " + std::to_string(m_items.size());
    finish(false, std::move(reason));
    m_results.back().unanswered = true;
    return true;
}

} // namespace skyseal::vehicle
