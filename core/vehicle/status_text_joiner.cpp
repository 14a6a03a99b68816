#include "core/vehicle/status_text_joiner.h"

#include <utility>

namespace skyseal::vehicle {

namespace {
constexpr std::string_view kGap = "…";
}

void StatusTextJoiner::handleChunk(TimePoint now, std::uint8_t component, std::uint8_t severity, std::uint16_t id,
                                   std::uint8_t chunk, std::string_view text)
{
    const bool sameText = m_pending && id != 0 && m_pending->component == component && m_pending->id == id;
    if (sameText && chunk < m_pending->nextChunk)
        return; // a duplicate
    if (!sameText)
        finish();
    if (id == 0) {
        push({severity, std::string(text), component});
        return;
    }
    if (!m_pending)
        m_pending = Pending{component, severity, id, 0, {}, now};
    if (chunk > m_pending->nextChunk)
        m_pending->text += kGap;
    m_pending->text += text;
    m_pending->nextChunk = static_cast<std::uint8_t>(chunk + 1);
    m_pending->since = now;
    if (text.size() < kChunkSize || m_pending->nextChunk >= kMostChunks)
        finish();
}

void StatusTextJoiner::handleDeadline(TimePoint now)
{
    if (now >= nextDeadline()) {
        m_pending->text += kGap;
        finish();
    }
}

std::optional<JoinedText> StatusTextJoiner::poll()
{
    for (auto &slot : m_ready) {
        if (slot)
            return std::exchange(slot, std::nullopt);
    }
    return std::nullopt;
}

void StatusTextJoiner::finish()
{
    if (!m_pending)
        return;
    push({m_pending->severity, std::move(m_pending->text), m_pending->component});
    m_pending.reset();
}

void StatusTextJoiner::push(JoinedText text)
{
    for (auto &slot : m_ready) {
        if (!slot) {
            slot = std::move(text);
            return;
        }
    }
    m_ready[0] = std::exchange(m_ready[1], std::move(text));
}

} // namespace skyseal::vehicle
