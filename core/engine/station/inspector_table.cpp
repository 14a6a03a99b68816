#include "core/engine/station/inspector_table.h"

#include <algorithm>
#include <array>
#include <utility>

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
        entry.first = now;
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
    entry.previous = std::exchange(entry.newest, now);
    entry.rate.add(now);
}

/// Messages a second. The intervals between messages count, not the messages: one more of them begins and ends a time.
double InspectorTable::rateOf(const Entry &entry, TimePoint now)
{
    constexpr Duration kLeast = kRateWindow / 4; // two messages at once are no stream
    constexpr double kFew = 3;
    if (entry.row.count < 2)
        return 0;
    if (now - entry.first < kRateWindow) {
        const auto intervals = static_cast<std::int64_t>(entry.row.count - 1);
        const Duration span = entry.newest - entry.first;
        const Duration elapsed = std::max({span, now - entry.first - span / intervals, kLeast});
        return static_cast<double>(intervals) / seconds(elapsed);
    }
    const double inWindow = entry.rate.perSecond(now);
    if (inWindow * seconds(kRateWindow) > kFew)
        return inWindow;
    return 1 / seconds(std::max({entry.newest - entry.previous, now - entry.newest, kLeast}));
}

std::vector<InspectorRow> InspectorTable::rows(TimePoint now) const
{
    std::vector<InspectorRow> out;
    out.reserve(m_entries.size());
    std::array<TimePoint, 256> heard{}; // the newest message of each system
    for (const auto &[key, entry] : m_entries)
        heard[entry.row.systemId] = std::max(heard[entry.row.systemId], entry.newest);
    for (const auto &[key, entry] : m_entries) {
        if (now - heard[entry.row.systemId] > kGoneAfter)
            continue;
        out.push_back(entry.row);
        out.back().rate = rateOf(entry, now);
        out.back().age = seconds(now - entry.newest);
    }
    return out;
}

} // namespace skyseal::engine
