#include "core/experiment/least_squares.h"

#include "core/experiment/statistics.h"

#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr double kDependent = 1e-10; ///< length that is left of a column of length 1

/// A matrix by columns.
using Columns = std::vector<std::vector<double>>;

double product(const std::vector<double> &a, const std::vector<double> &b, std::size_t from)
{
    double out = 0;
    for (std::size_t i = from; i < a.size(); ++i)
        out += a[i] * b[i];
    return out;
}

/// Reflects `target` at the plane that is orthogonal to `normal`, of which the elements from `from` on count.
void reflect(const std::vector<double> &normal, std::size_t from, std::vector<double> &target)
{
    const double factor = 2 * product(normal, target, from) / product(normal, normal, from);
    for (std::size_t i = from; i < target.size(); ++i)
        target[i] -= factor * normal[i];
}

/// Turns the columns into an upper triangular matrix, and `values` with them. False if a column depends on those before.
bool triangulate(Columns &matrix, std::vector<double> &values)
{
    for (std::size_t k = 0; k < matrix.size(); ++k) {
        const double length = std::sqrt(product(matrix[k], matrix[k], k));
        if (!(length > kDependent))
            return false;
        std::vector<double> normal = matrix[k];
        normal[k] += std::copysign(length, normal[k]);
        for (std::size_t column = k; column < matrix.size(); ++column)
            reflect(normal, k, matrix[column]);
        reflect(normal, k, values);
    }
    return true;
}

/// The solution of the triangular equations.
std::vector<double> solved(const Columns &triangle, const std::vector<double> &right)
{
    std::vector<double> out(triangle.size());
    for (std::size_t k = triangle.size(); k-- > 0;) {
        double rest = right[k];
        for (std::size_t column = k + 1; column < triangle.size(); ++column)
            rest -= triangle[column][k] * out[column];
        out[k] = rest / triangle[k][k];
    }
    return out;
}

} // namespace

double LinearFit::halfWidth(std::size_t column) const
{
    return studentQuantile(0.975, degrees) * errors[column];
}

std::optional<LinearFit> leastSquares(std::span<const double> design, std::size_t columns, std::span<const double> values)
{
    const std::size_t rows = values.size();
    if (columns == 0 || rows <= columns || design.size() != rows * columns)
        return std::nullopt;
    Columns matrix(columns, std::vector<double>(rows));
    std::vector<double> lengths(columns), right(values.begin(), values.end());
    for (std::size_t column = 0; column < columns; ++column) {
        for (std::size_t row = 0; row < rows; ++row)
            matrix[column][row] = design[row * columns + column];
        lengths[column] = std::sqrt(product(matrix[column], matrix[column], 0));
        if (!(lengths[column] > 0))
            return std::nullopt;
        for (double &element : matrix[column])
            element /= lengths[column];
    }
    if (!triangulate(matrix, right))
        return std::nullopt;

    LinearFit out;
    out.degrees = static_cast<double>(rows - columns);
    out.deviation = std::sqrt(product(right, right, columns) / out.degrees); // what the columns cannot reach
    out.coefficients = solved(matrix, right);
    std::vector<double> variances(columns); // the diagonal of (R'R)^-1 = R^-1 (R^-1)'
    for (std::size_t k = 0; k < columns; ++k) {
        std::vector<double> unit(columns);
        unit[k] = 1;
        const std::vector<double> inverse = solved(matrix, unit);
        for (std::size_t column = 0; column < columns; ++column)
            variances[column] += inverse[column] * inverse[column];
    }
    for (std::size_t column = 0; column < columns; ++column) {
        out.logDeterminant += 2 * std::log(std::abs(matrix[column][column]) * lengths[column]);
        out.coefficients[column] /= lengths[column];
        out.errors.push_back(out.deviation * std::sqrt(variances[column]) / lengths[column]);
    }
    for (std::size_t row = 0; row < rows; ++row) {
        double fitted = 0;
        for (std::size_t column = 0; column < columns; ++column)
            fitted += out.coefficients[column] * design[row * columns + column];
        out.residuals.push_back(values[row] - fitted);
    }
    return out;
}

} // namespace skyseal::experiment
