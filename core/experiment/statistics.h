// Statistics of repeated measurements: mean, deviation and 95 % confidence interval of a few samples, outliers, and Holm's
// step-down correction of many tests (Holm 1979). No sample is dropped.
//
// Intervals assume roughly normal samples of unknown variance, as means over a few seconds are (Student's t).
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace skyseal::experiment {

/// A value that was not measured, or cannot be computed.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The value that a Student t variable with `degrees` (> 0, need not be whole) falls below with probability `share`
/// (0 < share < 1). Exact to about 12 digits.
double studentQuantile(double share, double degrees);
/// Probability that such a variable lies at least |t| away from 0.
double studentTwoSided(double t, double degrees);

/// The value below which `share` (0…1) of the samples lie, interpolated between neighbours (definition 7 of Hyndman and Fan
/// 1996, the usual one of spreadsheets); NaN without samples.
double quantile(std::span<const double> samples, double share);

/// One group of samples. Without samples all values are NaN; with a single sample deviation and interval are NaN.
struct Summary
{
    std::size_t count = 0;
    double mean = 0;
    double deviation = 0; ///< of the samples (n − 1)
    double halfWidth = 0; ///< of the 95 % confidence interval: mean ± halfWidth
    /// Range of the quantity: the interval is cut off there.
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
    double min = 0, max = 0, median = 0;
    /// Indices of samples more than 1.5 interquartile ranges outside the quartiles (Tukey's fences); empty below five
    /// samples, where the fences are meaningless. Outliers are included in all values above.
    std::vector<std::size_t> outliers;

    double low() const { return mean - halfWidth < least ? least : mean - halfWidth; }
    double high() const { return mean + halfWidth > most ? most : mean + halfWidth; }
};

/// Samples that are not finite could not be measured and are left out.
Summary summarise(std::span<const double> samples);

/// Upper 95 % bound of the probability of an event that occurred in none of `trials` independent trials: 1 − 0.05^(1/n), about
/// 3/n (Hanley and Lippman-Hand 1983); 1 without trials.
double boundOfNone(double trials);

/// Corrects p values by Holm's method, so that the probability of any false positive among all of them is that of a single
/// test. Same order as given; NaN (no test) stays NaN.
std::vector<double> holm(std::span<const double> p);

} // namespace skyseal::experiment
