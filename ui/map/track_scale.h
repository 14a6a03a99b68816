// The colours of a track by a quantity: steps from its lowest to its highest value.
#pragma once

#include "ui/map/track.h"
#include "ui/text/units.h"
#include "ui/track_colors.h"

#include <QtGui/QColor>

#include <array>

namespace skyseal::ui {

class TrackScale
{
public:
    static constexpr int kSteps = 5;

    /// `colors` must not be TrackColors::Suite. Qualities of the link have a fixed range, since most flights are near its end.
    TrackScale(const Track &track, TrackColors colors);

    /// Gray where the value is not known.
    QColor colorOf(const TrackPoint &point) const;
    QColor colorOfStep(int step) const;
    double low() const { return m_low; }
    double high() const { return m_high; }

private:
    TrackColors m_colors;
    double m_low = 0, m_high = 1;
};

/// The value that `colors` shows: arrived frames in percent, metres above home, or metres a second; NaN if it is not known.
double trackValue(const TrackPoint &point, TrackColors colors);

} // namespace skyseal::ui
