// Client of the mission protocol: upload, download and clear of the flight plan, the fence and the rally points, one transfer
// at a time. https://mavlink.io/en/services/mission.html
//
//     Upload:   MISSION_COUNT → (MISSION_REQUEST_INT n → MISSION_ITEM_INT n)* → MISSION_ACK
//     Download: MISSION_REQUEST_LIST → MISSION_COUNT → (MISSION_REQUEST_INT n → MISSION_ITEM_INT n)* → our MISSION_ACK
//     Clear:    MISSION_CLEAR_ALL → MISSION_ACK
//
// Every message of this end is repeated when it or its answer was lost, judging by the measured round trip. The following
// describes ArduPilot as in its GCS_MAVLink/MissionItemProtocol.cpp and GCS_Common.cpp, and PX4 as in its mavlink_mission.cpp.
//
// Download: ArduPilot answers requests for items in any order, so that a window of them is under way. PX4 takes the expected
// request and the one before: another one ends the download with MAV_MISSION_ERROR, after which further requests get no answer;
// so does a silence of 5 s, without a word.
//
// Upload: the vehicle asks, and repeats a request after 1 s (ArduPilot) or 250 ms (PX4). So the item sent last is repeated.
// If it had arrived, ArduPilot says that it expects another one (MAV_MISSION_INVALID_SEQUENCE): the lost request was for the
// next one. PX4 ignores an item that it does not expect: it is sent the next one as well, which it takes if the lost request
// was for that. Without an item for 8 s ArduPilot ends the upload with MAV_MISSION_OPERATION_CANCELLED, and then answers an
// item with MAV_MISSION_ERROR. PX4 ends it silently after 5 s, and then accepts a repetition of the item that it took last as
// if that had been the end: acceptance counts only after the last item was sent.
//
// PX4 refuses a new upload (MAV_MISSION_ERROR) while it serves a transfer whose end was lost. Any acknowledgement ends that.
//
// Firmware that does not read mission_type, as ArduCopter 3.6, takes every list for its mission: to clear the fence would clear
// the mission. Lists other than the mission are left alone unless the capabilities of the autopilot name them.
//
// Another station may change a list: PlanCopy watches for that. Such a list is not overwritten unless the request says so. One
// that was edited is sent only if the vehicle still has the list that it was made from, which is read first where no id tells
// it.
//
// Older firmware requests items by MISSION_REQUEST; it gets float items unless its capabilities name integer items.
//
// On ArduPilot item 0 of a mission is the home position: downloads contain it, and an upload must begin with it, or its first
// item would be lost. One that begins with another command gets the home position put before it. In files of fences and rally
// points, Mission Planner writes a home position as well, which is left out. MissionResult says what was done.
#pragma once

#include "core/vehicle/firmware_info.h"
#include "core/vehicle/micro_protocol.h"
#include "core/vehicle/plan_copy.h"
#include "core/vehicle/repetition.h"
#include "core/vehicle/request_window.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class MissionClient : public MicroProtocol
{
public:
    /// A step fails after so many attempts without an answer, and not before kGiveUp.
    static constexpr int kAttempts = 8;
    static constexpr Duration kGiveUp = std::chrono::seconds(12);
    /// A download begins again after so long without an item, except from ArduPilot, which knows no downloads to end. PX4's
    /// MAVLINK_MISSION_PROTOCOL_TIMEOUT_DEFAULT is 5 s.
    static constexpr Duration kDownloadStalled = std::chrono::seconds(6);
    /// Firmware that sends no item for so long, and does not claim to know integer items, is asked for float items.
    static constexpr Duration kFloatsAfter = std::chrono::seconds(2);
    /// For the next request of the vehicle; then the upload starts again. ArduPilot's upload_timeout_ms.
    static constexpr Duration kRequestTimeout = std::chrono::seconds(8);
    /// For the acknowledgement after the last item. If it is lost, the vehicle may send nothing more.
    static constexpr Duration kUploadedTimeout = std::chrono::seconds(3);
    static constexpr int kRounds = 5; ///< how often a transfer begins
    /// The most requests of the vehicle in a row that its refusals of repeated items may replace.
    static constexpr int kInferred = 4;
    /// Messages to PX4 during an upload that end its earlier transfers.
    static constexpr int kReleases = 3;
    static constexpr std::size_t kMaxItems = 65535;

    /// For AUTOPILOT_VERSION, by which the autopilot says what lists it has.
    static constexpr Duration kCapabilitiesTimeout = FirmwareInfo::kAttempts * FirmwareInfo::kInterval;

    /// `firmware` must outlive this object.
    MissionClient(VehicleContext &context, FirmwareInfo &firmware) : MicroProtocol(context), m_firmware(firmware) {}

    /// ReadMission, WriteMission and ClearMission. Fails at once while another transfer is in progress.
    bool perform(TimePoint now, RequestId id, const Request &request) override;
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;
    std::optional<TransferProgress> progress() const override;

    /// The part about the lists of a message that is not late.
    void handleCurrent(TimePoint now, const mavlink::MissionCurrent &current);

    /// The list of this type as last read, or as the vehicle accepted it; null before.
    const MissionItems &plan(MissionType type) const { return m_plans[static_cast<std::size_t>(type)].items(); }
    const Reason &outdated(MissionType type) const { return m_plans[static_cast<std::size_t>(type)].outdated(); }

private:
    enum class Phase : std::uint8_t {
        Idle,
        AwaitingCapabilities,
        Announcing,
        Uploading,
        RequestingCount,
        Downloading,
        Clearing
    };

    void start(TimePoint now);
    void transfer(TimePoint now);
    void upload(TimePoint now);
    void downloaded(TimePoint now);
    void settleFirstItem();
    bool keepsHome(std::uint8_t type) const;
    Reason problemOf(const MissionItem &item) const;
    int numberInRequest(std::size_t sequence) const;

    void handleCount(TimePoint now, std::uint16_t count);
    void handleItemRequest(TimePoint now, std::uint16_t sequence, bool asInteger);
    void handleItem(TimePoint now, const MissionItem &item);
    void handleAck(TimePoint now, std::uint8_t result, std::uint32_t id);
    void handleUploadAck(TimePoint now, std::uint8_t result);

    PlanCopy &plan() { return m_plans[static_cast<std::size_t>(m_type)]; }
    bool begin(RequestId id, MissionTransfer transfer, MissionType type);
    void enter(TimePoint now, Phase phase);
    void transmit(TimePoint now);
    void restart(TimePoint now, Reason reason);
    void release(TimePoint now);
    void awaitItem(TimePoint now);
    Reason missingItem() const;
    void requestItems(TimePoint now);
    void offer(TimePoint now, std::size_t sequence);
    void sendItem(const MissionItem &item);
    Reason refusalOf(std::size_t sequence, Reason reason) const;
    void finish(TimePoint now, bool ok, Reason reason = {}, bool changeUnanswered = false);
    void giveUp(TimePoint now);
    /// The message with the type of this transfer.
    template<typename Message> void sendTyped(Message message)
    {
        message.mission_type = static_cast<std::uint8_t>(m_type);
        send(message);
    }

    FirmwareInfo &m_firmware;
    RequestId m_request{};
    Phase m_phase = Phase::Idle;
    MissionTransfer m_transfer{};
    MissionType m_type{};
    std::vector<MissionItem> m_items;
    bool m_withoutHome = false; ///< of an upload
    bool m_overwrite = false;
    MissionItems m_basis;              ///< of an upload
    std::vector<MissionItem> m_edited; ///< to upload, while the vehicle's list is read to compare it with the basis
    bool m_isComparing = false;
    RequestWindow m_window;       ///< of a download; its round trip serves all transfers
    bool m_requestFloats = false; ///< the vehicle does not answer MISSION_REQUEST_INT
    bool m_offerIntegers = true;  ///< the vehicle asks for integer items
    std::size_t m_offered = 0;    ///< the item that the vehicle was sent last because it asked, or seemed to ask, for it
    std::size_t m_furthest = 0;   ///< the last one that was sent in this round
    int m_inferred = 0;           ///< items sent since the vehicle asked for one
    int m_rounds = 0;             ///< the transfer has begun again so often
    int m_moved = 0;              ///< places that the items of an upload moved up, because of the first one
    Reason m_remark;              ///< of the result of an upload
    int m_releases = 0;
    Repetition m_repetition;         ///< of the message sent last
    TimePoint m_floatsDue{};         ///< without an item until then, the other form of items is requested
    TimePoint m_deadline = kNever;   ///< the transfer fails, or begins again
    std::array<PlanCopy, 3> m_plans; ///< by MissionType
};

} // namespace skyseal::vehicle
