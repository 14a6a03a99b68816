#include "core/sim/stream_scheduler.h"

#include <algorithm>
#include <utility>

namespace skyseal::sim {

namespace {

struct Group
{
    std::uint8_t stream; // MAV_DATA_STREAM
    std::string_view parameter;
};

constexpr std::array<Group, 8> kGroups{{{1, "SR0_RAW_SENS"},
                                        {2, "SR0_EXT_STAT"},
                                        {3, "SR0_RC_CHAN"},
                                        {4, "SR0_RAW_CTRL"},
                                        {6, "SR0_POSITION"},
                                        {10, "SR0_EXTRA1"},
                                        {11, "SR0_EXTRA2"},
                                        {12, "SR0_EXTRA3"}}};

struct Member
{
    std::uint32_t message;
    std::uint8_t stream; // 0: in no group
};

constexpr std::uint32_t kHeartbeat = 0;

// Grouped as in ArduCopter's GCS_Mavlink.cpp.
constexpr std::array<Member, 27> kMembers{{
    {kHeartbeat, 0}, // 1 Hz by itself
    {27, 1},         // RAW_IMU
    {116, 1},        // SCALED_IMU2
    {29, 1},         // SCALED_PRESSURE
    {1, 2},          // SYS_STATUS
    {125, 2},        // POWER_STATUS
    {152, 2},        // MEMINFO
    {42, 2},         // MISSION_CURRENT
    {24, 2},         // GPS_RAW_INT
    {62, 2},         // NAV_CONTROLLER_OUTPUT
    {87, 2},         // POSITION_TARGET_GLOBAL_INT
    {36, 3},         // SERVO_OUTPUT_RAW
    {65, 3},         // RC_CHANNELS
    {33, 6},         // GLOBAL_POSITION_INT
    {32, 6},         // LOCAL_POSITION_NED
    {30, 10},        // ATTITUDE
    {74, 11},        // VFR_HUD
    {163, 12},       // AHRS
    {2, 12},         // SYSTEM_TIME
    {168, 12},       // WIND
    {147, 12},       // BATTERY_STATUS
    {193, 12},       // EKF_STATUS_REPORT
    {241, 12},       // VIBRATION
    {242, 0},        // HOME_POSITION
    {245, 0},        // EXTENDED_SYS_STATE
    {148, 0},        // AUTOPILOT_VERSION
    {49, 0},         // GPS_GLOBAL_ORIGIN
}};

std::optional<std::size_t> find(std::uint32_t message)
{
    const auto at = std::find_if(kMembers.begin(), kMembers.end(),
                                 [&](const Member &member) { return member.message == message; });
    return at == kMembers.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - kMembers.begin()));
}

Duration period(int rate)
{
    return rate > 0 ? Duration(std::chrono::seconds(1)) / rate : Duration::zero();
}

} // namespace

void StreamScheduler::applyParameters(TimePoint now, const Parameters &parameters)
{
    if (m_revision == parameters.revision())
        return;
    if (!std::exchange(m_started, true))
        setPeriod(0, m_start, std::chrono::seconds(1));
    m_revision = parameters.revision();
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
    for (const Group &group : kGroups) {
        if (stream == 0 || stream == group.stream) {
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
        if (kMembers[i].stream != 0 && (stream == 0 || kMembers[i].stream == stream))
            m_slots[i].single = false;
    }
    m_revision = kNoRevision;
}

bool StreamScheduler::setInterval(TimePoint now, std::uint32_t message, Duration interval)
{
    const auto index = find(message);
    if (!index)
        return false;
    Slot &slot = m_slots[*index];
    slot.single = interval != Duration::zero();
    if (slot.single) {
        setPeriod(*index, now, std::max(interval, Duration::zero()));
    } else {
        const int rate = message == kHeartbeat ? 1 : m_rates[kMembers[*index].stream];
        setPeriod(*index, now, period(rate));
    }
    return true;
}

std::optional<Duration> StreamScheduler::interval(std::uint32_t message) const
{
    const auto index = find(message);
    return index ? std::optional(m_slots[*index].period) : std::nullopt;
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
    slot.due = now + slot.period * static_cast<int>(index) / static_cast<int>(kMembers.size());
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
