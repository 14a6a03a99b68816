#include "core/vehicle/parameter_list.h"

#include <algorithm>

namespace skyseal::vehicle {

void ParameterList::begin(TimePoint now, Duration patience, TimePoint request)
{
    m_window.begin();
    m_reached = 0;
    m_refused.clear();
    m_refusal = {};
    m_interval = m_variation = Duration::zero();
    m_patience = patience;
    m_giveUp = now + patience;
    m_requestDue = request;
}

void ParameterList::arrived(TimePoint now, std::uint16_t index, std::uint16_t count)
{
    if (m_window.count() != count) { // a write can make further parameters visible; those received before still count
        m_window.setCount(count);
        std::erase_if(m_refused, [count](std::uint16_t refused) { return refused >= count; });
    }
    const bool isNew = m_window.arrived(now, index);
    if (!isReading())
        return;
    if (m_window.isComplete())
        return end();
    if (isNew)
        m_giveUp = now + m_patience;
    if (index >= m_reached) {
        noteInterval(now);
        m_reached = index + std::size_t(1);
        m_requestDue = now
            + (m_interval == Duration::zero() ? kListTimeout : std::max(m_interval + m_variation * 4, kLeastPause));
        m_window.openUpTo(m_reached > kReordered ? m_reached - kReordered : 0);
    }
}

void ParameterList::refused(TimePoint now, std::uint16_t index, const Reason &reason)
{
    if (!isReading() || !m_window.isAsked(index) || !m_window.arrived(now, index))
        return;
    m_refused.push_back(index);
    m_refusal = reason;
    if (m_window.isComplete())
        end();
}

void ParameterList::handleDeadline(TimePoint now)
{
    if (now >= m_giveUp)
        end();
}

std::optional<int> ParameterList::poll(TimePoint now)
{
    if (!isReading())
        return std::nullopt;
    if (now >= m_requestDue) {
        if (m_reached == 0) {
            m_requestDue = now + kListTimeout;
            return kWhole;
        }
        m_requestDue = kNever;
        m_window.openUpTo(m_window.count());
    }
    if (const auto index = m_window.poll(now))
        return static_cast<int>(*index);
    return std::nullopt;
}

TimePoint ParameterList::nextDeadline() const
{
    return isReading() ? std::min({m_requestDue, m_giveUp, m_window.nextDeadline()}) : kNever;
}

/// Of the list, not of the answers to single requests.
void ParameterList::noteInterval(TimePoint now)
{
    const Duration interval = m_reached > 0 ? now - m_latest : Duration::zero();
    m_latest = now;
    if (m_interval == Duration::zero()) {
        m_interval = interval;
        m_variation = interval / 2;
    } else {
        const Duration difference = interval > m_interval ? interval - m_interval : m_interval - interval;
        m_variation += (difference - m_variation) / 4;
        m_interval += (interval - m_interval) / 8;
    }
}

} // namespace skyseal::vehicle
