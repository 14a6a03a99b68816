#include "core/channel/tunnel_parts.h"

namespace skyseal::channel {

std::optional<MutableByteView> UnfinishedMessage::take(TimePoint now, ByteView payload)
{
    constexpr std::uint8_t kLast = 4, kIndex = 3;
    if (payload.size() <= kPartHead || payload.size() > kTunnelPayload || (payload[0] & ~(kLast | kIndex)) != 0x80)
        return std::nullopt;
    const ByteView data = payload.subspan(kPartHead);
    const std::uint8_t index = payload[0] & kIndex;
    const bool last = payload[0] & kLast;
    // Only the last part may be short.
    if (index >= kMaxParts || (last && index == 0) || (!last && (index + 1u == kMaxParts || data.size() != kPartData)))
        return std::nullopt;

    const auto set = static_cast<std::uint16_t>(payload[1] | payload[2] << 8);
    if (!m_since || set != m_set || now >= *m_since + kKept) {
        m_set = set;
        m_since = now;
        m_present = 0;
        m_count = 0;
        m_delivered = false;
    }
    const auto bit = static_cast<std::uint8_t>(1u << index);
    if (m_delivered || (m_present & bit) || (last && m_count != 0) || (m_count != 0 && index >= m_count))
        return std::nullopt;
    std::copy(data.begin(), data.end(), m_bytes.begin() + static_cast<std::ptrdiff_t>(index * kPartData));
    m_present |= bit;
    if (last) {
        m_count = static_cast<std::uint8_t>(index + 1);
        m_size = index * kPartData + data.size();
    }
    if (m_count == 0 || m_present != (1u << m_count) - 1)
        return std::nullopt;
    m_delivered = true;
    if (m_size <= kTunnelPayload)
        return std::nullopt; // In parts it would be shorter on the wire than as a padded message.
    return MutableByteView(m_bytes).first(m_size);
}

std::optional<MutableByteView> TunnelReader::take(TimePoint now, const Path &from, ByteView payload)
{
    if (payload.empty() || payload.size() > kTunnelPayload)
        return std::nullopt;
    if (isOurs(payload[0])) {
        std::copy(payload.begin(), payload.end(), m_whole.begin());
        return MutableByteView(m_whole).first(payload.size());
    }
    Sender *sender = &m_senders[0];
    for (Sender &candidate : m_senders) {
        if (candidate.path == from && candidate.heard != TimePoint::min()) {
            sender = &candidate;
            break;
        }
        if (candidate.heard < sender->heard)
            sender = &candidate;
    }
    if (sender->path != from || sender->heard == TimePoint::min())
        *sender = {from, now, {}};
    sender->heard = now;
    return sender->message.take(now, payload);
}

} // namespace skyseal::channel
