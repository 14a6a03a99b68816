#include "core/sim/stream_scheduler.h"

#include "core/mavlink/messages.h"

#include <algorithm>
#include <utility>

namespace skyseal::sim {

namespace {

using namespace mavlink;

struct Group
{
    std::uint8_t stream; // MAV_DATA_STREAM
    std::string_view parameter;
};

/// Of the reports of aircraft. No station can request it by REQUEST_DATA_STREAM, not even as one of all.
constexpr std::uint8_t kAircraft = 13;

constexpr std::array<Group, 9> kGroups{{{MAV_DATA_STREAM_RAW_SENSORS, "SR0_RAW_SENS"},
                                        {MAV_DATA_STREAM_EXTENDED_STATUS, "SR0_EXT_STAT"},
                                        {MAV_DATA_STREAM_RC_CHANNELS, "SR0_RC_CHAN"},
                                        {MAV_DATA_STREAM_RAW_CONTROLLER, "SR0_RAW_CTRL"},
                                        {MAV_DATA_STREAM_POSITION, "SR0_POSITION"},
                                        {MAV_DATA_STREAM_EXTRA1, "SR0_EXTRA1"},
                                        {MAV_DATA_STREAM_EXTRA2, "SR0_EXTRA2"},
                                        {MAV_DATA_STREAM_EXTRA3, "SR0_EXTRA3"},
                                        {kAircraft, "SR0_ADSB"}}};

constexpr std::uint8_t kNoGroup = MAV_DATA_STREAM_ALL; // no message is a member of "all"
constexpr std::uint8_t kPx4Only = 255;

struct Member
{
    std::uint32_t message;
    std::uint8_t stream; // MAV_DATA_STREAM, or kNoGroup
    double px4Rate = 0;  // Hz
};

// Grouped as in ArduCopter's GCS_Mavlink.cpp. The rates of PX4 are those of MAVLINK_MODE_NORMAL in its mavlink_main.cpp, of the
// messages that are simulated.
constexpr std::array<Member, 32> kMembers{{
    {Heartbeat::kId, kNoGroup, 1}, // 1 Hz by itself
    {RawImu::kId, MAV_DATA_STREAM_RAW_SENSORS},
    {ScaledImu2::kId, MAV_DATA_STREAM_RAW_SENSORS},
    {ScaledPressure::kId, MAV_DATA_STREAM_RAW_SENSORS},
    {SysStatus::kId, MAV_DATA_STREAM_EXTENDED_STATUS, 1},
    {PowerStatus::kId, MAV_DATA_STREAM_EXTENDED_STATUS},
    {Meminfo::kId, MAV_DATA_STREAM_EXTENDED_STATUS},
    {MissionCurrent::kId, MAV_DATA_STREAM_EXTENDED_STATUS},
    {GpsRawInt::kId, MAV_DATA_STREAM_EXTENDED_STATUS, 1},
    {NavControllerOutput::kId, MAV_DATA_STREAM_EXTENDED_STATUS, 1},
    {PositionTargetGlobalInt::kId, MAV_DATA_STREAM_EXTENDED_STATUS, 1},
    {FenceStatus::kId, MAV_DATA_STREAM_EXTENDED_STATUS},
    {ServoOutputRaw::kId, MAV_DATA_STREAM_RC_CHANNELS, 1},
    {RcChannels::kId, MAV_DATA_STREAM_RC_CHANNELS, 5},
    {GlobalPositionInt::kId, MAV_DATA_STREAM_POSITION, 5},
    {LocalPositionNed::kId, MAV_DATA_STREAM_POSITION, 1},
    {mavlink::Attitude::kId, MAV_DATA_STREAM_EXTRA1, 15},
    {VfrHud::kId, MAV_DATA_STREAM_EXTRA2, 4},
    {Ahrs::kId, MAV_DATA_STREAM_EXTRA3},
    {SystemTime::kId, MAV_DATA_STREAM_EXTRA3},
    {mavlink::Wind::kId, MAV_DATA_STREAM_EXTRA3},
    {BatteryStatus::kId, MAV_DATA_STREAM_EXTRA3, 0.5},
    {EkfStatusReport::kId, MAV_DATA_STREAM_EXTRA3},
    {Vibration::kId, MAV_DATA_STREAM_EXTRA3, 0.1},
    {HomePosition::kId, kNoGroup, 0.5},
    {ExtendedSysState::kId, kNoGroup, 1},
    {AutopilotVersion::kId, kNoGroup},
    {GpsGlobalOrigin::kId, kNoGroup, 0.1},
    {EstimatorStatus::kId, kPx4Only, 0.5},
    {AttitudeTarget::kId, kPx4Only, 2},
    {PositionTargetLocalNed::kId, kPx4Only, 1.5},
    {AdsbVehicle::kId, kAircraft, 5},
}};

std::optional<std::size_t> find(std::uint32_t message)
{
    const auto at = std::find_if(kMembers.begin(), kMembers.end(),
                                 [&](const Member &member) { return member.message == message; });
    return at == kMembers.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - kMembers.begin()));
}

constexpr int kSpread = 28; // parts of a period

Duration period(int rate)
{
    return rate > 0 ? Duration(std::chrono::seconds(1)) / rate : Duration::zero();
}
Duration px4Period(const Member &member)
{
    return member.px4Rate > 0 ? std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / member.px4Rate))
                              : Duration::zero();
}

} // namespace

void StreamScheduler::applyParameters(TimePoint now, const Parameters &parameters)
{
    if (m_revision == parameters.revision())
        return;
    if (!std::exchange(m_started, true))
        setPeriod(0, m_start, std::chrono::seconds(1));
    m_revision = parameters.revision();
    if (m_firmware == Firmware::Px4) { // its rates depend on no parameter
        for (std::size_t i = 1; i < kMembers.size(); ++i) {
            if (!m_slots[i].single && m_slots[i].period != px4Period(kMembers[i]))
                setPeriod(i, now, px4Period(kMembers[i]));
        }
        return;
    }
    for (const Group &group : kGroups) {
        const int rate = parameters.integer(group.parameter);
        m_rates[group.stream] = rate;
        for (std::size_t i = 0; i < kMembers.size(); ++i) {
            if (kMembers[i].stream == group.stream && !m_slots[i].single && m_slots[i].period != period(rate))
                setPeriod(i, now, period(rate));
        }
    }
}

bool StreamScheduler::requestGroup(Parameters &parameters, std::uint8_t stream, int rate)
{
    bool known = false;
    if (parameters.type().isPx4())
        return false; // it knows no groups
    for (const Group &group : kGroups) {
        if (group.stream != kAircraft && (stream == MAV_DATA_STREAM_ALL || stream == group.stream)) {
            const auto index = parameters.find(group.parameter);
            parameters.set(*index, std::min(static_cast<float>(rate), parameters.info(*index).maximum));
            known = true;
        }
    }
    return known;
}

void StreamScheduler::forgetSingles(std::uint8_t stream)
{
    for (std::size_t i = 0; i < kMembers.size(); ++i) {
        if (kMembers[i].stream != kNoGroup && (stream == MAV_DATA_STREAM_ALL || kMembers[i].stream == stream))
            m_slots[i].single = false;
    }
    m_revision = kNoRevision;
}

bool StreamScheduler::setInterval(TimePoint now, std::uint32_t message, Duration interval)
{
    const auto index = streamable(message);
    if (!index)
        return false;
    Slot &slot = m_slots[*index];
    slot.single = interval != Duration::zero();
    if (slot.single) {
        setPeriod(*index, now, std::max(interval, Duration::zero()));
    } else {
        const Member &member = kMembers[*index];
        const int rate = message == Heartbeat::kId ? 1 : m_firmware == Firmware::Px4 ? 0 : m_rates[member.stream];
        setPeriod(*index, now, m_firmware == Firmware::Px4 ? px4Period(member) : period(rate));
    }
    return true;
}

std::optional<Duration> StreamScheduler::interval(std::uint32_t message) const
{
    const auto index = streamable(message);
    return index ? std::optional(m_slots[*index].period) : std::nullopt;
}

std::optional<std::size_t> StreamScheduler::streamable(std::uint32_t message) const
{
    const auto index = find(message);
    const bool other = index && kMembers[*index].stream == kPx4Only && m_firmware != Firmware::Px4;
    return other ? std::nullopt : index;
}

void StreamScheduler::setPeriod(std::size_t index, TimePoint now, Duration period)
{
    constexpr Duration kShortest = std::chrono::milliseconds(1);
    Slot &slot = m_slots[index];
    slot.period = period > Duration::zero() ? std::max(period, kShortest) : Duration::zero();
    if (slot.period == Duration::zero()) {
        slot.due = kNever;
        return;
    }
    // Spread over the period by place in the table, so that not everything leaves in one burst.
    slot.due = now + slot.period * static_cast<int>(index) / kSpread;
}

std::size_t StreamScheduler::earliest() const
{
    const auto at = std::min_element(m_slots.begin(), m_slots.end(),
                                     [](const Slot &a, const Slot &b) { return a.due < b.due; });
    return static_cast<std::size_t>(at - m_slots.begin());
}

std::optional<std::uint32_t> StreamScheduler::pollDue(TimePoint now)
{
    const std::size_t index = earliest();
    Slot &slot = m_slots[index];
    if (slot.due == kNever || slot.due > now)
        return std::nullopt;
    slot.due += slot.period;
    return kMembers[index].message;
}

TimePoint StreamScheduler::nextDeadline() const
{
    return m_slots[earliest()].due;
}

void StreamScheduler::skipTo(TimePoint now)
{
    for (Slot &slot : m_slots) {
        if (slot.due < now)
            slot.due += slot.period * ((now - slot.due) / slot.period + 1);
    }
}

} // namespace skyseal::sim
