// What repeated measurements say and what they do not: mean, deviation and 95 % confidence interval of a few samples, which
// of them lie far from the others, and which differences between groups are more than chance. Nothing is ever dropped.
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

/// One group of samples. What cannot be said is NaN: all of it without samples, deviation and interval with only one.
struct Summary
{
    std::size_t count = 0;
    double mean = 0;
    double deviation = 0; ///< of the samples (n − 1)
    double halfWidth = 0; ///< of the 95 % confidence interval: mean ± halfWidth
    /// What the mean can be: the interval ends there.
    double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
    double min = 0, max = 0, median = 0;
    /// Indices of samples more than 1.5 interquartile ranges outside the quartiles (Tukey's fences); empty below five
    /// samples, where the fences mean nothing. They are counted in all of the above.
    std::vector<std::size_t> outliers;

    double low() const { return mean - halfWidth < least ? least : mean - halfWidth; }
    double high() const { return mean + halfWidth > most ? most : mean + halfWidth; }
};

/// Samples that are not finite are left out: they stand for "could not be measured".
Summary summarise(std::span<const double> samples);

/// What the share of something may be at most (95 %) that was seen in none of `trials`, each on its own: 1 − 0.05^(1/n), about
/// 3/n (Hanley and Lippman-Hand 1983); 1 without any trial.
double boundOfNone(double trials);

/// Whether two groups have different means.
///
/// It cannot be said, and there is no test, of fewer than two samples in a group, nor where neither group varies and one has fewer
/// than five: a count that came out alike two or three times may well vary by one, and the test would take that for certain.
struct WelchTest
{
    double difference = 0;                               ///< mean of the second less that of the first
    double t = std::numeric_limits<double>::quiet_NaN(); ///< NaN when it cannot be said; infinite where neither group varies
    double degrees = std::numeric_limits<double>::quiet_NaN(); ///< Welch–Satterthwaite; NaN when it cannot be said
    double p = std::numeric_limits<double>::quiet_NaN();       ///< two-sided; NaN when it cannot be said
    double error = 0;                                          ///< standard error of the difference

    /// Half of the difference's confidence interval, for 0 < `confidence` < 1; infinite when it cannot be said. Where all of the
    /// 90 % interval lies within a margin, two one-sided tests at 5 % say that the groups are alike but for the margin
    /// (Schuirmann 1987).
    double halfWidth(double confidence) const;
};
WelchTest welch(std::span<const double> first, std::span<const double> second);

/// The p values as Holm's method raises them, so that among all of them together the chance of one false alarm stays what a
/// single one claims. Same order as given; NaN is no test, and stays.
std::vector<double> holm(std::span<const double> p);

/// A statement about one pair of groups.
struct Comparison
{
    std::size_t first = 0, second = 0; ///< indices of the groups
    WelchTest test;
    double adjusted = 1; ///< p after Holm's correction over all pairs
    double step = 0;     ///< a difference up to this is within what the instrument can tell apart, and so is none

    bool beyondStep() const { return std::abs(test.difference) > step; }
    bool significant() const { return adjusted < 0.05 && beyondStep(); }
    /// The same by its own p, as if no other pair were compared.
    bool significantAlone() const { return test.p < 0.05 && beyondStep(); }
    /// False where whether they differ cannot be said, as there is no test.
    bool known() const { return !std::isnan(test.p) || !beyondStep(); }
};

/// Every pair of groups that can be compared (two samples in each), corrected together.
std::vector<Comparison> compareAll(std::span<const std::vector<double>> groups);

} // namespace skyseal::experiment
