#include "core/vehicle/request_window.h"

#include <algorithm>

namespace skyseal::vehicle {

void RequestWindow::begin()
{
    m_items.clear();
    m_requests.clear();
    m_again.reset();
    m_received = m_end = m_firstMissing = 0;
    m_window = std::min(kFirst, m_most);
    m_progress.reset();
    m_backoff = 1;
}

void RequestWindow::setMost(std::size_t most)
{
    m_most = most;
    m_window = std::min(m_window, most);
}

void RequestWindow::setCount(std::size_t count)
{
    m_items.resize(count);
    m_received = static_cast<std::size_t>(std::ranges::count_if(m_items, &Item::here));
    std::erase_if(m_requests, [count](const Request &request) { return request.index >= count; });
    m_firstMissing = 0;
    m_again.reset();
}

bool RequestWindow::arrived(TimePoint now, std::size_t index)
{
    if (index >= m_items.size() || m_items[index].here)
        return false;
    m_items[index].here = true;
    m_progress = now;
    m_backoff = 1;
    ++m_received;
    const auto request = std::ranges::find(m_requests, index, &Request::index);
    if (request != m_requests.end()) {
        // An item that was asked for again may answer either request: it measures nothing (Karn's algorithm).
        if (m_items[index].attempts == 1)
            measure(now - request->sent);
        std::erase_if(m_requests, [index](const Request &other) { return other.index == index; });
    }
    return true;
}

std::optional<std::size_t> RequestWindow::poll(TimePoint now)
{
    expire(now);
    if (m_again) {
        const std::size_t index = *m_again;
        m_again.reset();
        if (!m_items[index].here)
            return index;
    }
    while (m_firstMissing < m_items.size() && m_items[m_firstMissing].here)
        ++m_firstMissing;
    if (m_requests.size() >= m_window)
        return std::nullopt;
    const auto index = nextMissing();
    if (!index)
        return std::nullopt;
    if (!m_progress)
        m_progress = now;
    m_requests.push_back({*index, now});
    ++m_items[*index].attempts;
    if (m_most > 1 && missing() <= kAskedTwice && m_end >= m_items.size())
        m_again = index;
    return index;
}

TimePoint RequestWindow::nextDeadline() const
{
    if (m_again || (m_requests.size() < m_window && nextMissing()))
        return TimePoint::min();
    return m_requests.empty() ? kNever : m_requests.front().sent + patience();
}

/// How long to wait for an answer.
Duration RequestWindow::patience() const
{
    return std::min(m_rtt.timeout() * m_backoff, RttEstimator::kMostTimeout);
}

/// Requests whose answer is overdue may be made again: more and more slowly while nothing arrives at all, so that a link that
/// is down or much slower than before is not flooded.
void RequestWindow::expire(TimePoint now)
{
    const Duration limit = patience();
    const std::size_t overdue = std::erase_if(m_requests, [&](const Request &request) { return now >= request.sent + limit; });
    if (overdue == 0 || now < *m_progress + kSilentTimeouts * limit)
        return;
    m_backoff = std::min(m_backoff * 2, kMostBackoff);
    m_progress = now;
}

void RequestWindow::measure(Duration roundTrip)
{
    m_rtt.measure(roundTrip);
    if (m_rtt.isGrowing())
        m_window = std::max(m_window - 1, std::min(kLeast, m_most));
    else
        m_window = std::min(m_window + 1, m_most);
}

std::optional<std::size_t> RequestWindow::nextMissing() const
{
    const std::size_t end = std::min(m_end, m_items.size());
    for (std::size_t index = m_firstMissing; index < end; ++index) {
        if (!m_items[index].here && !isAsked(index))
            return index;
    }
    return std::nullopt;
}

std::size_t RequestWindow::firstMissing() const
{
    const auto from = m_items.begin() + static_cast<std::ptrdiff_t>(m_firstMissing);
    return static_cast<std::size_t>(std::find_if(from, m_items.end(), [](const Item &item) { return !item.here; })
                                    - m_items.begin());
}

bool RequestWindow::isAsked(std::size_t index) const
{
    return std::ranges::find(m_requests, index, &Request::index) != m_requests.end();
}

} // namespace skyseal::vehicle
