// The lines of latitude and longitude that the map shows, with their coordinates.
#pragma once

#include "ui/map/map_viewport.h"

#include <QtCore/QLineF>
#include <QtCore/QString>

#include <vector>

namespace skyseal::ui {

struct GraticuleLine
{
    QLineF line;   ///< pixels, through the whole picture; a meridian begins in the north, a parallel in the west
    QString label; ///< "47.397° N"
    bool strong = false;
};

struct Graticule
{
    std::vector<GraticuleLine> meridians, parallels;
};

/// Lines at round degrees, about a hundred pixels apart.
Graticule graticuleOf(const MapViewport &viewport);

} // namespace skyseal::ui
