// What each suite did while it was in use, however often the link changed between them: its samples, joined to one time of
// use, and sums over all of them, so that suites can be laid over one another and compared.
#pragma once

#include "ui/charts/quantities.h"

#include <deque>

namespace skyseal::ui {

/// Running figures of one line of one quantity.
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
        double inUse = 0;   ///< seconds that the suite had been in use by then
        bool joined = true; ///< follows the point before without a break
    };

    crypto::SuiteId suite{};
    double inUse = 0;
    std::deque<Point> points;   ///< the last ten minutes of use
    std::vector<Tally> tallies; ///< one for each line of each quantity, in the order of allQuantities()
};

class SuiteHistory
{
public:
    /// Rates look back over a second: so many samples after a change still tell of the suite before, and are not added up.
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
