// Counts, for each vehicle, the refused frames that claimed to be it. They belong to no session, so that no session counts
// them. Whether an attack lasts is judged by the last minute; the number shown counts since the link came up, so that it
// never goes down.
#pragma once

#include "core/engine/station/event.h"

#include <cstdint>
#include <deque>
#include <map>

namespace skyseal::engine {
struct SessionSnapshot;
} // namespace skyseal::engine

namespace skyseal::ui {

struct ViewState;

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
    /// Since the last session began, or since the start.
    std::uint64_t total(std::uint8_t systemId) const;
    /// Writes the counts of its vehicle into a view of the live picture.
    void mark(ViewState &view, double now) const;
    /// The vehicles of which a frame was refused since then.
    const std::map<std::uint8_t, std::uint64_t> &totals() const { return m_totals; }

private:
    struct Refusal
    {
        double time;
        std::uint8_t systemId;
        std::uint64_t frames;
    };

    std::deque<Refusal> m_refusals;
    std::map<std::uint8_t, std::uint64_t> m_totals; ///< by system ID
    double m_countsFrom = 0;
};

/// Frames that a session has refused since it came up, of each kind of attack that lasts; 0 of the others. A few repeated
/// records alone are no attack, see engine::isAttacked().
struct RefusedFrames
{
    std::uint64_t forged = 0, replayed = 0;

    std::uint64_t all() const { return forged + replayed; }
};
/// `outside`: whether frames outside the session claim to be its vehicle at present; they are not counted here.
RefusedFrames refusedFrames(const engine::SessionSnapshot &session, bool outside);

} // namespace skyseal::ui
