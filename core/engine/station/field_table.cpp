#include "core/engine/station/field_table.h"

#include <algorithm>

namespace skyseal::engine {

void FieldTable::choose(std::vector<FieldChoice> choices)
{
    if (choices.size() > kMostChoices)
        choices.resize(kMostChoices);
    m_choices = std::move(choices);
    std::erase_if(m_entries,
                  [this](const Entry &entry) { return std::ranges::find(m_choices, entry.reading.choice) == m_choices.end(); });
}

void FieldTable::note(TimePoint now, const mavlink::Frame &frame)
{
    for (const FieldChoice &choice : m_choices) {
        if (choice.messageId != frame.messageId())
            continue;
        auto entry = std::ranges::find_if(m_entries, [&](const Entry &known) {
            const FieldReading &reading = known.reading;
            return reading.choice == choice && reading.systemId == frame.systemId()
                && reading.componentId == frame.componentId();
        });
        if (entry == m_entries.end()) {
            if (m_entries.size() >= kMostReadings)
                return;
            entry = m_entries.insert(entry, {{choice, frame.systemId(), frame.componentId(), {}, 0}, now});
        }
        entry->reading.value = mavlink::fieldValue(frame.payload(), *choice.field, choice.element);
        entry->newest = now;
    }
}

std::vector<FieldReading> FieldTable::readings(TimePoint now) const
{
    std::vector<FieldReading> out;
    out.reserve(m_entries.size());
    for (const Entry &entry : m_entries) {
        out.push_back(entry.reading);
        out.back().age = seconds(now - entry.newest);
    }
    return out;
}

} // namespace skyseal::engine
