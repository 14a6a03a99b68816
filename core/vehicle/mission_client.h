// Client of the mission protocol: upload, download and clear of the flight plan, one transfer at a time; each step is repeated
// until it is answered. https://mavlink.io/en/services/mission.html
//
//     Upload:   MISSION_COUNT → (MISSION_REQUEST_INT n → MISSION_ITEM_INT n)* → MISSION_ACK
//     Download: MISSION_REQUEST_LIST → MISSION_COUNT → (MISSION_REQUEST_INT n → MISSION_ITEM_INT n)* → our MISSION_ACK
//     Clear:    MISSION_CLEAR_ALL → MISSION_ACK
//
// Older firmware requests items by MISSION_REQUEST; it gets float items unless its capabilities name integer items.
// On ArduPilot item 0 is the home position: downloads contain it, and an upload must begin with it.
#pragma once

#include "core/vehicle/micro_protocol.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class MissionClient : public MicroProtocol
{
public:
    static constexpr Duration kAnswerTimeout = std::chrono::milliseconds(1500);
    static constexpr Duration kItemTimeout = std::chrono::milliseconds(500);
    static constexpr int kAttempts = 8; ///< of each step
    /// For the next request of the vehicle, which repeats its requests itself.
    static constexpr Duration kRequestTimeout = std::chrono::seconds(8);
    /// For the acknowledgement after the last item. If it is lost, the vehicle sends nothing more.
    static constexpr Duration kUploadedTimeout = std::chrono::seconds(3);
    static constexpr int kUploadRounds = 5; ///< how often an upload starts again after a time-out
    static constexpr std::size_t kMaxItems = 65535;

    using MicroProtocol::MicroProtocol;

    /// ReadMission, WriteMission and ClearMission. Fails at once while another transfer is in progress.
    bool perform(TimePoint now, RequestId id, const Request &request) override;
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override { return m_deadline; }

    /// As last read, or as the vehicle accepted it; null before.
    std::shared_ptr<const std::vector<MissionItem>> mission() const { return m_mission; }

private:
    enum class Phase : std::uint8_t { Idle, Announcing, Uploading, RequestingCount, Downloading, Clearing };

    void upload(TimePoint now, std::vector<MissionItem> items);
    void download(TimePoint now);
    void clear(TimePoint now);

    void handleCount(TimePoint now, std::uint16_t count);
    void handleItemRequest(TimePoint now, std::uint16_t sequence, bool asInteger);
    void handleItem(TimePoint now, const MissionItem &item);
    void handleAck(TimePoint now, std::uint8_t result);

    bool begin(RequestId id, MissionTransfer transfer);
    void announce(TimePoint now);
    void requestCount(TimePoint now);
    void requestItem(TimePoint now);
    void sendItem(const MissionItem &item, bool asInteger);
    void sendClear(TimePoint now);
    void sendAck();
    void finish(bool ok, std::string reason = {}, bool changeUnanswered = false);
    bool giveUp();

    RequestId m_request{};
    Phase m_phase = Phase::Idle;
    MissionTransfer m_transfer{};
    std::vector<MissionItem> m_items;
    std::size_t m_expected = 0;
    bool m_requestFloats = false; ///< the vehicle does not answer MISSION_REQUEST_INT
    int m_attempts = 0;
    int m_rounds = 0;
    TimePoint m_deadline = kNever;
    std::shared_ptr<const std::vector<MissionItem>> m_mission;
};

} // namespace skyseal::vehicle
