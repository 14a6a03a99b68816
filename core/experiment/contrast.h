// The comparisons of a sweep that were planned before it began: every arm against the reference, which is plain MAVLink where
// it was measured, and the pairs that a claim of the paper names. Each is a ratio with its 95 % interval (block_model.h).
#pragma once

#include "core/experiment/results.h"

#include <optional>
#include <vector>

namespace skyseal::experiment {

struct Contrast
{
    std::size_t condition = 0, load = 0;
    Metric metric{};
    std::size_t first = 0, second = 0; ///< indices of arms
    bool relative = true;              ///< by logarithms: the second to the first; otherwise the second less the first (shares)
    double estimate = 0;               ///< of the logarithm of the ratio, or of the difference
    double error = 0, degrees = 0;     ///< error NaN without degrees of freedom
    double p = 1;                      ///< two-sided; NaN without a test
    double adjusted = 1;               ///< by Holm's method over the family that the comparison belongs to
    double firstMean = 0, secondMean = 0;
    double step = 0;         ///< resolution of the instrument, in the metric's unit; a difference up to this is not significant
    std::size_t units = 0;   ///< launches that the comparison rests on; blocks, if there was one launch only
    bool ofLaunches = false; ///< false: the interval holds for this one launch of the programs

    /// The ratio, or the difference if not relative.
    double value() const;
    /// Ends of its interval; NaN without one.
    double low(double confidence = 0.95) const;
    double high(double confidence = 0.95) const;
    /// Half of the interval's width in the scale of `estimate`.
    double halfWidth(double confidence = 0.95) const;
    /// In the metric's unit, at the mean of the first.
    double difference() const;

    bool beyondStep() const;
    bool significant() const { return adjusted < 0.05 && beyondStep(); }
    /// The same without the correction, as if nothing else were compared.
    bool significantAlone() const { return p < 0.05 && beyondStep(); }
    /// False if nothing can be said, since there is no test.
    bool known() const;
    /// The first to the second.
    Contrast reversed() const;
};

/// The arm that all others are compared with: plain MAVLink, or the first arm that was run if it is not in the plan.
std::optional<std::size_t> referenceArm(const Plan &plan);

/// Whether arms are compared by this metric under this load. Under all loads but the saturated one the vehicle decides how many
/// packets there are.
bool isCompared(Metric metric, Load load);

/// Those of one metric, condition and load, which are one family of Holm's correction: first each arm against the reference, in
/// the order of the arms, then the other pairs. The repeated arm (A/A) is left out, plain MAVLink where its value is zero by
/// definition, and arms without two values.
std::vector<Contrast> plannedContrasts(const Results &results, std::size_t condition, std::size_t load, Metric metric);

/// An arm and its repetition (A/A), for every condition, load and metric; one family of Holm's correction. Empty without a
/// repeated arm.
std::vector<Contrast> noiseContrasts(const Results &results);

} // namespace skyseal::experiment
