// The scale of a y axis. It grows at once to the next round number and shrinks only after the values have stayed low for a
// while, so that the axis does not jump. Also the division of such an axis into labelled parts.
#pragma once

namespace skyseal::ui {

class AxisScale
{
public:
    /// `least` is the smallest end of the axis, in the unit of the chart.
    explicit AxisScale(double least) : m_least(least), m_top(least) {}

    /// Returns the end of the axis for values up to `highest` at the time `now` in seconds.
    double update(double highest, double now);
    double top() const { return m_top; }

    static constexpr double kShrinkAfter = 10; ///< seconds of values below 40 % of the axis

private:
    double m_least, m_top;
    double m_lowSince = -1;
};

/// Returns the smallest of 1, 2 or 5 times a power of ten that is not below `value`.
double roundUp(double value);

/// Returns the number of parts for an axis up to `top` (a result of roundUp()) of this length that gives short labels.
int axisParts(double top, double pixels);

/// Returns the decimals that labels at multiples of `step` need.
int decimalsOf(double step);

} // namespace skyseal::ui
