#include "core/vehicle/autopilot_events.h"

#include "core/mavlink/px4_mode.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace skyseal::vehicle {

namespace {

constexpr std::uint32_t kEventNumber = 0xffffff; // of an id; the component that defines the event is above

/// The number of an event of PX4: FNV-1a of its name.
constexpr std::uint32_t eventNumber(std::string_view name)
{
    std::uint32_t hash = 2166136261u;
    for (const char letter : name)
        hash = (hash ^ static_cast<std::uint8_t>(letter)) * 16777619u;
    return hash & kEventNumber;
}

constexpr std::uint32_t kReportBegins = eventNumber("commander_arming_check_summary");
constexpr std::uint32_t kReportEnds = eventNumber("commander_health_summary");

/// The level for stations, with the values of MAV_SEVERITY; greater ones are not for people.
std::uint8_t levelOf(const mavlink::Event &event)
{
    return event.log_levels & 0x0f;
}

std::string_view levelName(std::uint8_t level)
{
    constexpr std::string_view kNames[] = {"emergency", "alert", "critical", "error", "warning", "notice", "info", "debug"};
    return level < std::size(kNames) ? kNames[level] : std::string_view();
}

std::string eventText(std::uint32_t id, std::uint8_t level)
{
    return "event " + std::to_string(id & kEventNumber) + " of the autopilot (" + std::string(levelName(level)) + ")";
}

} // namespace

void AutopilotEvents::handle(TimePoint now, const mavlink::Event &event)
{
    if (isRepeated(event.sequence))
        return;
    const std::uint32_t number = event.id & kEventNumber;
    const std::uint8_t level = levelOf(event);
    if (number == kReportBegins) {
        m_inReport = true;
        m_incoming.clear();
    } else if (number == kReportEnds) {
        if (m_inReport)
            m_failures = std::move(m_incoming);
        m_inReport = false;
        m_incoming.clear();
    } else if (m_inReport) {
        handleReport(event, level);
    } else if (level <= mavlink::MAV_SEVERITY_INFO) {
        const auto text = std::ranges::find(m_texts, level, &Said::severity);
        if (text != m_texts.end())
            m_texts.erase(text);
        else if (m_events.size() < kMost)
            m_events.push_back({now, level, event.id});
    }
}

void AutopilotEvents::handleText(TimePoint now, std::uint8_t severity)
{
    const auto event = std::ranges::find(m_events, severity, &Said::severity);
    if (event != m_events.end())
        m_events.erase(event);
    else if (m_texts.size() < kMost)
        m_texts.push_back({now, severity});
}

void AutopilotEvents::handleDeadline(TimePoint now)
{
    const auto isDue = [now](const Said &one) { return now >= one.time + kTextDelay; };
    for (const Said &event : m_events) {
        if (isDue(event) && event.severity <= mavlink::MAV_SEVERITY_WARNING)
            m_ready.push_back({event.severity, eventText(event.id, event.severity)});
    }
    std::erase_if(m_events, isDue);
    std::erase_if(m_texts, isDue);
}

TimePoint AutopilotEvents::nextDeadline() const
{
    TimePoint next = kNever;
    for (const auto *said : {&m_events, &m_texts}) {
        if (!said->empty())
            next = std::min(next, said->front().time + kTextDelay);
    }
    return next;
}

std::optional<AutopilotEvents::Text> AutopilotEvents::poll()
{
    if (m_ready.empty())
        return std::nullopt;
    Text text = std::move(m_ready.front());
    m_ready.pop_front();
    return text;
}

std::vector<std::string> AutopilotEvents::failuresFor(std::uint32_t customMode) const
{
    const auto state = mavlink::px4NavigationState(customMode);
    std::vector<std::string> out;
    for (const Failure &failure : m_failures) {
        if (!state || (failure.modes & 1u << *state))
            out.push_back(failure.text);
    }
    return out;
}

/// A router or a second link repeats events; numbers that jump back far are those of an autopilot that has started again.
bool AutopilotEvents::isRepeated(std::uint16_t sequence)
{
    constexpr std::int16_t kFar = -1000;
    const auto ahead = static_cast<std::int16_t>(sequence - m_sequence.value_or(static_cast<std::uint16_t>(sequence - 1)));
    if (ahead <= 0 && ahead > kFar)
        return true;
    m_sequence = sequence;
    return false;
}

/// The first argument of each event in a report is the set of modes that it concerns (PX4 1.19).
void AutopilotEvents::handleReport(const mavlink::Event &event, std::uint8_t level)
{
    constexpr std::uint32_t kAllModes = 0xffffffff;
    Failure failure{.text = eventText(event.id, level)};
    std::memcpy(&failure.modes, event.arguments.data(), sizeof failure.modes);
    // Less than an error, and of all modes, is a remark about the health and keeps none from arming.
    const bool blocks = level <= mavlink::MAV_SEVERITY_ERROR || failure.modes != kAllModes;
    if (blocks && level <= mavlink::MAV_SEVERITY_DEBUG && m_incoming.size() < kMost)
        m_incoming.push_back(std::move(failure));
}

} // namespace skyseal::vehicle
