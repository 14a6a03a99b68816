// The newest values of the chosen fields, one for each sender. Nothing else is decoded, and without a choice nothing at all.
// I/O thread.
#pragma once

#include "core/base/clock.h"
#include "core/engine/station/field_reading.h"
#include "core/mavlink/frame.h"

#include <vector>

namespace skyseal::engine {

class FieldTable
{
public:
    /// Replaces the choice. Readings of fields that stay chosen are kept. Only the first kMostChoices count.
    void choose(std::vector<FieldChoice> choices);
    void note(TimePoint now, const mavlink::Frame &frame);
    /// In the order in which they were heard first.
    std::vector<FieldReading> readings(TimePoint now) const;

    static constexpr std::size_t kMostChoices = 64;
    /// Greatest number of readings; senders can be forged on a plain link.
    static constexpr std::size_t kMostReadings = 1024;

private:
    struct Entry
    {
        FieldReading reading;
        TimePoint newest{};
    };

    std::vector<FieldChoice> m_choices;
    std::vector<Entry> m_entries;
};

} // namespace skyseal::engine
