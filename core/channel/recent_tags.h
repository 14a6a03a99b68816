// Detects that an end was cloned: a copy of its machine, or a restored snapshot, seals other records under the same keys and
// counters, which breaks the ciphers. Its peer sees two different authentic records with one counter. (The clone itself detects
// it by a report according to which the peer received more than this end sent: Session::handleReport().)
#pragma once

#include "core/base/bytes.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace skyseal::channel {

/// The ends of the tags of the latest records of one epoch and direction.
class RecentTags
{
public:
    static constexpr std::uint32_t kEntries = 64;

    /// Part of a record's tag: its last four bytes. `record` has at least these.
    static std::uint32_t endOf(ByteView record)
    {
        std::uint32_t end = 0;
        std::memcpy(&end, record.last(sizeof end).data(), sizeof end);
        return end;
    }

    /// Remembers an authentic record.
    void note(std::uint32_t counter, std::uint32_t tagEnd) { m_entries[counter % kEntries] = {counter, tagEnd}; }

    /// Returns true if a record with this counter is remembered and had another tag: this one is forged, or of a clone.
    bool contradicts(std::uint32_t counter, std::uint32_t tagEnd) const
    {
        const Entry &entry = m_entries[counter % kEntries];
        return entry.counter == counter && entry.tagEnd != tagEnd;
    }

private:
    struct Entry
    {
        std::uint32_t counter = UINT32_MAX; ///< counters are below 2^24
        std::uint32_t tagEnd = 0;
    };

    std::array<Entry, kEntries> m_entries{};
};

} // namespace skyseal::channel
