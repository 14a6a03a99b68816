#include "ui/map/track_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skyseal::ui {

namespace {

/// From blue over green to red, told apart by colour-blind eyes as well, and legible on light and dark ground.
constexpr std::array<QRgb, TrackScale::kSteps> kRamp{0xff3f6fc4, 0xff1f9e9a, 0xff6fae3c, 0xffd29a00, 0xffd9541e};
constexpr QRgb kUnknownColor = 0xff999999;
constexpr double kWorstQuality = 80, kBestQuality = 100; ///< percent

} // namespace

double trackValue(const TrackPoint &point, TrackColors colors)
{
    switch (colors) {
    case TrackColors::Suite: break;
    case TrackColors::LinkQuality: return static_cast<double>(point.values.quality);
    case TrackColors::Altitude: return static_cast<double>(point.values.altitude);
    case TrackColors::Speed: return static_cast<double>(point.values.speed);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

TrackScale::TrackScale(const Track &track, TrackColors colors) : m_colors(colors)
{
    if (colors == TrackColors::LinkQuality) {
        m_low = kWorstQuality;
        m_high = kBestQuality;
        return;
    }
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const TrackPoint &point : track.points()) {
        const double value = trackValue(point, colors);
        if (!std::isfinite(value))
            continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high)
        return;
    m_low = std::floor(low);
    m_high = std::max(std::ceil(high), m_low + 1);
}

QColor TrackScale::colorOf(const TrackPoint &point) const
{
    const double value = trackValue(point, m_colors);
    if (!std::isfinite(value))
        return QColor::fromRgb(kUnknownColor);
    const double share = (value - m_low) / (m_high - m_low);
    return colorOfStep(static_cast<int>(std::clamp(share * kSteps, 0.0, kSteps - 1.0)));
}

QColor TrackScale::colorOfStep(int step) const
{
    // Of a link, much is good.
    const int place = m_colors == TrackColors::LinkQuality ? kSteps - 1 - step : step;
    return QColor::fromRgb(kRamp[static_cast<std::size_t>(place)]);
}

} // namespace skyseal::ui
