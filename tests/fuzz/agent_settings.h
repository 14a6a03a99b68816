// The settings of an agent that is fuzzed, from bytes of the input.
#pragma once

#include "core/engine/agent/agent_config.h"
#include "tests/fuzz/simulated_host.h"

#include <iterator>
#include <vector>

namespace skyseal::test {

/// Bits 3 and 4 select T, bits 5 and 6 T2.
inline channel::FreshnessLimits limitsOf(std::uint8_t choice)
{
    using channel::FreshnessLimits;
    using namespace std::chrono_literals;
    const Duration overtaken[] = {1s, FreshnessLimits::kLeastOvertaken, FreshnessLimits::kMostOvertaken, 1s};
    const std::optional<Duration> age[] = {5s, FreshnessLimits::kLeastAge, FreshnessLimits::kMostAge, std::nullopt};
    return {overtaken[choice >> 3 & 3], age[choice >> 5 & 3]};
}

/// The carrier of the first ground link, and one of eight sets of links. An agent that listens does so for datagrams.
inline std::vector<engine::GroundLink> groundsOf(std::uint8_t choice)
{
    const auto calling = [](Carrier carrier) {
        const bool stream = carrier == Carrier::Serial;
        return engine::GroundLink{SimulatedHost::url(stream ? "tcpin:14550" : "udpout:192.0.2.1:14550"), carrier};
    };
    const engine::GroundLink first = calling(static_cast<Carrier>(1 + choice % 3)),
                             other = calling(static_cast<Carrier>(1 + (choice + 1) % 3)),
                             listening{SimulatedHost::url("udpin:14556"), Carrier::Datagram};
    const std::vector<engine::GroundLink> sets[] = {{first},
                                                    {listening},
                                                    {first, first},
                                                    {first, listening},
                                                    {first, other},
                                                    {listening, first, other},
                                                    {listening, listening},
                                                    {first, other, first, listening}};
    return sets[choice / 3 % std::size(sets)];
}

} // namespace skyseal::test
