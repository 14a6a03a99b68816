#include "core/experiment/random_effects.h"

#include "core/experiment/statistics.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

struct Weighted
{
    double sum = 0, mean = 0, squares = 0; ///< of the weights; weighted; of the distances from the mean
    double deviance = 0;                   ///< −2 log of the restricted likelihood, without constants
};

Weighted weightedBy(std::span<const MachineEffect> machines, double variance)
{
    Weighted out;
    for (const MachineEffect &one : machines) {
        const double weight = 1 / (one.error * one.error + variance);
        out.sum += weight;
        out.mean += weight * one.estimate;
        out.deviance -= std::log(weight);
    }
    out.mean /= out.sum;
    for (const MachineEffect &one : machines)
        out.squares += (one.estimate - out.mean) * (one.estimate - out.mean) / (one.error * one.error + variance);
    out.deviance += std::log(out.sum) + out.squares;
    return out;
}

/// The least deviance: a grid finds its neighbourhood, the golden section the place.
double remlVariance(std::span<const MachineEffect> machines)
{
    constexpr int kGrid = 400, kSections = 120;
    double least = machines.front().estimate, most = least;
    for (const MachineEffect &one : machines) {
        least = std::min(least, one.estimate);
        most = std::max(most, one.estimate);
    }
    const double end = (most - least) * (most - least) * 4; // beyond any variance of these values
    const auto deviance = [&](double variance) { return weightedBy(machines, variance).deviance; };
    const auto place = [&](int i) { return end * std::pow(static_cast<double>(i) / kGrid, 3); }; // denser at zero
    int best = 0;
    for (int i = 1; i <= kGrid; ++i)
        best = deviance(place(i)) < deviance(place(best)) ? i : best;
    double low = place(std::max(best - 1, 0)), high = place(std::min(best + 1, kGrid));
    const double golden = (std::sqrt(5.0) - 1) / 2;
    for (int i = 0; i < kSections; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (deviance(a) < deviance(b) ? high : low) = deviance(a) < deviance(b) ? b : a;
    }
    const double found = (low + high) / 2;
    return deviance(0) <= deviance(found) ? 0 : found;
}

} // namespace

std::optional<RandomEffects> pooled(std::span<const MachineEffect> machines)
{
    if (machines.size() < kLeastMachines)
        return std::nullopt;
    RandomEffects out;
    out.variance = remlVariance(machines);
    const Weighted fitted = weightedBy(machines, out.variance);
    const auto degrees = static_cast<double>(machines.size() - 1);
    out.mean = fitted.mean;
    out.error = std::sqrt(std::max(1.0, fitted.squares / degrees) / fitted.sum);
    const double t = studentQuantile(0.975, degrees);
    out.low = out.mean - t * out.error;
    out.high = out.mean + t * out.error;
    const double wide = t * std::sqrt(out.variance + out.error * out.error);
    out.predictionLow = out.mean - wide;
    out.predictionHigh = out.mean + wide;
    return out;
}

} // namespace skyseal::experiment
