// The range of time that the charts show: the last seconds up to now, or a frozen part.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace skyseal::ui {

class ChartRange
{
public:
    /// The steps of the zoom, in seconds.
    static constexpr std::array<double, 6> kSpans{15, 30, 60, 120, 300, 600};
    static constexpr double kLeastSpan = 2;

    double span() const { return m_span; }
    bool frozen() const { return m_stopped.has_value(); }
    /// The time of the station, in seconds, at x = 0.
    double zero(double newest) const { return m_stopped.value_or(newest); }
    /// Ends of the range in seconds relative to zero(), not above 0.
    double from() const { return m_end - m_span; }
    double to() const { return m_end; }

    void setSpan(double span) { m_span = m_chosen = std::max(kLeastSpan, span); }
    void freeze(double newest)
    {
        if (!m_stopped)
            m_stopped = newest;
    }
    /// Returns to live data and the span chosen before zooming into a frozen part.
    void goLive()
    {
        m_stopped.reset();
        m_end = 0;
        m_span = m_chosen;
    }
    /// Positive steps zoom in.
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
    /// Freezes the charts and shows this part of the range.
    void select(double from, double to, double newest)
    {
        freeze(newest);
        m_end = std::min(0.0, std::max(from, to));
        m_span = std::max(kLeastSpan, std::abs(to - from));
    }
    /// Freezes the charts and moves the range by a share of its span, not beyond zero.
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
