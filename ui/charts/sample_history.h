// The samples of the last ten minutes without the repetitions of the snapshots, and the history of each suite.
#pragma once

#include "ui/charts/suite_history.h"

#include <algorithm>

namespace skyseal::ui {

class SampleHistory
{
public:
    static constexpr double kKeepSeconds = 600;

    explicit SampleHistory(const std::vector<Quantity> &quantities = allQuantities()) : m_suites(quantities) {}

    /// Adds the samples that are newer than the known ones; returns true if there were any. If the numbers went back, the
    /// samples are of another station and the history is cleared first.
    bool take(const std::vector<engine::MetricsSample> &samples)
    {
        bool any = false;
        if (!samples.empty() && !m_samples.empty() && samples.back().number < m_samples.back().number) {
            m_samples.clear();
            m_suites.clear();
        }
        for (const engine::MetricsSample &sample : samples) {
            if (!m_samples.empty() && sample.number <= m_samples.back().number)
                continue;
            m_samples.push_back(sample);
            m_suites.take(sample);
            any = true;
        }
        while (!m_samples.empty() && m_samples.back().time - m_samples.front().time > kKeepSeconds)
            m_samples.pop_front();
        return any;
    }

    const std::deque<engine::MetricsSample> &samples() const { return m_samples; }
    const SuiteHistory &suites() const { return m_suites; }
    bool empty() const { return m_samples.empty(); }
    /// True if a vehicle was heard in a sample.
    bool hasLink() const { return std::ranges::any_of(m_samples, &engine::MetricsSample::linkUp); }
    /// Returns the time of the newest sample in seconds; 0 without samples.
    double newest() const { return m_samples.empty() ? 0 : m_samples.back().time; }

private:
    std::deque<engine::MetricsSample> m_samples;
    SuiteHistory m_suites;
};

} // namespace skyseal::ui
