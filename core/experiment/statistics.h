// Statistics of repeated measurements: mean, deviation and 95 % confidence interval of a few samples, outliers, and significant
// differences between groups. No sample is dropped.
//
// Intervals and tests assume roughly normal samples of unknown variance, as means over a few seconds are: Student's t for
// one group, Welch's unequal-variances t for two (Welch 1947), Holm's step-down correction for many pairs (Holm 1979).
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace skyseal::experiment {

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

/// Tests whether two groups have different means.
///
/// There is no test (NaN) if a group has fewer than two samples, or if neither group varies and one has fewer than five: a
/// count that was the same two or three times may still vary by one, and the test would rule that out.
struct WelchTest
{
    double difference = 0;                                     ///< mean of the second less that of the first
    double t = std::numeric_limits<double>::quiet_NaN();       ///< NaN without a test; infinite if neither group varies
    double degrees = std::numeric_limits<double>::quiet_NaN(); ///< Welch–Satterthwaite; NaN without a test
    double p = std::numeric_limits<double>::quiet_NaN();       ///< two-sided; NaN without a test
    double error = 0;                                          ///< standard error of the difference

    /// Half width of the confidence interval of the difference, for 0 < `confidence` < 1; infinite without a test. If the whole
    /// 90 % interval lies within a margin, the groups are equivalent within that margin by two one-sided tests at 5 %
    /// (Schuirmann 1987).
    double halfWidth(double confidence) const;
};
WelchTest welch(std::span<const double> first, std::span<const double> second);

/// A straight line through residuals, whose groups' means were taken from them: least squares, and the test of Student's t
/// whether its slope is zero.
struct Trend
{
    double slope = std::numeric_limits<double>::quiet_NaN(); ///< of the residual, for each step of the place
    double p = std::numeric_limits<double>::quiet_NaN();     ///< two-sided; NaN without a test
};
/// `groups`: how many means were taken from the residuals; each takes a degree of freedom. There is no test with none left, or
/// if all places are the same.
Trend trendOf(std::span<const double> places, std::span<const double> residuals, std::size_t groups);

/// Corrects p values by Holm's method, so that the probability of any false positive among all of them is that of a single
/// test. Same order as given; NaN (no test) stays NaN.
std::vector<double> holm(std::span<const double> p);

/// The comparison of one pair of groups.
struct Comparison
{
    std::size_t first = 0, second = 0; ///< indices of the groups
    WelchTest test;
    double adjusted = 1; ///< p after Holm's correction over all pairs
    double step = 0;     ///< resolution of the instrument; a difference up to this is not significant

    bool beyondStep() const { return std::abs(test.difference) > step; }
    bool significant() const { return adjusted < 0.05 && beyondStep(); }
    /// The same without the correction, as if no other pair were compared.
    bool significantAlone() const { return test.p < 0.05 && beyondStep(); }
    /// False if nothing can be said, since there is no test.
    bool known() const { return !std::isnan(test.p) || !beyondStep(); }
};

/// Compares every pair of groups with at least two samples each, with a common correction.
std::vector<Comparison> compareAll(std::span<const std::vector<double>> groups);

} // namespace skyseal::experiment
