#include "core/base/reason.h"

namespace skyseal {

std::string Reason::text() const
{
    return text([](const Sentence &sentence) { return std::string(sentence.english()); });
}

std::string Reason::text(Translate translate) const
{
    if (!m_sentence)
        return m_text;
    const std::string pattern = translate(*m_sentence);
    std::string out;
    for (std::size_t at = 0; at < pattern.size(); ++at) {
        const bool isMarker = pattern[at] == '%' && at + 1 < pattern.size() && pattern[at + 1] >= '1' && pattern[at + 1] <= '9';
        const std::size_t index = isMarker ? static_cast<std::size_t>(pattern[at + 1] - '1') : m_values.size();
        if (index < m_values.size()) {
            out += m_values[index].text(translate);
            ++at;
        } else {
            out += pattern[at];
        }
    }
    return out;
}

} // namespace skyseal
