#include "ui/charts/axis_scale.h"

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

double roundUp(double value)
{
    if (!(value > 0))
        return 0;
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (power * factor >= value * (1 - 1e-12))
            return power * factor;
    return power * 10;
}

int axisParts(double top, double pixels)
{
    if (pixels < 120 || !(top > 0))
        return 2;
    const double lead = top / std::pow(10, std::floor(std::log10(top) + 1e-9));
    return lead > 1.5 && lead < 3 ? 4 : 5; // 2 by halves, 1 and 5 by fifths
}

int decimalsOf(double step)
{
    for (int places = 0; places < 4; ++places) {
        const double scaled = step * std::pow(10, places);
        if (std::abs(scaled - std::round(scaled)) < 1e-6)
            return places;
    }
    return 4;
}

double AxisScale::update(double highest, double now)
{
    const double wanted = std::max(m_least, roundUp(highest * 1.05));
    if (wanted >= m_top) {
        m_top = wanted;
        m_lowSince = -1;
    } else if (highest > m_top * 0.4) {
        m_lowSince = -1;
    } else if (m_lowSince < 0 || now < m_lowSince) {
        m_lowSince = now;
    } else if (now - m_lowSince >= kShrinkAfter) {
        m_top = wanted;
        m_lowSince = -1;
    }
    return m_top;
}

} // namespace skyseal::ui
