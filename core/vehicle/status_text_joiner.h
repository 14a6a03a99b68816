// Joins the chunks of long status texts. MAVLink 2 sends a text of more than 50 characters as several STATUSTEXT messages
// with one id and rising chunk numbers; MAVLink 1 (and id 0) sends each by itself. Chunks of several texts, also of several
// components, arrive in any mixture; routers and second links repeat them and change their order.
// https://mavlink.io/en/messages/common.html#STATUSTEXT
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/enums.h"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::vehicle {

struct JoinedText
{
    std::uint8_t severity = mavlink::MAV_SEVERITY_INFO;
    std::string text;
    std::uint8_t component = 0;
};

/// A text is complete with its last chunk and all before it, or kTimeout after its newest chunk; what is missing then shows
/// as "…".
class StatusTextJoiner
{
public:
    static constexpr Duration kTimeout = std::chrono::seconds(1);
    static constexpr std::size_t kChunkSize = 50;
    static constexpr std::size_t kMostChunks = 32; ///< a text that claims to be longer is cut
    static constexpr std::size_t kMostTexts = 16;  ///< at once; with more of them, the oldest is given as it is

    /// `text` are the characters before the first NUL, at most 50; fewer than 50 end a text. Drain poll() afterwards.
    void handleChunk(TimePoint now, std::uint8_t component, std::uint8_t severity, std::uint16_t id, std::uint8_t chunk,
                     std::string_view text);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    /// The oldest complete text.
    std::optional<JoinedText> poll();

private:
    struct Text
    {
        std::uint8_t component = 0;
        std::uint8_t severity = mavlink::MAV_SEVERITY_INFO;
        std::uint16_t id = 0;
        std::map<std::uint8_t, std::string> chunks = {};
        TimePoint newest{}; ///< when its newest chunk arrived
        bool given = false; ///< kept until its time-out, by which chunks that arrive once more are recognised

        /// All chunks up to the last one are there.
        bool isComplete() const;
    };

    void give(Text &text);

    std::vector<Text> m_texts; ///< in the order in which they began
    std::deque<JoinedText> m_ready;
};

} // namespace skyseal::vehicle
