// Schedule of telemetry: of ArduPilot the groups of REQUEST_DATA_STREAM, whose rates are the SR0_ parameters, of PX4 the rates
// at which it streams without being asked; and single messages with an interval of their own. Rates are exact in the long run.
#pragma once

#include "core/base/clock.h"
#include "core/sim/parameters.h"

#include <array>
#include <optional>

namespace skyseal::sim {

class StreamScheduler
{
public:
    StreamScheduler(TimePoint start, Firmware firmware) : m_start(start), m_firmware(firmware) {}

    /// Applies changed SR0_ parameters.
    void applyParameters(TimePoint now, const Parameters &parameters);

    /// REQUEST_DATA_STREAM: sets the rate of a group (MAV_DATA_STREAM; 0 = all) in Hz through its parameter. False for an
    /// unknown group.
    static bool requestGroup(Parameters &parameters, std::uint8_t stream, int rate);
    /// Drops single intervals of the group's messages: a later request overrides an earlier one.
    void forgetSingles(std::uint8_t stream);

    /// Interval of one message: positive is a period, zero goes back to its group's rate, negative switches it off.
    /// False for a message that cannot be streamed.
    bool setInterval(TimePoint now, std::uint32_t message, Duration interval);
    /// The interval in force; zero when the message is not streamed, nullopt when it cannot be.
    std::optional<Duration> interval(std::uint32_t message) const;

    /// The message that is due by `now`, one a call, in the order of their times; nullopt when none is left.
    std::optional<std::uint32_t> pollDue(TimePoint now);
    TimePoint nextDeadline() const;
    /// After a long stop of the clock: messages that were due meanwhile are skipped, not sent in a burst.
    void skipTo(TimePoint now);

private:
    static constexpr std::size_t kMessages = 32;
    static constexpr unsigned kNoRevision = ~0u; ///< look at the parameters again, changed or not

    struct Slot
    {
        Duration period{}; ///< zero: not streamed
        bool single = false;
        TimePoint due = kNever;
    };
    void setPeriod(std::size_t index, TimePoint now, Duration period);
    std::size_t earliest() const;
    /// Index in the table, if this firmware has the message.
    std::optional<std::size_t> streamable(std::uint32_t message) const;

    TimePoint m_start;
    const Firmware m_firmware;
    std::array<Slot, kMessages> m_slots{};
    std::array<int, 14> m_rates{}; ///< Hz per MAV_DATA_STREAM, and of the aircraft
    unsigned m_revision = kNoRevision;
    bool m_started = false;
};

} // namespace skyseal::sim
