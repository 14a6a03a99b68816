// The last ten minutes of the diagnostics' samples, each once, whatever the snapshots repeat.
#pragma once

#include "core/engine/snapshot.h"

#include <deque>
#include <vector>

namespace skyseal::ui {

class SampleHistory
{
public:
    static constexpr double kKeepSeconds = 600;

    /// Takes those that are newer than what is known; true when there were any. Numbers that
    /// went back are another station's: it begins anew.
    bool take(const std::vector<engine::MetricsSample> &samples)
    {
        bool any = false;
        if (!samples.empty() && !m_samples.empty() && samples.back().number < m_samples.back().number)
            m_samples.clear();
        for (const engine::MetricsSample &sample : samples) {
            if (!m_samples.empty() && sample.number <= m_samples.back().number)
                continue;
            m_samples.push_back(sample);
            any = true;
        }
        while (!m_samples.empty() && m_samples.back().time - m_samples.front().time > kKeepSeconds)
            m_samples.pop_front();
        return any;
    }

    const std::deque<engine::MetricsSample> &samples() const { return m_samples; }
    bool empty() const { return m_samples.empty(); }

private:
    std::deque<engine::MetricsSample> m_samples;
};

} // namespace skyseal::ui
