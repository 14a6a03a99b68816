// When a load that follows the answers of the other end has found its rate. Times and counters go in; no clock. Plain object.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace skyseal::experiment {

class LoadSettling
{
public:
    static constexpr double kGrowth = 0.05; ///< a rate that grows by less from one window to the next is settled
    static constexpr double kFull = 0.95;   ///< share of a line's rate that is a full line

    /// `lineRate`: bytes per second that the line carries; nullopt: without a limit, or unknown.
    explicit LoadSettling(std::optional<double> lineRate = std::nullopt) : m_lineRate(lineRate) {}

    /// Counters so far. `time`: seconds; `roundTrip`: seconds at present, NaN while unknown. The rate is compared over windows
    /// of two round trips, in which a load reacts to the answers, and of a third of a second at least.
    void note(double time, std::uint64_t bytes, double roundTrip);
    /// With a line: once it was full for two windows. Without one: once there was traffic, and its rate did not grow in two
    /// windows one after the other.
    bool settled() const;

private:
    std::optional<double> m_lineRate;
    double m_begin = std::numeric_limits<double>::quiet_NaN(); ///< of the window, seconds
    std::uint64_t m_bytes = 0;                                 ///< at its beginning
    std::vector<double> m_rates;                               ///< of the windows, bytes per second
};

} // namespace skyseal::experiment
