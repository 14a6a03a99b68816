// Linear least squares whose errors have a part that all rows of a group share, such as the runs of one start of the programs:
// value = Σ coefficient × column + group + error, with the group as a random effect. Pure function.
#pragma once

#include "core/experiment/least_squares.h"

namespace skyseal::experiment {

struct GroupedFit
{
    LinearFit fit;             ///< `residuals` with the group's part, `deviation` and `degrees` of the error within groups
    double groupDeviation = 0; ///< standard deviation of the groups' part
    std::size_t groups = 0;    ///< the intercept, which varies between groups, has one degree of freedom less than that
};

/// `design` and `values` as for leastSquares(), the first column being the intercept; `groups`: the group of each row. The two
/// variances by REML (Patterson and Thompson 1971), the coefficients by generalised least squares, which with one effect of
/// groups is least squares of rows less a share of their group's mean (Fuller and Battese 1973). nullopt with fewer than two
/// groups, or with too few rows for the terms and groups.
std::optional<GroupedFit> randomIntercept(std::span<const double> design, std::size_t columns, std::span<const double> values,
                                          std::span<const std::size_t> groups);

} // namespace skyseal::experiment
