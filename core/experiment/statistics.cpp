#include "core/experiment/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace skyseal::experiment {

namespace {

constexpr double kFence = 1.5;
constexpr std::size_t kLeastForFences = 5;

/// The continued fraction of the incomplete beta function (DLMF 8.17.22) by Lentz's method.
double betaFraction(double a, double b, double x)
{
    constexpr double kTiny = 1e-300;
    const auto unlessZero = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
    double c = 1;
    double d = 1 / unlessZero(1 - (a + b) * x / (a + 1));
    double result = d;
    for (int m = 1; m < 500; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1 / unlessZero(1 + even * d);
        c = unlessZero(1 + even / c);
        result *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / unlessZero(1 + odd * d);
        c = unlessZero(1 + odd / c);
        const double step = d * c;
        result *= step;
        if (std::abs(step - 1) < 1e-15)
            break;
    }
    return result;
}

double logGamma(double x)
{
    int sign = 0;
    return ::lgamma_r(x, &sign); // std::lgamma writes a global
}

/// Regularised incomplete beta function I_x(a, b).
double incompleteBeta(double a, double b, double x)
{
    if (x <= 0)
        return 0;
    if (x >= 1)
        return 1;
    const double front = std::exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * std::log(x) + b * std::log1p(-x));
    // The fraction converges quickly on this side of the mean only.
    return x < (a + 1) / (a + b + 2) ? front * betaFraction(a, b, x) / a : 1 - front * betaFraction(b, a, 1 - x) / b;
}

std::vector<double> finiteOf(std::span<const double> samples)
{
    std::vector<double> out;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(out), [](double value) { return std::isfinite(value); });
    return out;
}

double meanOf(const std::vector<double> &values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Unbiased; in two passes, since counters of bytes differ by little from a large mean.
double varianceOf(const std::vector<double> &values, double mean)
{
    double sum = 0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return sum / static_cast<double>(values.size() - 1);
}

double sortedQuantile(const std::vector<double> &sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

} // namespace

double studentTwoSided(double t, double degrees)
{
    if (std::isinf(t))
        return 0;
    return incompleteBeta(degrees / 2, 0.5, degrees / (degrees + t * t));
}

double studentQuantile(double share, double degrees)
{
    if (share == 0.5)
        return 0;
    const double tails = 2 * std::min(share, 1 - share);
    double low = 0, high = 1;
    while (studentTwoSided(high, degrees) > tails && high < 1e300)
        high *= 2;
    for (int i = 0; i < 200 && low < high; ++i) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            break;
        (studentTwoSided(middle, degrees) > tails ? low : high) = middle;
    }
    return share < 0.5 ? -high : high;
}

double quantile(std::span<const double> samples, double share)
{
    std::vector<double> sorted = finiteOf(samples);
    if (sorted.empty())
        return kNaN;
    std::sort(sorted.begin(), sorted.end());
    return sortedQuantile(sorted, std::clamp(share, 0.0, 1.0));
}

Summary summarise(std::span<const double> samples)
{
    std::vector<double> values = finiteOf(samples);
    Summary out;
    out.count = values.size();
    if (values.empty()) {
        out.mean = out.deviation = out.halfWidth = out.min = out.max = out.median = kNaN;
        return out;
    }
    const auto n = static_cast<double>(values.size());
    out.mean = meanOf(values);
    out.deviation = values.size() > 1 ? std::sqrt(varianceOf(values, out.mean)) : kNaN;
    out.halfWidth = values.size() > 1 ? studentQuantile(0.975, n - 1) * out.deviation / std::sqrt(n) : kNaN;
    std::sort(values.begin(), values.end());
    out.min = values.front();
    out.max = values.back();
    out.median = sortedQuantile(values, 0.5);
    if (values.size() < kLeastForFences)
        return out;
    const double lower = sortedQuantile(values, 0.25), upper = sortedQuantile(values, 0.75);
    const double reach = kFence * (upper - lower);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (std::isfinite(samples[i]) && (samples[i] < lower - reach || samples[i] > upper + reach))
            out.outliers.push_back(i);
    }
    return out;
}

double boundOfNone(double trials)
{
    return trials > 0 ? -std::expm1(std::log(0.05) / trials) : 1;
}

std::vector<double> holm(std::span<const double> p)
{
    std::vector<double> out(p.begin(), p.end());
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!std::isnan(p[i]))
            order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
    double highest = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        highest = std::max(highest, std::min(1.0, static_cast<double>(order.size() - i) * p[order[i]]));
        out[order[i]] = highest;
    }
    return out;
}

} // namespace skyseal::experiment
