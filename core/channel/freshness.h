// Limits of the delay of a record whose frames may command (PROTOCOL.md, section 6.1).
#pragma once

#include "core/base/clock.h"

#include <cstdint>
#include <optional>

namespace skyseal::channel {

/// The receiver's judgement of an authentic record. Only frames of a fresh record may command or update a present value. Those
/// of other records may still make read-only requests; these records count as stale.
enum class Freshness : std::uint8_t {
    Fresh,
    Overtaken, ///< a newer record arrived FreshnessLimits::overtaken before it, or earlier
    TooOld,    ///< not provably sent within FreshnessLimits::age; judged by the agent alone
    AfterClose ///< the station had closed the session; judged by the agent alone
};

/// Set at the agent. A station judges only whether a record was overtaken, by the default limit.
struct FreshnessLimits
{
    static constexpr Duration kLeastOvertaken = std::chrono::milliseconds(200);
    static constexpr Duration kMostOvertaken = std::chrono::seconds(10);
    static constexpr Duration kLeastAge = std::chrono::milliseconds(500);
    static constexpr Duration kMostAge = std::chrono::seconds(60);

    Duration overtaken = std::chrono::seconds(1);
    std::optional<Duration> age = std::chrono::seconds(5); ///< nullopt: no limit
};

/// The judgements of an agent, for the station (PROTOCOL.md, section 7).
struct FreshnessReport
{
    /// The agent has no bound on the age: a clock has stepped, or no report of the station arrived for long.
    static constexpr std::uint64_t kUnknownAge = UINT64_MAX;

    std::uint64_t stale = 0;                 ///< records with frames that were not fresh
    std::uint64_t ageMicroseconds = 0;       ///< greatest possible age of the newest record with frames, or kUnknownAge
    std::uint64_t overtakenMilliseconds = 0; ///< the limits
    std::uint64_t limitMilliseconds = 0;     ///< 0: none

    bool isAgeKnown() const { return ageMicroseconds != kUnknownAge; }
};

} // namespace skyseal::channel
