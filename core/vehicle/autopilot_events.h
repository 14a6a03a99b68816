// Events of the autopilot (EVENT, https://mavlink.io/en/services/events.html), by which today's PX4 tells what the status
// texts of other autopilots tell. The words of an event are in metadata of the vehicle, which are not read: events are named
// by number.
//
// An arming check report is a series of events between two summaries. PX4 sends one whenever its outcome changes; each of its
// events names the modes that cannot be armed for it. Other events that PX4 also sends as a status text, which then ends with
// a tab for older stations, are left to that text.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/messages.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class AutopilotEvents
{
public:
    /// How far apart an event and its status text may be.
    static constexpr Duration kTextDelay = std::chrono::seconds(1);
    /// Of one report, and of those that wait for their text; later ones are dropped.
    static constexpr std::size_t kMost = 64;

    struct Text
    {
        std::uint8_t severity = 0; ///< MAV_SEVERITY
        std::string text;
    };

    void handle(TimePoint now, const mavlink::Event &event);
    /// A status text that ends with a tab has come.
    void handleText(TimePoint now, std::uint8_t severity);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    /// The next event, of at least a warning, that came without a status text.
    std::optional<Text> poll();

    /// What fails in the last report for this mode of PX4. Call it only while the checks do not pass.
    std::vector<std::string> failuresFor(std::uint32_t customMode) const;

private:
    struct Failure
    {
        std::uint32_t modes = 0; ///< bits of px4NavigationState()
        std::string text;
    };
    struct Said
    {
        TimePoint time{};
        std::uint8_t severity = 0;
        std::uint32_t id = 0; ///< 0 for a text
    };

    bool isRepeated(std::uint16_t sequence);
    void handleReport(const mavlink::Event &event, std::uint8_t level);

    std::optional<std::uint16_t> m_sequence; ///< of the newest event
    bool m_inReport = false;
    std::vector<Failure> m_incoming; ///< of the report under way
    std::vector<Failure> m_failures; ///< of the last whole one
    std::deque<Said> m_events;       ///< that wait for their text
    std::deque<Said> m_texts;        ///< that wait for their event
    std::deque<Text> m_ready;
};

} // namespace skyseal::vehicle
