// Which part of the time the charts show: so many seconds up to now, or a part that was stopped and looked at closer.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace skyseal::ui {

class ChartRange
{
public:
    /// What the wheel and the keys step through, in seconds.
    static constexpr std::array<double, 6> kSpans{15, 30, 60, 120, 300, 600};
    static constexpr double kLeastSpan = 2;

    double span() const { return m_span; }
    bool frozen() const { return m_stopped.has_value(); }
    /// What x = 0 stands for.
    double zero(double newest) const { return m_stopped.value_or(newest); }
    /// Both in seconds before zero().
    double from() const { return m_end - m_span; }
    double to() const { return m_end; }

    void setSpan(double span) { m_span = m_chosen = std::max(kLeastSpan, span); }
    void freeze(double newest)
    {
        if (!m_stopped)
            m_stopped = newest;
    }
    /// Shows what is new again, as wide as it was before a part was looked at closer.
    void goLive()
    {
        m_stopped.reset();
        m_end = 0;
        m_span = m_chosen;
    }
    /// Positive is closer.
    void zoom(int steps)
    {
        for (; steps > 0; --steps) {
            const auto closer = std::find_if(kSpans.rbegin(), kSpans.rend(), [this](double s) { return s < m_span; });
            m_span = closer == kSpans.rend() ? std::min(m_span, kSpans.front()) : *closer;
        }
        for (; steps < 0; ++steps) {
            const auto wider = std::find_if(kSpans.begin(), kSpans.end(), [this](double s) { return s > m_span; });
            m_span = wider == kSpans.end() ? kSpans.back() : *wider;
        }
        if (!frozen())
            m_chosen = m_span;
    }
    /// A part of what is shown, which stops the charts.
    void select(double from, double to, double newest)
    {
        freeze(newest);
        m_end = std::min(0.0, std::max(from, to));
        m_span = std::max(kLeastSpan, std::abs(to - from));
    }
    /// By a share of the span; stops the charts. Never beyond zero.
    void pan(double share, double newest)
    {
        freeze(newest);
        m_end = std::min(0.0, m_end + share * m_span);
    }

private:
    double m_span = 120, m_end = 0;
    double m_chosen = m_span; ///< the span while the charts run
    std::optional<double> m_stopped;
};

} // namespace skyseal::ui
