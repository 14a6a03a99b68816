// Linear least squares: value = Σ coefficient × column + error, with the standard errors of the coefficients. Pure function.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace skyseal::experiment {

struct LinearFit
{
    std::vector<double> coefficients; ///< of each column
    std::vector<double> errors;       ///< their standard errors, for errors of the values of one unknown variance
    std::vector<double> residuals;    ///< value less fitted value, in the order of the rows
    double degrees = 0;               ///< rows less columns
    double deviation = 0;             ///< of the residuals, by `degrees`
    double logDeterminant = 0;        ///< of the design's product with itself

    /// Half width of the 95 % interval of a coefficient (Student's t).
    double halfWidth(std::size_t column) const;
};

/// `design`: row by row, `columns` numbers each; all numbers finite. An intercept is a column of ones. nullopt without more
/// rows than columns, or if a column is (to ten digits) a combination of those before it. By Householder's QR decomposition of
/// the columns scaled to one length (Golub and Van Loan, Matrix Computations, 5.3).
std::optional<LinearFit> leastSquares(std::span<const double> design, std::size_t columns, std::span<const double> values);

} // namespace skyseal::experiment
