// Paints the content of the map: the ground (graticule, tiles, overlays, fence, mission, track, home, scale bar), and the
// vehicle above it. Made for one paint event.
#pragma once

#include "ui/map/graticule.h"
#include "ui/map/map_content.h"
#include "ui/map/map_viewport.h"
#include "ui/text/units.h"

#include <QtCore/QCoreApplication>
#include <QtGui/QFontMetricsF>
#include <QtGui/QPalette>

class QPainter;

namespace skyseal::ui {

class FenceContent;
class OverlayModel;
class TileLayer;

class MapPainter
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::MapPainter)

public:
    /// References must outlive the painter.
    MapPainter(QPainter &painter, const MapContent &content, const MapViewport &viewport, const QPalette &palette);

    /// Everything on the ground. The caller fills the background. `moving`: quickly rather than finely.
    void paintGround(const TileLayer &tiles, const OverlayModel &overlays, const FenceContent &fence, bool moving);
    /// Scale, north and the source of the tiles; above the vehicles, so that none hides them.
    void paintLegends(const TileLayer &tiles, UnitSystem units);
    /// All of them; with words beside each if there are several.
    void paintVehicles();
    /// A place that the operator is asked about. `label` may be empty.
    void paintMark(const QPointF &metres, const QString &label);
    /// The place that the selected vehicle flies to, with the way there.
    void paintTarget(const QPointF &metres, const QString &label);
    /// The centre of the map, where commands by keys act.
    void paintCentre();
    /// The place under the pointer, above the scale bar.
    void paintCoordinates(const QString &text);
    /// The most that paintCoordinates() covers with a text as wide as `widest`, in pixels.
    static QRectF placeOfCoordinates(const MapViewport &viewport, const QFontMetricsF &metrics, const QString &widest);
    /// Where paintVehicles() writes the names of vehicles at these pixels.
    using Names = std::vector<std::pair<QPointF, QString>>;
    static std::vector<std::pair<QRectF, QString>> placesOfNames(const Names &names, const QFontMetricsF &metrics);
    /// The arrow to the north, in pixels; a click on it turns a rotated map back.
    static QRectF placeOfNorth(const MapViewport &viewport);

private:
    void paintGraticule(const Graticule &graticule);
    void paintLabels(const Graticule &graticule);
    void paintTrack();
    void paintTrackScale(UnitSystem units, double bottom);
    void paintMission();
    void paintHome();
    void paintArrow(const QPointF &at, double heading, double size, const QColor &fill);
    void paintScale(UnitSystem units);
    void paintNorth();
    /// Returns the height up to which the lower left corner is free.
    double paintAttribution(const TileLayer &tiles);

    QPainter &m_painter;
    const MapContent &m_content;
    const MapViewport &m_viewport;
    const QPalette &m_palette;
};

} // namespace skyseal::ui
