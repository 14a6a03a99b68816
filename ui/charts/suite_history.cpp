#include "ui/charts/suite_history.h"

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

void Tally::add(double value)
{
    if (!std::isfinite(value))
        return;
    low = count ? std::min(low, value) : value;
    high = count ? std::max(high, value) : value;
    sum += value;
    ++count;
}

SuiteHistory::SuiteHistory(const std::vector<Quantity> &quantities)
{
    for (const Quantity &quantity : quantities)
        for (const QuantityLine &line : quantity.lines)
            m_values.push_back(line.value);
}

SuiteUse &SuiteHistory::useOf(crypto::SuiteId suite)
{
    const auto known = std::ranges::find(m_uses, suite, &SuiteUse::suite);
    if (known != m_uses.end())
        return *known;
    SuiteUse fresh;
    fresh.suite = suite;
    fresh.tallies.resize(m_values.size());
    return m_uses.emplace_back(std::move(fresh));
}

void SuiteHistory::take(const engine::MetricsSample &sample)
{
    const bool follows = m_before && m_before->linkUp && m_before->suite == sample.suite
        && sample.time - m_before->time <= kGapSeconds;
    const double passed = follows ? sample.time - m_before->time : 0;
    m_before = sample;
    m_sinceChange = follows ? m_sinceChange + 1 : 0;
    if (!sample.linkUp)
        return;
    SuiteUse &use = useOf(sample.suite);
    use.inUse += passed;
    use.points.push_back({sample, use.inUse, follows});
    while (use.inUse - use.points.front().inUse > kKeepSeconds)
        use.points.pop_front();
    if (m_sinceChange < kSettling)
        return;
    for (std::size_t i = 0; i < m_values.size(); ++i)
        use.tallies[i].add(m_values[i](sample));
}

void SuiteHistory::clear()
{
    m_uses.clear();
    m_before.reset();
    m_sinceChange = 0;
}

} // namespace skyseal::ui
