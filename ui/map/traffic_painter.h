// Paints aircraft in the neighbourhood, with name and height above the vehicle; those that are near are filled and say so.
#pragma once

#include "ui/map/map_viewport.h"
#include "ui/map/traffic.h"

#include <QtGui/QPalette>

class QPainter;

namespace skyseal::ui {

/// Made for one paint event; the references must outlive it.
class TrafficPainter
{
public:
    TrafficPainter(QPainter &painter, const MapViewport &viewport, const QPalette &palette)
        : m_painter(painter), m_viewport(viewport), m_palette(palette)
    {}

    void paint(const TrafficContent &content, UnitSystem units);

private:
    void paintAircraft(const AircraftMark &mark, UnitSystem units);

    QPainter &m_painter;
    const MapViewport &m_viewport;
    const QPalette &m_palette;
};

} // namespace skyseal::ui
