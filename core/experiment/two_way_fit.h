// The additive model value = row + column + error, by least squares, for any number of values in a cell, none included. Rows
// are what the values share and nobody asks about (a block of runs, a launch); columns are what is compared (the arms).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace skyseal::experiment {

struct TwoWayValue
{
    std::size_t row = 0, column = 0;
    double value = 0;
};

/// The second column less the first.
struct TwoWayContrast
{
    double estimate = 0;
    double error = 0; ///< standard error; NaN without degrees of freedom
};

class TwoWayFit
{
public:
    /// Values must be finite.
    TwoWayFit(std::span<const TwoWayValue> values, std::size_t columns);

    std::size_t columns() const { return m_effects.size(); }
    /// False if the column has no value.
    bool has(std::size_t column) const { return m_counts[column] > 0; }
    /// Two columns can be compared if a chain of shared rows joins them. Same number: comparable.
    std::size_t groupOf(std::size_t column) const { return m_groups[column]; }
    bool comparable(std::size_t first, std::size_t second) const;
    /// Of a column, relative to the first one of its group.
    double effect(std::size_t column) const { return m_effects[column]; }
    /// The two must be comparable.
    TwoWayContrast contrast(std::size_t first, std::size_t second) const;
    /// Of the residuals: values less rows less independent columns.
    double degrees() const { return m_degrees; }
    double residualSquares() const { return m_squares; }

private:
    double &inverse(std::size_t a, std::size_t b) { return m_inverse[a * columns() + b]; }
    double inverse(std::size_t a, std::size_t b) const { return m_inverse[a * columns() + b]; }
    void findGroups(const std::vector<std::vector<double>> &counts);
    void solve(std::vector<double> matrix, std::vector<double> right);

    std::vector<double> m_counts; ///< values of each column
    std::vector<std::size_t> m_groups;
    std::vector<double> m_effects;
    std::vector<double> m_inverse; ///< of the columns' normal equations, the first column of each group left out
    double m_degrees = 0, m_squares = 0;
};

} // namespace skyseal::experiment
