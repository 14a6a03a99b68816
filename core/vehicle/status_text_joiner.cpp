#include "core/vehicle/status_text_joiner.h"

#include <algorithm>
#include <utility>

namespace skyseal::vehicle {

namespace {

constexpr std::string_view kGap = "…";

/// Whether a text ends with this chunk.
bool isLast(std::uint8_t number, std::string_view chunk)
{
    return chunk.size() < StatusTextJoiner::kChunkSize || number + 1u >= StatusTextJoiner::kMostChunks;
}

} // namespace

void StatusTextJoiner::handleChunk(TimePoint now, std::uint8_t component, std::uint8_t severity, std::uint16_t id,
                                   std::uint8_t chunk, std::string_view text)
{
    if (id == 0) {
        m_ready.push_back({severity, std::string(text), component});
        return;
    }
    if (chunk >= kMostChunks)
        return;
    const auto same = [&](const Text &one) { return one.component == component && one.id == id; };
    auto at = std::ranges::find_if(m_texts, same);
    if (at != m_texts.end()) {
        const auto known = at->chunks.find(chunk);
        if (known != at->chunks.end() && known->second == text)
            return;                                   // a repetition
        if (known != at->chunks.end() || at->given) { // the component counts its texts anew
            give(*at);
            m_texts.erase(at);
            at = m_texts.end();
        }
    }
    if (at == m_texts.end()) {
        if (m_texts.size() == kMostTexts) {
            give(m_texts.front());
            m_texts.erase(m_texts.begin());
        }
        at = m_texts.insert(m_texts.end(), Text{.component = component, .severity = severity, .id = id});
    }
    at->chunks.emplace(chunk, text);
    at->newest = now;
    if (at->isComplete())
        give(*at);
}

void StatusTextJoiner::handleDeadline(TimePoint now)
{
    for (Text &text : m_texts) {
        if (now >= text.newest + kTimeout)
            give(text);
    }
    std::erase_if(m_texts, [now](const Text &one) { return now >= one.newest + kTimeout; });
}

TimePoint StatusTextJoiner::nextDeadline() const
{
    TimePoint next = kNever;
    for (const Text &text : m_texts)
        next = std::min(next, text.newest + kTimeout);
    return next;
}

std::optional<JoinedText> StatusTextJoiner::poll()
{
    if (m_ready.empty())
        return std::nullopt;
    JoinedText text = std::move(m_ready.front());
    m_ready.pop_front();
    return text;
}

bool StatusTextJoiner::Text::isComplete() const
{
    const auto &[number, chunk] = *chunks.rbegin();
    return isLast(number, chunk) && chunks.size() == number + 1u;
}

/// Puts the chunks together, unless that was done.
void StatusTextJoiner::give(Text &text)
{
    if (std::exchange(text.given, true))
        return;
    std::string joined;
    std::uint8_t next = 0;
    for (const auto &[number, chunk] : text.chunks) {
        if (number != next)
            joined += kGap;
        joined += chunk;
        next = static_cast<std::uint8_t>(number + 1);
    }
    const auto &[number, chunk] = *text.chunks.rbegin();
    if (!isLast(number, chunk))
        joined += kGap;
    m_ready.push_back({text.severity, std::move(joined), text.component});
}

} // namespace skyseal::vehicle
