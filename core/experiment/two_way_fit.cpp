#include "core/experiment/two_way_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace skyseal::experiment {

TwoWayFit::TwoWayFit(std::span<const TwoWayValue> values, std::size_t columns)
    : m_counts(columns), m_groups(columns), m_effects(columns), m_inverse(columns * columns)
{
    std::map<std::size_t, std::size_t> rows; // numbered from zero
    for (const TwoWayValue &one : values)
        rows.emplace(one.row, rows.size());
    std::vector<std::vector<double>> counts(rows.size(), std::vector<double>(columns));
    std::vector<double> rowSums(rows.size()), rowCounts(rows.size()), right(columns);
    for (const TwoWayValue &one : values) {
        const std::size_t row = rows[one.row];
        ++counts[row][one.column];
        ++rowCounts[row];
        ++m_counts[one.column];
        rowSums[row] += one.value;
        right[one.column] += one.value;
    }
    findGroups(counts);
    // The rows are eliminated from the normal equations, which leaves one equation for each column.
    std::vector<double> matrix(columns * columns);
    for (std::size_t a = 0; a < columns; ++a) {
        matrix[a * columns + a] = m_counts[a];
        for (std::size_t row = 0; row < rows.size(); ++row) {
            right[a] -= counts[row][a] * rowSums[row] / rowCounts[row];
            for (std::size_t b = 0; b < columns; ++b)
                matrix[a * columns + b] -= counts[row][a] * counts[row][b] / rowCounts[row];
        }
    }
    solve(std::move(matrix), std::move(right));
    std::vector<double> rowEffects(rows.size());
    for (const TwoWayValue &one : values)
        rowEffects[rows[one.row]] += (one.value - m_effects[one.column]) / rowCounts[rows[one.row]];
    for (const TwoWayValue &one : values) {
        const double off = one.value - m_effects[one.column] - rowEffects[rows[one.row]];
        m_squares += off * off;
    }
    double independent = 0; // columns, less one for each group
    for (std::size_t column = 0; column < columns; ++column)
        independent += has(column) && m_groups[column] != column;
    m_degrees = static_cast<double>(values.size()) - static_cast<double>(rows.size()) - independent;
}

void TwoWayFit::findGroups(const std::vector<std::vector<double>> &counts)
{
    for (std::size_t column = 0; column < columns(); ++column)
        m_groups[column] = column;
    for (bool changed = true; changed;) {
        changed = false;
        for (const std::vector<double> &row : counts) {
            std::size_t least = columns();
            for (std::size_t column = 0; column < columns(); ++column)
                least = row[column] > 0 ? std::min(least, m_groups[column]) : least;
            for (std::size_t column = 0; column < columns(); ++column) {
                if (row[column] > 0 && m_groups[column] != least) {
                    m_groups[column] = least;
                    changed = true;
                }
            }
        }
    }
}

/// Gauss and Jordan over the columns that are free. The equations of a group without its first column are positive definite, so
/// that no pivoting is needed.
void TwoWayFit::solve(std::vector<double> matrix, std::vector<double> right)
{
    const std::size_t n = columns();
    const auto isFree = [this](std::size_t column) { return has(column) && m_groups[column] != column; };
    for (std::size_t column = 0; column < n; ++column)
        inverse(column, column) = isFree(column) ? 1 : 0;
    for (std::size_t pivot = 0; pivot < n; ++pivot) {
        if (!isFree(pivot))
            continue;
        const double scale = matrix[pivot * n + pivot];
        for (std::size_t b = 0; b < n; ++b) {
            matrix[pivot * n + b] /= scale;
            inverse(pivot, b) /= scale;
        }
        for (std::size_t a = 0; a < n; ++a) {
            const double factor = matrix[a * n + pivot];
            if (a == pivot || !isFree(a) || factor == 0)
                continue;
            for (std::size_t b = 0; b < n; ++b) {
                matrix[a * n + b] -= factor * matrix[pivot * n + b];
                inverse(a, b) -= factor * inverse(pivot, b);
            }
        }
    }
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b)
            m_effects[a] += inverse(a, b) * (isFree(b) ? right[b] : 0);
    }
}

bool TwoWayFit::comparable(std::size_t first, std::size_t second) const
{
    return has(first) && has(second) && m_groups[first] == m_groups[second];
}

TwoWayContrast TwoWayFit::contrast(std::size_t first, std::size_t second) const
{
    TwoWayContrast out;
    out.estimate = m_effects[second] - m_effects[first];
    const double spread = inverse(first, first) + inverse(second, second) - 2 * inverse(first, second);
    out.error = m_degrees > 0 ? std::sqrt(m_squares / m_degrees * spread) : std::numeric_limits<double>::quiet_NaN();
    return out;
}

} // namespace skyseal::experiment
