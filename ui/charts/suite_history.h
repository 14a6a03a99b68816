// The history of each suite: its samples over its time in use, joined across all switches, and sums over all samples, so that
// suites can be overlaid and compared.
#pragma once

#include "ui/charts/quantities.h"

#include <deque>

namespace skyseal::ui {

/// Running statistics of one line of one quantity.
struct Tally
{
    std::uint64_t count = 0;
    double sum = 0, low = 0, high = 0;

    void add(double value);
    double mean() const { return count ? sum / static_cast<double>(count) : vehicle::kUnknown; }
};

struct SuiteUse
{
    struct Point
    {
        engine::MetricsSample sample;
        double inUse = 0;   ///< seconds in use up to the sample
        bool joined = true; ///< false: there is a gap before this point
    };

    crypto::SuiteId suite{};
    double inUse = 0;
    std::deque<Point> points;   ///< the last ten minutes of use
    std::vector<Tally> tallies; ///< one for each line of each quantity, in the order of allQuantities()
};

class SuiteHistory
{
public:
    /// Samples after a switch that are not added up, because rates over the last second still include the suite before.
    static constexpr int kSettling = 5;
    static constexpr double kKeepSeconds = 600;

    explicit SuiteHistory(const std::vector<Quantity> &quantities);

    void take(const engine::MetricsSample &sample);
    void clear();
    /// In the order of first use.
    const std::vector<SuiteUse> &uses() const { return m_uses; }

private:
    SuiteUse &useOf(crypto::SuiteId suite);

    std::vector<SampleValue> m_values;
    std::vector<SuiteUse> m_uses;
    std::optional<engine::MetricsSample> m_before;
    int m_sinceChange = 0;
};

} // namespace skyseal::ui
