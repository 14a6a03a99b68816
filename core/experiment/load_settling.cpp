#include "core/experiment/load_settling.h"

#include <algorithm>
#include <cmath>

namespace skyseal::experiment {

namespace {

constexpr double kLeastWindow = 1.0 / 3, kTrips = 2;
constexpr std::size_t kCompared = 3;

} // namespace

void LoadSettling::note(double time, std::uint64_t bytes, double roundTrip)
{
    const double window = std::isnan(roundTrip) ? kLeastWindow : std::max(kLeastWindow, kTrips * roundTrip);
    if (!std::isnan(m_begin) && time - m_begin < window)
        return;
    if (!std::isnan(m_begin))
        m_rates.push_back(static_cast<double>(bytes - std::min(bytes, m_bytes)) / (time - m_begin));
    m_begin = time;
    m_bytes = bytes;
}

bool LoadSettling::settled() const
{
    const auto is = [this](std::size_t windows, auto holds) {
        if (m_rates.size() < windows)
            return false;
        for (std::size_t i = m_rates.size() - windows; i < m_rates.size(); ++i) {
            if (!holds(i))
                return false;
        }
        return true;
    };
    if (m_lineRate)
        return is(2, [this](std::size_t i) { return m_rates[i] >= kFull * *m_lineRate; });
    return m_rates.size() >= kCompared && m_rates.back() > 0
        && is(kCompared - 1, [this](std::size_t i) { return m_rates[i] <= (1 + kGrowth) * m_rates[i - 1]; });
}

} // namespace skyseal::experiment
