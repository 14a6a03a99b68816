// The last ten minutes of the diagnostics' samples, each once, whatever the snapshots repeat; and beside them what each
// suite did while it was in use.
#pragma once

#include "ui/charts/suite_history.h"

namespace skyseal::ui {

class SampleHistory
{
public:
    static constexpr double kKeepSeconds = 600;

    explicit SampleHistory(const std::vector<Quantity> &quantities = allQuantities()) : m_suites(quantities) {}

    /// Takes those that are newer than what is known; true when there were any. Numbers that
    /// went back are another station's: it begins anew.
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
    /// Time of the newest sample; 0 without any.
    double newest() const { return m_samples.empty() ? 0 : m_samples.back().time; }

private:
    std::deque<engine::MetricsSample> m_samples;
    SuiteHistory m_suites;
};

} // namespace skyseal::ui
