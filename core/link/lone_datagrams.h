// Whether the datagrams of a socket arrive one at a time, so that the next one is probably alone as well: recvfrom() then costs
// the system less than recvmmsg(), which looks for another datagram. No clock, no I/O.
#pragma once

#include "core/base/clock.h"

#include <cstddef>

namespace skyseal::link {

class LoneDatagrams
{
public:
    /// Longer than the rest of a burst waits for its next receipt, shorter than the distance of frames at any usual rate.
    static constexpr Duration kApart = std::chrono::microseconds(100);
    /// After this many in a row, the next one is expected alone. The first datagram of a burst is then taken by itself, and the
    /// others are taken together; a series of bursts therefore costs this once.
    static constexpr unsigned kRun = 16;

    bool expected() const { return m_run == kRun; }
    /// `count` datagrams were taken at once.
    void note(TimePoint now, std::size_t count)
    {
        const bool alone = count == 1 && now - m_last >= kApart;
        m_run = !alone ? 0 : m_run < kRun ? m_run + 1 : kRun;
        m_last = now;
    }

private:
    TimePoint m_last{};
    unsigned m_run = 0;
};

} // namespace skyseal::link
