// Joins the chunks of long status texts. MAVLink 2 sends a text of more than 50 characters as several STATUSTEXT messages
// with one id and rising chunk numbers; MAVLink 1 (and id 0) sends each by itself.
// https://mavlink.io/en/messages/common.html#STATUSTEXT
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/enums.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace skyseal::vehicle {

struct JoinedText
{
    std::uint8_t severity = mavlink::MAV_SEVERITY_INFO;
    std::string text;
    std::uint8_t component = 0;
};

/// One text is under way per component at most; lost chunks show as "…".
class StatusTextJoiner
{
public:
    static constexpr Duration kTimeout = std::chrono::seconds(1);
    static constexpr std::size_t kChunkSize = 50;
    static constexpr std::size_t kMostChunks = 32; ///< a text that claims to be longer is cut

    /// `text` are the characters before the first NUL, at most 50; fewer than 50 end a text. Drain poll() afterwards.
    void handleChunk(TimePoint now, std::uint8_t component, std::uint8_t severity, std::uint16_t id, std::uint8_t chunk,
                     std::string_view text);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const { return m_pending ? m_pending->since + kTimeout : kNever; }

    /// The oldest complete text.
    std::optional<JoinedText> poll();

private:
    struct Pending
    {
        std::uint8_t component = 0;
        std::uint8_t severity = mavlink::MAV_SEVERITY_INFO;
        std::uint16_t id = 0;
        std::uint8_t nextChunk = 0;
        std::string text;
        TimePoint since{};
    };

    void finish();
    void push(JoinedText text);

    std::optional<Pending> m_pending;
    std::array<std::optional<JoinedText>, 2> m_ready; ///< an interrupted text and the one that interrupted it
};

} // namespace skyseal::vehicle
