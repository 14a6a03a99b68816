#include "core/experiment/random_intercept.h"

#include <cmath>
#include <limits>
#include <map>

namespace skyseal::experiment {

namespace {

class Rows
{
public:
    Rows(std::span<const double> design, std::size_t columns, std::span<const double> values,
         std::span<const std::size_t> groups)
        : m_design(design), m_columns(columns), m_values(values), m_groups(groups)
    {
        for (std::size_t row = 0; row < values.size(); ++row) {
            std::vector<double> &sums = m_sums.try_emplace(groups[row], columns + 2).first->second;
            for (std::size_t column = 0; column < columns; ++column)
                sums[column] += design[row * columns + column];
            sums[columns] += values[row];
            ++sums[columns + 1];
        }
    }

    std::size_t groups() const { return m_sums.size(); }

    /// Of the rows less the share of their group's mean that makes their errors independent, where the variance of the groups
    /// is `ratio` times that of the error.
    std::optional<LinearFit> fitted(double ratio) const
    {
        std::vector<double> design(m_design.begin(), m_design.end()), values(m_values.begin(), m_values.end());
        for (std::size_t row = 0; row < values.size(); ++row) {
            const std::vector<double> &sums = m_sums.at(m_groups[row]);
            const double count = sums[m_columns + 1], share = 1 - 1 / std::sqrt(1 + count * ratio);
            for (std::size_t column = 0; column < m_columns; ++column)
                design[row * m_columns + column] -= share * sums[column] / count;
            values[row] -= share * sums[m_columns] / count;
        }
        return leastSquares(design, m_columns, values);
    }

    /// Twice the negative logarithm of the restricted likelihood, but for a constant.
    double misfit(double ratio) const
    {
        const auto fit = fitted(ratio);
        if (!fit)
            return std::numeric_limits<double>::infinity();
        double out = fit->degrees * std::log(fit->deviation * fit->deviation) + fit->logDeterminant;
        for (const auto &[group, sums] : m_sums)
            out += std::log1p(sums[m_columns + 1] * ratio);
        return out;
    }

private:
    std::span<const double> m_design;
    std::size_t m_columns;
    std::span<const double> m_values;
    std::span<const std::size_t> m_groups;
    std::map<std::size_t, std::vector<double>> m_sums; ///< of each column, of the values, and the number of rows
};

/// The ratio of the two variances that fits best: a search over its orders of magnitude, then by golden section.
double bestRatio(const Rows &rows)
{
    constexpr double kLeast = -12, kMost = 12, kStep = 0.5; // natural logarithms
    double best = kLeast, least = std::numeric_limits<double>::infinity();
    for (double at = kLeast; at <= kMost; at += kStep) {
        if (const double misfit = rows.misfit(std::exp(at)); misfit < least) {
            least = misfit;
            best = at;
        }
    }
    constexpr double kGolden = 0.618033988749895;
    double low = best - kStep, high = best + kStep;
    while (high - low > 1e-9) {
        const double one = high - kGolden * (high - low), two = low + kGolden * (high - low);
        if (rows.misfit(std::exp(one)) < rows.misfit(std::exp(two)))
            high = two;
        else
            low = one;
    }
    const double ratio = std::exp((low + high) / 2);
    return rows.misfit(0) <= rows.misfit(ratio) ? 0 : ratio;
}

} // namespace

std::optional<GroupedFit> randomIntercept(std::span<const double> design, std::size_t columns, std::span<const double> values,
                                          std::span<const std::size_t> groups)
{
    const Rows rows(design, columns, values, groups);
    if (rows.groups() < 2 || values.size() <= columns - 1 + rows.groups())
        return std::nullopt;
    const double ratio = bestRatio(rows);
    auto fit = rows.fitted(ratio);
    if (!fit)
        return std::nullopt;
    GroupedFit out;
    out.fit = std::move(*fit);
    out.groupDeviation = out.fit.deviation * std::sqrt(ratio);
    out.groups = rows.groups();
    out.fit.degrees = static_cast<double>(values.size() - rows.groups() - (columns - 1));
    for (std::size_t row = 0; row < values.size(); ++row) {
        out.fit.residuals[row] = values[row];
        for (std::size_t column = 0; column < columns; ++column)
            out.fit.residuals[row] -= out.fit.coefficients[column] * design[row * columns + column];
    }
    return out;
}

} // namespace skyseal::experiment
