// The track of the vehicle, with what its colours may say at each point.
#pragma once

#include "core/crypto/suite.h"
#include "ui/tiles/mercator.h"

#include <QtCore/QPointF>

#include <deque>
#include <limits>

namespace skyseal::ui {

/// Unknown ones are NaN.
struct TrackValues
{
    float quality = std::numeric_limits<float>::quiet_NaN();  ///< arrived frames, percent
    float altitude = std::numeric_limits<float>::quiet_NaN(); ///< metres above home
    float speed = std::numeric_limits<float>::quiet_NaN();    ///< over ground, metres a second
};

struct TrackPoint
{
    QPointF metres; ///< see mercator.h
    crypto::SuiteId suite{};
    bool begins = false; ///< nothing is known of the way from the point before
    TrackValues values = {};
};

/// Points at least a metre on the ground apart, the newest 10,000.
class Track
{
public:
    static constexpr std::size_t kMost = 10'000;
    static constexpr double kApart = 1.0; ///< metres

    /// The next point does not continue the line.
    void interrupt() { m_begins = true; }

    /// Returns true if the point was added: far enough from the last one, or under another suite.
    bool append(const QPointF &metres, crypto::SuiteId suite, const TrackValues &values = {})
    {
        if (!m_points.empty() && !m_begins) {
            const QPointF step = metres - m_points.back().metres;
            const double apart = kApart * mercator::stretch(metres.y());
            if (QPointF::dotProduct(step, step) < apart * apart && suite == m_points.back().suite)
                return false;
        }
        m_points.push_back({metres, suite, m_begins, values});
        m_begins = false;
        if (m_points.size() > kMost)
            m_points.pop_front();
        return true;
    }

    void clear()
    {
        m_points.clear();
        m_begins = true;
    }
    const std::deque<TrackPoint> &points() const { return m_points; }

private:
    std::deque<TrackPoint> m_points;
    bool m_begins = true;
};

} // namespace skyseal::ui
