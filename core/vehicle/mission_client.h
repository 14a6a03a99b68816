// MAVLink's mission protocol: upload, download and clear of the flight plan, one at a time, each step repeated until it is
// answered. https://mavlink.io/en/services/mission.html
//
//     Upload:   MISSION_COUNT → (MISSION_REQUEST_INT n → MISSION_ITEM_INT n)* → MISSION_ACK
//     Download: MISSION_REQUEST_LIST → MISSION_COUNT → (MISSION_REQUEST_INT n → MISSION_ITEM_INT n)* → our MISSION_ACK
//     Clear:    MISSION_CLEAR_ALL → MISSION_ACK
//
// Old firmware asks by MISSION_REQUEST; it gets float items unless the vehicle said that it takes integer ones.
// On ArduPilot item 0 is the home position: it comes with every download and a plan begins with it.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/mission.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/transfer_result.h"
#include "core/vehicle/vehicle_config.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class MissionClient
{
public:
    static constexpr Duration kAnswerTimeout = std::chrono::milliseconds(1500);
    static constexpr Duration kItemTimeout = std::chrono::milliseconds(500);
    static constexpr int kAttempts = 8; ///< of each step
    /// For the vehicle's next request, which it repeats by itself.
    static constexpr Duration kRequestTimeout = std::chrono::seconds(8);
    /// For its acknowledgement after the last item. When that one got lost, the vehicle is done and silent.
    static constexpr Duration kUploadedTimeout = std::chrono::seconds(3);
    static constexpr int kUploadRounds = 5; ///< an upload that fell silent begins anew
    static constexpr std::size_t kMostItems = 65535;

    explicit MissionClient(const Addressing &addressing) : m_addressing(addressing) {}

    /// From the vehicle's capabilities: whether MISSION_REQUEST may be answered by MISSION_ITEM_INT.
    void setTakesIntegers(bool takesIntegers) { m_takesIntegers = takesIntegers; }

    void upload(TimePoint now, std::vector<MissionItem> items, MessageQueue &outbox);
    void download(TimePoint now, MessageQueue &outbox);
    void clear(TimePoint now, MessageQueue &outbox);

    // What the vehicle sends, for mission type 0 and addressed to us.
    void handleCount(TimePoint now, std::uint16_t count, MessageQueue &outbox);
    void handleRequest(TimePoint now, std::uint16_t sequence, bool asInteger, MessageQueue &outbox);
    void handleItem(TimePoint now, const MissionItem &item, MessageQueue &outbox);
    void handleAck(TimePoint now, std::uint8_t result, MessageQueue &outbox);

    void handleDeadline(TimePoint now, MessageQueue &outbox);
    TimePoint nextDeadline() const { return m_deadline; }

    bool isBusy() const { return m_phase != Phase::Idle; }
    /// As last read, or as the vehicle accepted it; null before.
    std::shared_ptr<const std::vector<MissionItem>> mission() const { return m_mission; }
    std::optional<MissionResult> poll();

private:
    enum class Phase : std::uint8_t { Idle, Announcing, Uploading, AskingForCount, Downloading, Clearing };

    bool begin(MissionTransfer transfer);
    void announce(TimePoint now, MessageQueue &outbox);
    void askForCount(TimePoint now, MessageQueue &outbox);
    void askForItem(TimePoint now, MessageQueue &outbox);
    void sendItem(const MissionItem &item, bool asInteger, MessageQueue &outbox) const;
    void sendClear(TimePoint now, MessageQueue &outbox);
    void sendAck(MessageQueue &outbox) const;
    void finish(bool ok, std::string reason = {});
    bool giveUp();

    Addressing m_addressing;
    bool m_takesIntegers = false;
    Phase m_phase = Phase::Idle;
    MissionTransfer m_transfer{};
    std::vector<MissionItem> m_items;
    std::size_t m_expected = 0;
    bool m_askForFloats = false; ///< the vehicle does not answer MISSION_REQUEST_INT
    int m_attempts = 0;
    int m_rounds = 0;
    TimePoint m_deadline = kNever;
    std::shared_ptr<const std::vector<MissionItem>> m_mission;
    std::deque<MissionResult> m_results;
};

} // namespace skyseal::vehicle
