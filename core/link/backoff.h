// Delay before the next retry: doubles from the first to the longest delay.
#pragma once

#include "core/base/clock.h"

#include <algorithm>

namespace skyseal::link {

class Backoff
{
public:
    Backoff(Duration first, Duration longest) : m_first(first), m_longest(longest), m_next(first) {}

    Duration next()
    {
        const Duration out = m_next;
        m_next = std::min(m_next * 2, m_longest);
        return out;
    }

    void reset() { m_next = m_first; }

private:
    Duration m_first;
    Duration m_longest;
    Duration m_next;
};

} // namespace skyseal::link
