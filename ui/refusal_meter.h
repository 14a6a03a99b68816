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
    /// Seconds after the beginning of a session in which nothing counts, nor anything before: a vehicle that sent plain MAVLink
    /// until then, as during a measurement, is no impostor of itself.
    static constexpr double kGrace = 2;

    /// Returns how many frames of the event counted. `now` in seconds on any steady clock. The station reports refusals at most
    /// once a second and kind.
    std::uint64_t handleEvent(const engine::Event &event, double now);
    std::uint64_t lastMinute(std::uint8_t systemId, double now) const;

private:
    struct Refusal
    {
        double time;
        std::uint8_t systemId;
        std::uint64_t frames;
    };

    std::deque<Refusal> m_refusals;
    double m_countsFrom = 0;
};

} // namespace skyseal::ui
