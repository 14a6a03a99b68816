// One ratio of several machines: what a further machine would show, besides what these did. Machines differ, so each has a true
// ratio of its own around a common mean (random effects).
#pragma once

#include <optional>
#include <span>

namespace skyseal::experiment {

struct MachineEffect
{
    double estimate = 0; ///< logarithm of a ratio
    double error = 0;    ///< its standard error, above 0
};

struct RandomEffects
{
    double variance = 0; ///< between machines, by restricted maximum likelihood (REML)
    double mean = 0;
    double error = 0;         ///< by Hartung and Knapp (2001); not below the one without their factor (Röver et al. 2015)
    double low = 0, high = 0; ///< 95 % interval of the mean
    double predictionLow = 0, predictionHigh = 0; ///< where a further machine lies, at 95 %
};

/// With fewer machines the variance between them is unknown, and each stands alone.
inline constexpr std::size_t kLeastMachines = 3;

/// nullopt with fewer than kLeastMachines.
std::optional<RandomEffects> pooled(std::span<const MachineEffect> machines);

} // namespace skyseal::experiment
