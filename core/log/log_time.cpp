#include "core/log/log_time.h"

namespace skyseal::tlog {

Duration LogTime::note(std::optional<WallTime> time)
{
    if (!time)
        return m_position;
    if (!m_first)
        m_first = time;
    else if (const auto step = *time - *m_last; step > step.zero() && step <= kLongestStep && step <= kLongest - m_position)
        m_position += step;
    m_last = time;
    return m_position;
}

} // namespace skyseal::tlog
