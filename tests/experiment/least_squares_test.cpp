// Least squares against numbers that others computed.
#include "core/experiment/least_squares.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>
#include <numeric>

using namespace skyseal::experiment;

namespace {

bool isNear(double value, double expected, double relative)
{
    return std::abs(value - expected) <= relative * std::abs(expected);
}

/// Longley's data (J. W. Longley 1967) of NIST's Statistical Reference Datasets, "higher" difficulty: total employment, then an
/// intercept and six columns that nearly depend on each other.
constexpr double kLongley[16][8] = {
    {60323, 1, 83.0, 234289, 2356, 1590, 107608, 1947},  {61122, 1, 88.5, 259426, 2325, 1456, 108632, 1948},
    {60171, 1, 88.2, 258054, 3682, 1616, 109773, 1949},  {61187, 1, 89.5, 284599, 3351, 1650, 110929, 1950},
    {63221, 1, 96.2, 328975, 2099, 3099, 112075, 1951},  {63639, 1, 98.1, 346999, 1932, 3594, 113270, 1952},
    {64989, 1, 99.0, 365385, 1870, 3547, 115094, 1953},  {63761, 1, 100.0, 363112, 3578, 3350, 116219, 1954},
    {66019, 1, 101.2, 397469, 2904, 3048, 117388, 1955}, {67857, 1, 104.6, 419180, 2822, 2857, 118734, 1956},
    {68169, 1, 108.4, 442769, 2936, 2798, 120445, 1957}, {66513, 1, 110.8, 444546, 4681, 2637, 121950, 1958},
    {68655, 1, 112.6, 482704, 3813, 2552, 123366, 1959}, {69564, 1, 114.2, 502601, 3931, 2514, 125368, 1960},
    {69331, 1, 115.7, 518173, 4806, 2572, 127852, 1961}, {70551, 1, 116.9, 554894, 4007, 2827, 130081, 1962}};
/// NIST's certified coefficients and their standard deviations.
constexpr double kCertified[7][2] = {{-3482258.63459582, 890420.383607373},
                                     {15.0618722713733, 84.9149257747669},
                                     {-0.358191792925910E-01, 0.334910077722432E-01},
                                     {-2.02022980381683, 0.488399681651699},
                                     {-1.03322686717359, 0.214274163161675},
                                     {-0.511041056535807E-01, 0.226073200069370},
                                     {1829.15146461355, 455.478499142212}};

} // namespace

class LeastSquaresTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithCertifiedValues()
    {
        std::vector<double> design, values;
        for (const auto &row : kLongley) {
            values.push_back(row[0]);
            design.insert(design.end(), row + 1, row + 8);
        }
        const auto fit = leastSquares(design, 7, values);
        QVERIFY(fit);
        QCOMPARE(fit->degrees, 9.0);
        QVERIFY2(isNear(fit->deviation, 304.854073561965, 1e-9), qPrintable(QString::number(fit->deviation, 'g', 15)));
        for (std::size_t i = 0; i < 7; ++i) {
            QVERIFY2(isNear(fit->coefficients[i], kCertified[i][0], 1e-8), qPrintable(QString::number(i)));
            QVERIFY2(isNear(fit->errors[i], kCertified[i][1], 1e-8), qPrintable(QString::number(i)));
            QVERIFY(isNear(fit->halfWidth(i), 2.2621571627982 * fit->errors[i], 1e-9)); // Student's t of 9 degrees, by tables
        }
        QVERIFY(std::abs(std::accumulate(fit->residuals.begin(), fit->residuals.end(), 0.0)) < 1e-3);
    }

    /// The line through (0, 1), (1, 3), (2, 4), (3, 4) by hand: mean 1.5 and 3, Sxx 5, Sxy 5.
    void agreesWithALineByHand()
    {
        const double design[] = {1, 0, 1, 1, 1, 2, 1, 3}, values[] = {1, 3, 4, 4};
        const auto fit = leastSquares(design, 2, values);
        QVERIFY(fit);
        QVERIFY(isNear(fit->coefficients[0], 1.5, 1e-12) && isNear(fit->coefficients[1], 1, 1e-12));
        QVERIFY(isNear(fit->deviation * fit->deviation, 0.5, 1e-12));
        QVERIFY(isNear(fit->errors[1] * fit->errors[1], 0.1, 1e-12));
        QVERIFY(isNear(fit->errors[0] * fit->errors[0], 0.5 * (0.25 + 2.25 / 5), 1e-12));
        const double residuals[] = {-0.5, 0.5, 0.5, -0.5};
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(isNear(fit->residuals[i], residuals[i], 1e-12));
    }

    void refusesWhatHasNoSolution()
    {
        const double ones[] = {1, 2, 1, 2, 1, 2}, values[] = {1, 2, 3};
        QVERIFY(!leastSquares(ones, 2, values)); // the second column is twice the first
        const double few[] = {1, 1, 1, 2};
        QVERIFY(!leastSquares(few, 2, std::span(values, 2))); // nothing is left for the errors
        const double zero[] = {1, 0, 1, 0, 1, 0};
        QVERIFY(!leastSquares(zero, 2, values));
        QVERIFY(!leastSquares({}, 0, {}));
    }
};

SKYSEAL_TEST_APPLESS(LeastSquaresTest)
#include "least_squares_test.moc"
