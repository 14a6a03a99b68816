// Paints the content of the map: the ground (grid, mission, track, home, scale bar), and the vehicle above it. Made for one
// paint event.
#pragma once

#include "ui/map/map_content.h"
#include "ui/map/map_viewport.h"
#include "ui/text/units.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QPalette>

class QPainter;

namespace skyseal::ui {

class MapPainter
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::MapPainter)

public:
    /// References must outlive the painter.
    MapPainter(QPainter &painter, const MapContent &content, const MapViewport &viewport, const QPalette &palette);

    /// Everything except the vehicle. The caller fills the background.
    void paintGround(UnitSystem units);
    void paintVehicle();

private:
    void paintGrid();
    void paintTrack();
    void paintMission();
    void paintHome();
    void paintScale(UnitSystem units);
    void paintNorth();

    QPainter &m_painter;
    const MapContent &m_content;
    const MapViewport &m_viewport;
    const QPalette &m_palette;
};

} // namespace skyseal::ui
