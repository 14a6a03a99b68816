// Status texts of the autopilot that wait to be sent.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace skyseal::sim {

/// Numbered as MAV_SEVERITY.
enum class Severity : std::uint8_t {
    Emergency = mavlink::MAV_SEVERITY_EMERGENCY,
    Alert = mavlink::MAV_SEVERITY_ALERT,
    Critical = mavlink::MAV_SEVERITY_CRITICAL,
    Error = mavlink::MAV_SEVERITY_ERROR,
    Warning = mavlink::MAV_SEVERITY_WARNING,
    Notice = mavlink::MAV_SEVERITY_NOTICE,
    Info = mavlink::MAV_SEVERITY_INFO,
    Debug = mavlink::MAV_SEVERITY_DEBUG
};

struct PendingText
{
    Severity severity = Severity::Info;
    std::string text;
};

class StatusTexts
{
public:
    static constexpr std::size_t kMost = 32;

    /// Drops the oldest text when too many wait.
    void say(Severity severity, std::string text)
    {
        if (m_waiting.size() == kMost)
            m_waiting.pop_front();
        m_waiting.push_back({severity, std::move(text)});
    }

    std::optional<PendingText> take()
    {
        if (m_waiting.empty())
            return std::nullopt;
        PendingText first = std::move(m_waiting.front());
        m_waiting.pop_front();
        return first;
    }

private:
    std::deque<PendingText> m_waiting;
};

} // namespace skyseal::sim
