#include "core/engine/station/inspector_table.h"

#include <algorithm>

namespace skyseal::engine {

void InspectorTable::setWatching(bool watching)
{
    m_watching = watching;
    if (!watching)
        m_entries.clear();
}

void InspectorTable::note(TimePoint now, const mavlink::Frame &frame)
{
    if (!m_watching)
        return;
    const std::tuple key(frame.systemId(), frame.componentId(), frame.messageId());
    if (m_entries.size() >= kMost && !m_entries.contains(key))
        return;
    Entry &entry = m_entries[key];
    InspectorRow &row = entry.row;
    if (row.count == 0) {
        row.messageId = frame.messageId();
        row.name = frame.info().name;
        row.systemId = frame.systemId();
        row.componentId = frame.componentId();
    }
    ++row.count;
    row.version = static_cast<std::uint8_t>(frame.version());
    row.isSigned = frame.isSigned();
    const ByteView payload = frame.payload();
    row.payloadSize = static_cast<std::uint8_t>(payload.size());
    row.payload.fill(0);
    std::copy(payload.begin(), payload.end(), row.payload.begin());
    entry.newest = now;
    entry.rate.add(now);
}

std::vector<InspectorRow> InspectorTable::rows(TimePoint now) const
{
    std::vector<InspectorRow> out;
    out.reserve(m_entries.size());
    for (const auto &[key, entry] : m_entries) {
        out.push_back(entry.row);
        out.back().rate = entry.rate.perSecond(now);
        out.back().age = seconds(now - entry.newest);
    }
    return out;
}

} // namespace skyseal::engine
