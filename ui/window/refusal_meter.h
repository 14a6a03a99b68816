// Counts, for each vehicle, the refused frames that claimed to be it, over the last minute. They belong to no session, so that
// no session counts them.
#pragma once

#include "core/engine/station/event.h"

#include <cstdint>
#include <deque>

namespace skyseal::ui {

class RefusalMeter
{
public:
    static constexpr double kWindow = 60; ///< seconds

    /// `now` in seconds on any steady clock. The station reports refusals at most once a second and kind.
    void handleEvent(const engine::Event &event, double now);
    std::uint64_t lastMinute(std::uint8_t systemId, double now) const;

private:
    struct Refusal
    {
        double time;
        std::uint8_t systemId;
        std::uint64_t frames;
    };

    std::deque<Refusal> m_refusals;
};

} // namespace skyseal::ui
