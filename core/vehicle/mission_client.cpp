#include "core/vehicle/mission_client.h"

#include "core/mavlink/dialect.h"
#include "core/vehicle/mission_edit.h"
#include "core/vehicle/mission_place.h"
#include "core/vehicle/reasons.h"
#include "core/vehicle/result_reason.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace skyseal::vehicle {

namespace {

constexpr std::int32_t kNotUsed = std::numeric_limits<std::int32_t>::max(); ///< in x and y of MISSION_ITEM_INT

double fromInteger(std::int32_t value, double scale)
{
    return value == kNotUsed ? std::numeric_limits<double>::quiet_NaN() : value / scale;
}

std::int32_t toInteger(double value, double scale)
{
    return std::isnan(value) ? kNotUsed : static_cast<std::int32_t>(std::llround(value * scale));
}

template<typename Message> MissionItem toItem(const Message &m)
{
    MissionItem out{m.seq,          m.command,           plainFrame(m.frame),
                    m.current != 0, m.autocontinue != 0, {m.param1, m.param2, m.param3, m.param4}};
    if constexpr (std::is_same_v<Message, mavlink::MissionItemInt>) {
        out.latitude = fromInteger(m.x, integerScale(out));
        out.longitude = fromInteger(m.y, integerScale(out));
    } else {
        out.latitude = static_cast<double>(m.x);
        out.longitude = static_cast<double>(m.y);
    }
    out.altitude = m.z;
    return out;
}

/// "NAV_WAYPOINT", or the number of a command that the definitions do not have.
std::string commandName(std::uint16_t command)
{
    constexpr std::string_view kPrefix = "MAV_CMD_";
    const mavlink::EnumInfo *commands = mavlink::Dialect::builtin().enumeration("MAV_CMD");
    const std::string_view name = commands ? commands->nameOf(command) : std::string_view();
    return name.starts_with(kPrefix) ? std::string(name.substr(kPrefix.size())) : std::to_string(command);
}

} // namespace

bool MissionClient::perform(TimePoint now, RequestId id, const Request &request)
{
    if (const auto *write = std::get_if<WriteMission>(&request)) {
        if (begin(id, MissionTransfer::Upload, write->type)) {
            m_items = write->items;
            m_withoutHome = write->withoutHome;
            m_overwrite = write->overwrite;
            m_basis = write->basis;
            start(now);
        }
    } else if (const auto *read = std::get_if<ReadMission>(&request)) {
        if (begin(id, MissionTransfer::Download, read->type))
            start(now);
    } else if (const auto *clear = std::get_if<ClearMission>(&request)) {
        if (begin(id, MissionTransfer::Clear, clear->type)) {
            m_overwrite = clear->overwrite;
            start(now);
        }
    } else {
        return false;
    }
    return true;
}

/// Begins a transfer of the mission at once, one of another list when the autopilot says that it has such a list.
void MissionClient::start(TimePoint now)
{
    if (m_type == MissionType::Mission)
        return transfer(now);
    const bool isFence = m_type == MissionType::Fence;
    const std::uint64_t needed = isFence ? mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_FENCE
                                         : mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_RALLY;
    if (state().capabilities & needed)
        return transfer(now);
    if (state().knowsCapabilities())
        return finish(now, false, nothingSent(isFence ? reasons::kNoFence : reasons::kNoRally));
    m_phase = Phase::AwaitingCapabilities;
    m_deadline = now + kCapabilitiesTimeout;
    m_firmware.request(now);
}

void MissionClient::transfer(TimePoint now)
{
    const bool mayReplace = m_transfer == MissionTransfer::Download || m_overwrite || m_basis || !plan().isChangedByOther();
    if (!mayReplace)
        return finish(now, false, nothingSent(reasons::kPlanNotOverwritten(plan().outdated())));
    switch (m_transfer) {
    case MissionTransfer::Upload: return upload(now);
    case MissionTransfer::Download: return enter(now, Phase::RequestingCount);
    case MissionTransfer::Clear: return enter(now, Phase::Clearing);
    }
}

bool MissionClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    // Messages outside the transfer of this station only tell what the vehicle has.
    const auto take = [&]<typename Message>(std::type_identity<Message>, auto handle, auto overhear) {
        const auto m = unpack<Message>(frame);
        const bool isToUs = addressing().isForUs(m.target_system, m.target_component);
        if (isToUs && m_phase != Phase::Idle && m.mission_type == static_cast<std::uint8_t>(m_type))
            handle(m);
        else if (m.mission_type < m_plans.size())
            overhear(m_plans[m.mission_type], m, isToUs);
        return true;
    };
    const auto request = [&](PlanCopy &plan, const auto &, bool isToUs) {
        if (!isToUs) // otherwise it may be a repetition of what this station was asked
            plan.handleChange(now, 0, false);
    };
    const auto item = [&](PlanCopy &plan, const auto &m, bool) { plan.handleItem(toItem(m), keepsHome(m.mission_type)); };
    using std::type_identity;
    switch (frame.messageId()) {
    case mavlink::MissionCount::kId:
        return take(
            type_identity<mavlink::MissionCount>(),
            [&](const auto &m) {
                if (m_phase == Phase::RequestingCount)
                    plan().answered(m.opaque_id);
                handleCount(now, m.count);
            },
            [](PlanCopy &plan, const auto &m, bool) { plan.handleCount(m.count, m.opaque_id); });
    case mavlink::MissionRequest::kId:
        return take(
            type_identity<mavlink::MissionRequest>(), [&](const auto &m) { handleItemRequest(now, m.seq, false); }, request);
    case mavlink::MissionRequestInt::kId:
        return take(
            type_identity<mavlink::MissionRequestInt>(), [&](const auto &m) { handleItemRequest(now, m.seq, true); }, request);
    case mavlink::MissionItem::kId:
        return take(
            type_identity<mavlink::MissionItem>(), [&](const auto &m) { handleItem(now, toItem(m)); }, item);
    case mavlink::MissionItemInt::kId:
        return take(
            type_identity<mavlink::MissionItemInt>(), [&](const auto &m) { handleItem(now, toItem(m)); }, item);
    case mavlink::MissionAck::kId:
        return take(
            type_identity<mavlink::MissionAck>(), [&](const auto &m) { handleAck(now, m.type, m.opaque_id); },
            [&](PlanCopy &plan, const auto &m, bool isToUs) {
                if (m.type == mavlink::MAV_MISSION_ACCEPTED)
                    plan.handleChange(now, m.opaque_id, isToUs);
            });
    case mavlink::AutopilotVersion::kId:
        if (m_phase == Phase::AwaitingCapabilities)
            start(now);
        return true;
    default: return false;
    }
}

void MissionClient::handleCurrent(TimePoint now, const mavlink::MissionCurrent &m)
{
    // PX4 says UINT16_MAX when it has no mission, ArduPilot 0, which is also what old firmware says.
    std::optional<std::uint16_t> total;
    if (m.total == std::numeric_limits<std::uint16_t>::max() || m.mission_state == mavlink::MISSION_STATE_NO_MISSION)
        total = std::uint16_t{0};
    else if (m.total != 0 || m.mission_state != mavlink::MISSION_STATE_UNKNOWN)
        total = m.total;
    const auto copy = [this](MissionType type) -> PlanCopy & { return m_plans[static_cast<std::size_t>(type)]; };
    copy(MissionType::Mission).handleCurrent(now, m.mission_id, total);
    copy(MissionType::Fence).handleCurrent(now, m.fence_id, std::nullopt);
    copy(MissionType::Rally).handleCurrent(now, m.rally_points_id, std::nullopt);
}

/// Whether item 0 of such a list is the home position.
bool MissionClient::keepsHome(std::uint8_t type) const
{
    return type == mavlink::MAV_MISSION_TYPE_MISSION && keepsHomeFirst(state().autopilot);
}

void MissionClient::handleDeadline(TimePoint now)
{
    switch (m_phase) {
    case Phase::Idle: return;
    case Phase::AwaitingCapabilities:
        if (now >= m_deadline)
            finish(now, false, nothingSent(reasons::kCapabilitiesUnknown));
        return;
    case Phase::Downloading:
        if (now < m_deadline)
            return requestItems(now);
        return kind().isArduPilot() ? giveUp(now) : restart(now, missingItem());
    case Phase::Uploading:
        if (now >= m_deadline)
            return restart(now, reasons::kItemsNotRequested);
        break;
    case Phase::Announcing:
    case Phase::RequestingCount:
    case Phase::Clearing:
        if (now >= m_repetition.due() && now >= m_deadline && m_repetition.attempts() >= kAttempts)
            return giveUp(now);
        break;
    }
    if (now >= m_repetition.due())
        transmit(now);
}

TimePoint MissionClient::nextDeadline() const
{
    switch (m_phase) {
    case Phase::Idle: return kNever;
    case Phase::AwaitingCapabilities: return m_deadline;
    case Phase::Downloading: return std::min(m_window.nextDeadline(), m_deadline);
    case Phase::Uploading: return std::min(m_repetition.due(), m_deadline);
    default: return m_repetition.due();
    }
}

std::optional<TransferProgress> MissionClient::progress() const
{
    switch (m_phase) {
    case Phase::Uploading: return TransferProgress{m_request, m_offered, m_items.size()};
    case Phase::Downloading: return TransferProgress{m_request, m_window.received(), m_window.count()};
    default: return std::nullopt;
    }
}

void MissionClient::upload(TimePoint now)
{
    if (!m_items.empty()) {
        settleFirstItem();
        if (m_items.empty()) // that would clear the list
            return finish(now, false, reasons::kOnlyHome);
    }
    if (m_items.size() > kMaxItems)
        return finish(now, false, reasons::kTooManyItems(kMaxItems));
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        m_items[i].sequence = static_cast<std::uint16_t>(i);
        if (Reason problem = problemOf(m_items[i]); !problem.empty())
            return finish(now, false, std::move(problem));
    }
    if (!m_basis || (m_basis == plan().items() && plan().isWatched(now)))
        return enter(now, Phase::Announcing);
    m_isComparing = true;
    m_edited = std::exchange(m_items, {});
    enter(now, Phase::RequestingCount);
}

/// The list was read for its own sake, or before an edited one takes its place.
void MissionClient::downloaded(TimePoint now)
{
    if (!m_isComparing)
        return finish(now, true);
    sendTyped(mavlink::MissionAck{.type = mavlink::MAV_MISSION_ACCEPTED});
    if (!plan().matches(m_items, m_basis, keepsHome(static_cast<std::uint8_t>(m_type)))) {
        plan().end(now, std::make_shared<const std::vector<MissionItem>>(std::move(m_items)), false);
        return finish(now, false, nothingSent(reasons::kPlanReadAgain));
    }
    m_isComparing = false;
    m_items = std::exchange(m_edited, {});
    m_rounds = 0;
    plan().answered(0);
    enter(now, Phase::Announcing);
}

/// Whether the first item is a home position is only known from its form: a waypoint that has another form is left in its
/// place, since a vehicle that took a second home for a waypoint would fly to it.
void MissionClient::settleFirstItem()
{
    const MissionItem &first = m_items.front();
    const bool likeHome = isLikeHome(first) && !m_withoutHome;
    if (m_type != MissionType::Mission) {
        if (!likeHome)
            return;
        m_items.erase(m_items.begin());
        m_moved = -1;
        m_remark = reasons::kHomeLeftOut;
    } else if (!kind().isArduPilot()) {
        if (likeHome && first.current)
            m_remark = reasons::kHomeIsWaypoint;
    } else if (m_withoutHome || first.command != mavlink::MAV_CMD_NAV_WAYPOINT) {
        m_items = withHome(std::move(m_items), homeItem(state().home));
        m_moved = 1;
        m_remark = reasons::kHomeInserted;
    } else if (!likeHome) {
        m_remark = reasons::kFirstItemIsHome;
    }
}

/// Why the item cannot be sent; empty if it can.
Reason MissionClient::problemOf(const MissionItem &item) const
{
    const double scale = integerScale(item);
    for (const double value : {item.latitude, item.longitude}) {
        if (std::isnan(value))
            continue;
        if (!(std::abs(std::round(value * scale)) < kNotUsed))
            return isGlobal(item) ? reasons::kItemNotOnGlobe(numberInRequest(item.sequence))
                                  : refusalOf(item.sequence, reasons::kPlaceTooFar);
        if (scale == 1 && value != std::round(value))
            return refusalOf(item.sequence, reasons::kNeedsWholeNumber);
    }
    if (isGlobal(item) && (std::abs(item.latitude) > 90 || std::abs(item.longitude) > 180))
        return reasons::kItemNotOnGlobe(numberInRequest(item.sequence));
    return {};
}

/// The number that an item has in the request. A home position that was put before them stands for the first one.
int MissionClient::numberInRequest(std::size_t sequence) const
{
    return std::max(static_cast<int>(sequence) - m_moved, 0);
}

/// The reason with the item that it is about.
Reason MissionClient::refusalOf(std::size_t sequence, Reason reason) const
{
    const MissionItem &item = m_items[sequence];
    return reasons::kItemRefused(numberInRequest(sequence), commandName(item.command), std::move(reason));
}

void MissionClient::handleCount(TimePoint now, std::uint16_t count)
{
    if (m_phase != Phase::RequestingCount)
        return;
    m_repetition.measure(now, m_window.rtt());
    m_items.assign(count, {});
    if (count == 0)
        return downloaded(now);
    m_phase = Phase::Downloading;
    m_floatsDue = now + kFloatsAfter;
    awaitItem(now);
    m_window.setMost(kind().isArduPilot() ? RequestWindow::kMost : 1);
    m_window.begin();
    m_window.setCount(count);
    m_window.openUpTo(count);
    requestItems(now);
}

void MissionClient::handleItem(TimePoint now, const MissionItem &item)
{
    if (m_phase != Phase::Downloading || !m_window.arrived(now, item.sequence))
        return; // a repeated answer to an earlier request
    m_items[item.sequence] = item;
    awaitItem(now);
    if (m_window.isComplete())
        return downloaded(now);
    requestItems(now);
}

void MissionClient::requestItems(TimePoint now)
{
    const bool knowsIntegers = (state().capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_INT) != 0;
    if (!knowsIntegers && m_window.received() == 0 && now >= m_floatsDue) {
        m_requestFloats = !m_requestFloats;
        m_floatsDue = now + kFloatsAfter;
    }
    while (const auto index = m_window.poll(now)) {
        const auto request = [&](auto message) {
            message.seq = static_cast<std::uint16_t>(*index);
            sendTyped(message);
        };
        if (m_requestFloats)
            request(mavlink::MissionRequest{});
        else
            request(mavlink::MissionRequestInt{});
    }
}

void MissionClient::handleItemRequest(TimePoint now, std::uint16_t sequence, bool asInteger)
{
    if (m_phase != Phase::Announcing && m_phase != Phase::Uploading)
        return;
    if (sequence >= m_items.size())
        return; // the vehicle ends the transfer or runs into its own time-out
    const bool asksAgain = m_phase == Phase::Uploading && sequence == m_offered;
    if (asksAgain && now < m_repetition.first() + m_window.rtt().shortest())
        return; // asked before the item arrived that is on its way
    if (!asksAgain) {
        m_repetition.measure(now, m_window.rtt());
        m_repetition.begin();
    }
    m_phase = Phase::Uploading;
    m_offerIntegers = asInteger || (state().capabilities & mavlink::MAV_PROTOCOL_CAPABILITY_MISSION_INT) != 0;
    m_inferred = 0;
    m_deadline = now + (sequence + 1u == m_items.size() ? kUploadedTimeout : kRequestTimeout);
    offer(now, sequence);
}

void MissionClient::handleAck(TimePoint now, std::uint8_t result, std::uint32_t id)
{
    const bool accepted = result == mavlink::MAV_MISSION_ACCEPTED;
    if (accepted && (m_phase == Phase::Uploading || m_phase == Phase::Announcing || m_phase == Phase::Clearing))
        plan().answered(id);
    // Caused by a repeated item, perhaps of the transfer before.
    const bool otherExpected = result == mavlink::MAV_MISSION_INVALID_SEQUENCE;
    const bool timedOut = result == mavlink::MAV_MISSION_OPERATION_CANCELLED;
    switch (m_phase) {
    case Phase::Idle:
    case Phase::AwaitingCapabilities: return;
    case Phase::Announcing:
        // The end of an earlier upload: its acceptance, unless this one is empty, or its time-out.
        if (otherExpected || timedOut || (accepted && !m_items.empty()))
            return;
        if (result == mavlink::MAV_MISSION_ERROR && kind().isPx4() && m_releases < kReleases)
            return release(now);
        break;
    case Phase::Uploading: return handleUploadAck(now, result);
    case Phase::RequestingCount:
        if (otherExpected || timedOut || accepted)
            return;
        break;
    case Phase::Downloading:
        if (accepted)
            return;
        // A request out of order ends the download on the vehicle (PX4).
        if (otherExpected || result == mavlink::MAV_MISSION_ERROR)
            return restart(now, missionResultReason(result));
        break;
    case Phase::Clearing:
        if (otherExpected || timedOut)
            return;
        break;
    }
    finish(now, accepted, accepted ? Reason() : missionResultReason(result));
}

void MissionClient::handleUploadAck(TimePoint now, std::uint8_t result)
{
    const bool repeated = m_repetition.isRepeated();
    const bool last = m_offered + 1 == m_items.size();
    switch (result) {
    case mavlink::MAV_MISSION_ACCEPTED:
        // Of an item before the last one: PX4 has ended the upload, and takes the repetition for that of the last item.
        return m_furthest + 1 >= m_items.size() ? finish(now, true) : restart(now, reasons::kUploadEndedEarly);
    case mavlink::MAV_MISSION_OPERATION_CANCELLED: return restart(now, missionResultReason(result));
    case mavlink::MAV_MISSION_INVALID_SEQUENCE:
        if (repeated && !last && m_inferred < kInferred) {
            ++m_inferred;
            m_repetition.begin();
            offer(now, m_offered + 1);
        }
        return;
    case mavlink::MAV_MISSION_ERROR:
        // The vehicle no longer expects an item. The lost answer was its acceptance, a refusal, or the end by time-out.
        if (repeated)
            return restart(now, missionResultReason(result));
        break;
    default: break;
    }
    finish(now, false, refusalOf(m_offered, missionResultReason(result)));
}

bool MissionClient::begin(RequestId id, MissionTransfer transfer, MissionType type)
{
    if (m_phase != Phase::Idle) {
        report(MissionResult{id, addressing().system, transfer, type, false, reasons::kMissionUnderWay});
        return false;
    }
    m_request = id;
    m_transfer = transfer;
    m_type = type;
    m_items.clear();
    m_edited.clear();
    m_basis.reset();
    m_withoutHome = m_overwrite = m_isComparing = false;
    plan().begin();
    m_rounds = m_releases = m_moved = 0;
    m_remark = {};
    m_furthest = 0;
    m_requestFloats = false;
    suppose(m_window.rtt());
    return true;
}

/// Starts a step whose message is repeated until it is answered.
void MissionClient::enter(TimePoint now, Phase phase)
{
    m_phase = phase;
    m_repetition.begin();
    m_deadline = now + kGiveUp;
    transmit(now);
}

void MissionClient::transmit(TimePoint now)
{
    switch (m_phase) {
    case Phase::Announcing: {
        mavlink::MissionCount message;
        message.count = static_cast<std::uint16_t>(m_items.size());
        sendTyped(message);
        break;
    }
    case Phase::RequestingCount: sendTyped(mavlink::MissionRequestList{}); break;
    case Phase::Clearing: sendTyped(mavlink::MissionClearAll{}); break;
    case Phase::Uploading:
        sendItem(m_items[m_offered]);
        if (kind().isPx4() && m_repetition.attempts() > 0 && m_offered + 1 < m_items.size())
            sendItem(m_items[m_offered + 1]);
        break;
    case Phase::Idle:
    case Phase::AwaitingCapabilities:
    case Phase::Downloading: return;
    }
    m_repetition.sent(now, m_window.rtt());
}

void MissionClient::offer(TimePoint now, std::size_t sequence)
{
    m_offered = sequence;
    transmit(now);
}

/// Tells the vehicle that no earlier transfer with this station is under way, and announces the upload again.
void MissionClient::release(TimePoint now)
{
    ++m_releases;
    for (const MissionType type : {MissionType::Mission, MissionType::Fence, MissionType::Rally})
        send(mavlink::MissionAck{.type = mavlink::MAV_MISSION_OPERATION_CANCELLED,
                                 .mission_type = static_cast<std::uint8_t>(type)});
    enter(now, Phase::Announcing);
}

void MissionClient::restart(TimePoint now, Reason reason)
{
    if (++m_rounds >= kRounds)
        return finish(now, false, std::move(reason));
    m_furthest = 0;
    enter(now, m_transfer == MissionTransfer::Upload && !m_isComparing ? Phase::Announcing : Phase::RequestingCount);
}

/// The download is given up, or begins again, if none comes.
void MissionClient::awaitItem(TimePoint now)
{
    m_deadline = now + (kind().isArduPilot() ? kGiveUp : kDownloadStalled);
}

Reason MissionClient::missingItem() const
{
    return reasons::kItemMissing(m_window.firstMissing());
}

void MissionClient::sendItem(const MissionItem &item)
{
    m_furthest = std::max<std::size_t>(m_furthest, item.sequence);
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
    if (m_offerIntegers) {
        auto message = fill(mavlink::MissionItemInt{});
        message.x = toInteger(item.latitude, integerScale(item));
        message.y = toInteger(item.longitude, integerScale(item));
        sendTyped(message);
    } else {
        auto message = fill(mavlink::MissionItem{});
        message.x = static_cast<float>(item.latitude);
        message.y = static_cast<float>(item.longitude);
        sendTyped(message);
    }
}

void MissionClient::finish(TimePoint now, bool ok, Reason reason, bool changeUnanswered)
{
    MissionResult result{m_request, addressing().system, m_transfer, m_type, ok, std::move(reason), changeUnanswered};
    if (ok) {
        if (m_transfer == MissionTransfer::Download)
            sendTyped(mavlink::MissionAck{.type = mavlink::MAV_MISSION_ACCEPTED});
        else if (m_transfer == MissionTransfer::Clear)
            m_items.clear();
        result.remark = std::move(m_remark);
        result.items = std::make_shared<const std::vector<MissionItem>>(std::move(m_items));
        plan().end(now, result.items, m_transfer != MissionTransfer::Download);
    } else {
        const bool mayHaveBegun = m_phase == Phase::Uploading || m_rounds > 0 || changeUnanswered;
        plan().fail(now, m_transfer != MissionTransfer::Download && !m_isComparing && mayHaveBegun);
    }
    m_items.clear();
    m_phase = Phase::Idle;
    m_deadline = kNever;
    m_repetition.stop();
    report(std::move(result));
}

void MissionClient::giveUp(TimePoint now)
{
    if (m_phase == Phase::Downloading)
        return finish(now, false, missingItem());
    const bool isRead = m_phase == Phase::RequestingCount;
    finish(now, false, reasons::kNoAnswer(m_repetition.attempts()), !isRead);
}

} // namespace skyseal::vehicle
