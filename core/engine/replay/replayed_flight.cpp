#include "core/engine/replay/replayed_flight.h"

#include "core/engine/station/snapshot.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

/// Position 0 as a time for the vehicles; their clock has no meaningful zero.
constexpr TimePoint kBeginning{std::chrono::hours(1)};
constexpr Duration kSampleEvery = std::chrono::milliseconds(250); // as a station
/// Nothing more happens after so much silence: every vehicle is lost. A gap of days costs no time.
constexpr Duration kQuietAfter = std::chrono::seconds(10);
/// Deadlines are handled at least this far apart, as by a timer of the system.
constexpr Duration kTimerStep = std::chrono::milliseconds(1);

constexpr LinkId kLink{1};

} // namespace

ReplayedFlight::ReplayedFlight(std::istream &input, Notify notify)
    : m_reader(input, mavlink::Dialect::builtin()), m_notify(std::move(notify)), m_fleet(m_config)
{}

bool ReplayedFlight::advance(Duration to, std::size_t most)
{
    if (to < m_position)
        return true;
    while (m_next || readNext()) {
        if (!passTime(std::min(m_next->at, to), most))
            return false;
        if (m_next->at > to) {
            m_position = to;
            return true;
        }
        if (most-- == 0)
            return false;
        take(*m_next);
        m_next.reset();
    }
    m_over = true;
    m_position = m_frameAt;
    return true;
}

std::optional<Duration> ReplayedFlight::afterSilence() const
{
    if (!m_next || m_position - m_frameAt < tlog::LogTime::kLongestWait)
        return std::nullopt;
    return m_next->at;
}

/// Damaged spots are counted; frames of unknown messages are not for the vehicles, but time passes.
bool ReplayedFlight::readNext()
{
    while (const auto item = m_reader.next()) {
        if (item->bytes.empty()) {
            ++m_damaged;
            continue;
        }
        m_next = NextEntry{*item, m_log.note(item->time)};
        return true;
    }
    return false;
}

void ReplayedFlight::take(const NextEntry &entry)
{
    m_position = m_frameAt = entry.at;
    m_nextSample = std::max(m_nextSample, entry.at - entry.at % kSampleEvery); // none in the silence before
    if (entry.item.time)
        m_wall = entry.item.time;
    ++m_frames;
    m_bytes += entry.item.bytes.size();
    if (!entry.item.frame)
        return;
    m_hasFrame = true;
    const mavlink::Frame &frame = *entry.item.frame;
    if (frame.systemId() == m_config.systemId && frame.componentId() == m_config.componentId)
        return; // the station's own, which is recorded as well
    const TimePoint now = kBeginning + entry.at;
    if (auto found = m_fleet.take(now, m_wall.value_or(WallTime{}), {kLink, {}}, frame, std::nullopt)) {
        found->recorded = true;
        m_notify(*found);
    }
    if (vehicle::Vehicle *vehicle = m_fleet.find(frame.systemId()))
        drain(*vehicle);
}

/// The readings and deadlines up to and including `until`; returns false if they are more than `most`, from which they are
/// taken. A reading costs about as much as an entry for each vehicle.
bool ReplayedFlight::passTime(Duration until, std::size_t &most)
{
    const Duration last = std::min(until, m_frameAt + kQuietAfter);
    for (Duration next = nextDeadline(); next <= last; next = nextDeadline()) {
        const std::size_t cost = 1 + m_fleet.vehicles().all().size();
        if (most < cost)
            return false;
        most -= cost;
        const TimePoint now = kBeginning + next;
        m_deadlineAt = next;
        m_fleet.vehicles().handleDeadline(now);
        if (next >= m_nextSample) {
            m_fleet.sample(now, m_notify);
            noteTracks(now, next);
            m_nextSample += kSampleEvery;
        }
        for (auto &[systemId, vehicle] : m_fleet.vehicles().all())
            drain(vehicle);
    }
    return true;
}

void ReplayedFlight::noteTracks(TimePoint now, Duration at)
{
    for (const auto &[systemId, vehicle] : m_fleet.vehicles().all()) {
        const vehicle::VehicleState &state = vehicle.current();
        if (vehicle.isLost(now)) {
            m_flown.interrupt(systemId);
        } else if (state.position.known()) {
            VehicleSnapshot watched;
            m_fleet.watches().describe(now, systemId, watched);
            m_flown.note(systemId,
                         {.at = at,
                          .latitude = state.position.latitude,
                          .longitude = state.position.longitude,
                          .quality = static_cast<float>(100 - watched.lossPercent),
                          .altitude = static_cast<float>(state.altitudeRelative),
                          .speed = static_cast<float>(state.groundSpeed)});
        }
    }
}

Duration ReplayedFlight::nextDeadline() const
{
    const TimePoint vehicles = m_fleet.vehicles().nextDeadline();
    const TimePoint next = std::min(kBeginning + m_nextSample, vehicles);
    return std::max({next < kBeginning ? Duration::zero() : next - kBeginning, m_deadlineAt + kTimerStep, m_frameAt});
}

void ReplayedFlight::drain(vehicle::Vehicle &vehicle)
{
    while (vehicle.pollOutgoing()) {}
    Fleet::publishEvents(vehicle, false, m_notify);
}

void ReplayedFlight::describe(Snapshot &out, LinkSnapshot link) const
{
    const TimePoint now = kBeginning + m_position;
    for (const auto &[systemId, vehicle] : m_fleet.vehicles().all())
        out.vehicles.push_back(m_fleet.describe(now, vehicle));
    out.inspector = m_fleet.inspector().rows(now);
    out.fields = m_fleet.fields().readings(now);
    out.mavlink = m_fleet.totals();
    out.mavlink.badCrc = m_damaged;
    link.id = kLink;
    link.rxBytes = m_bytes;
    link.rxDatagrams = m_frames;
    link.badCrc = m_damaged;
    out.links.push_back(std::move(link));
    out.security = securityOf(out);
}

} // namespace skyseal::engine
