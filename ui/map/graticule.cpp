#include "ui/map/graticule.h"

#include "ui/map/nice_step.h"
#include "ui/text/coordinates.h"
#include "ui/text/units.h"

namespace skyseal::ui {

namespace {

constexpr double kApart = 96; ///< pixels

int degreeDecimals(double step)
{
    return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
}

QString label(double degrees, int decimals, Compass positive, Compass negative)
{
    const QString figure = number(std::abs(degrees), decimals) + QStringLiteral("°");
    return degrees == 0 ? figure : figure + QLatin1Char(' ') + compassLetter(degrees > 0 ? positive : negative);
}

} // namespace

Graticule graticuleOf(const MapViewport &viewport)
{
    Graticule out;
    const double degreesPerPixel = viewport.metresPerPixel() / mercator::kMetresPerDegree;
    const double step = std::min(niceStep(kApart * degreesPerPixel), 30.0);
    const int decimals = degreeDecimals(step);
    const QRectF shown = viewport.visible();
    const double west = shown.left() / mercator::kMetresPerDegree, east = shown.right() / mercator::kMetresPerDegree;
    // By whole numbers, since a step of 1e-7 degrees cannot be summed up.
    for (auto i = static_cast<qint64>(std::ceil(west / step)); static_cast<double>(i) * step <= east; ++i) {
        const double degrees = static_cast<double>(i) * step;
        const double around = degrees - 360 * std::floor((degrees + 180) / 360);
        const double x = degrees * mercator::kMetresPerDegree;
        out.meridians.push_back({{viewport.toPixels({x, shown.bottom()}), viewport.toPixels({x, shown.top()})},
                                 label(around, decimals, Compass::East, Compass::West),
                                 i % 5 == 0});
    }
    const double south = mercator::unproject({0, shown.top()}).latitude,
                 north = mercator::unproject({0, shown.bottom()}).latitude;
    for (auto i = static_cast<qint64>(std::ceil(south / step)); static_cast<double>(i) * step <= north; ++i) {
        const double degrees = static_cast<double>(i) * step;
        const double y = mercator::project({degrees, 0}).y();
        if (std::abs(degrees) <= mercator::kLastLatitude)
            out.parallels.push_back({{viewport.toPixels({shown.left(), y}), viewport.toPixels({shown.right(), y})},
                                     label(degrees, decimals, Compass::North, Compass::South),
                                     i % 5 == 0});
    }
    return out;
}

} // namespace skyseal::ui
