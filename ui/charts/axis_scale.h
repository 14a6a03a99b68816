// The end of a y axis that keeps still: it grows at once to the next round number, and shrinks only after the values
// have stayed low for a while. And into how many parts such an axis is best divided.
#pragma once

namespace skyseal::ui {

class AxisScale
{
public:
    /// Never smaller than `least`.
    explicit AxisScale(double least) : m_least(least), m_top(least) {}

    /// The axis' end for values up to `highest` at `now` (seconds).
    double update(double highest, double now);
    double top() const { return m_top; }

    static constexpr double kShrinkAfter = 10; ///< seconds of values below 40 % of the axis

private:
    double m_least, m_top;
    double m_lowSince = -1;
};

/// The least of 1, 2 or 5 times a power of ten that is not below `value`.
double roundUp(double value);

/// Parts of an axis up to `top` (as roundUp() gives it) that is so many pixels long: each ends at a short number.
int axisParts(double top, double pixels);

/// Places behind the point that a number which grows by `step` needs.
int decimalsOf(double step);

} // namespace skyseal::ui
