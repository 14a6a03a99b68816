// The rows of the message inspector: each kind of message of each sender, with its newest content and rate. Filled only while
// an inspector is open. I/O thread.
#pragma once

#include "core/engine/station/inspector_row.h"
#include "core/mavlink/frame.h"
#include "core/metrics/rate_meter.h"

#include <map>
#include <tuple>

namespace skyseal::engine {

class InspectorTable
{
public:
    void setWatching(bool watching);
    void note(TimePoint now, const mavlink::Frame &frame);
    /// Without those of systems that are gone.
    std::vector<InspectorRow> rows(TimePoint now) const;

    /// Greatest number of rows; senders can be forged on a plain link.
    static constexpr std::size_t kMost = 2048;
    /// A system that has sent nothing for so long is gone.
    static constexpr Duration kGoneAfter = std::chrono::seconds(30);
    static constexpr Duration kRateWindow = std::chrono::seconds(2);

private:
    struct Entry
    {
        InspectorRow row;
        TimePoint first{}, previous{}, newest{};
        metrics::RateMeter rate{kRateWindow};
    };

    static double rateOf(const Entry &entry, TimePoint now);

    bool m_watching = false;
    std::map<std::tuple<std::uint8_t, std::uint8_t, std::uint32_t>, Entry> m_entries;
};

} // namespace skyseal::engine
