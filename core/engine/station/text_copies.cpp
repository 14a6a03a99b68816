#include "core/engine/station/text_copies.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

/// MAVLink 2 leaves out zeros at the end, MAVLink 1 does not.
ByteView withoutZeros(ByteView payload)
{
    while (!payload.empty() && payload.back() == 0)
        payload = payload.first(payload.size() - 1);
    return payload;
}

} // namespace

bool TextCopies::isCopy(TimePoint now, const Path &from, const mavlink::Frame &text)
{
    const ByteView whole = withoutZeros(text.payload());
    const ByteView payload = whole.first(std::min(whole.size(), kLongest));
    for (Text &known : m_texts) {
        if (known.at == TimePoint::min() || now - known.at > kWithin || known.system != text.systemId()
            || known.component != text.componentId()
            || !std::ranges::equal(payload, ByteView(known.payload.data(), known.size)))
            continue;
        const auto paths = std::span(known.heardFrom).first(known.paths);
        if (std::ranges::any_of(paths, [&from](const Path &path) { return path.sharesPlace(from); }))
            continue; // repeated; the copies of the repetition have an entry of their own
        if (known.paths < kPaths)
            known.heardFrom[known.paths++] = from;
        return true;
    }
    Text &fresh = m_texts[m_next];
    m_next = (m_next + 1) % kTexts;
    fresh.at = now;
    fresh.system = text.systemId();
    fresh.component = text.componentId();
    fresh.size = payload.size();
    std::ranges::copy(payload, fresh.payload.begin());
    fresh.heardFrom[0] = from;
    fresh.paths = 1;
    return false;
}

} // namespace skyseal::engine
