// The map: north is up unless it turns with the vehicle, tiles of the chosen source or a graticule, a scale bar, home, fence,
// mission, the track coloured by suite, the overlays of the operator, and all vehicles. A click selects another one. Drag or
// the arrow keys move the map, the wheel or + and − zoom, Home follows the vehicle again; while the operator measures, clicks
// and keys go to MeasureTool. Holds the content, the viewport and a picture of the ground; MapPainter paints.
#pragma once

#include "ui/map/fence.h"
#include "ui/map/map_content.h"
#include "ui/map/map_motion.h"
#include "ui/map/map_rotation.h"
#include "ui/map/map_touch.h"
#include "ui/map/map_viewport.h"
#include "ui/map/measure_tool.h"
#include "ui/map/tile_layer.h"
#include "ui/map/traffic.h"
#include "ui/overlays/overlay_model.h"
#include "ui/text/coordinates.h"
#include "ui/text/units.h"

#include <QtGui/QPixmap>
#include <QtWidgets/QWidget>

namespace skyseal::ui {

class MapView : public QWidget
{
    Q_OBJECT

public:
    explicit MapView(const TileConfig &tiles = {}, QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    void clearTrack();
    /// Another source of vehicles is shown: forgets everything of the one before.
    void startOver();
    /// Forgets what the vehicle flew, and stays where it is.
    void forgetFlight();
    void setUnits(UnitSystem units);
    void setTrackColors(TrackColors colors);
    void setCoordinateFormat(CoordinateFormat format);
    void setSource(const MapSource &source) { m_tiles.setSource(source); }
    void followVehicle();
    void zoomBy(double factor);

    bool isFollowing() const { return m_follow; }
    /// Until a zoom or a movement by keys has ended.
    bool isMoving() const { return m_motion.isMoving(); }
    const MapContent &content() const { return m_content; }
    const FenceContent &fence() const { return m_fence; }
    const TrafficContent &traffic() const { return m_traffic; }
    const MapViewport &viewport() const { return m_viewport; }
    TileLayer &tiles() { return m_tiles; }
    MeasureTool &measure() { return m_measure; }
    MapRotation &rotation() { return m_rotation; }
    OverlayModel &overlays() { return m_overlays; }
    UnitSystem units() const { return m_units; }
    CoordinateFormat coordinateFormat() const { return m_coordinates; }
    /// The place under the pointer or, while the map has the focus without it, in the middle; nullopt otherwise.
    std::optional<LatLong> pointedPlace() const;
    /// Marks a place that the operator is asked about, with a word beside it; nullopt: none.
    void setMark(const std::optional<LatLong> &place, const QString &label = {});
    const std::optional<QPointF> &mark() const { return m_mark; }
    /// Marks the place that the selected vehicle flies to; nullopt: none.
    void setTarget(const std::optional<LatLong> &place, const QString &label = {});
    const std::optional<QPointF> &target() const { return m_target; }
    QPoint pixelOf(const LatLong &place) const { return m_viewport.toPixels(mercator::project(place)).toPoint(); }

Q_SIGNALS:
    /// The operator clicked a vehicle that is not the selected one.
    void vehicleClicked(std::uint8_t systemId);
    /// The operator wants to choose what to do at this place, by the right button or the menu key.
    void menuRequested(const skyseal::ui::LatLong &place, const QPoint &globalPosition);

public:
    QSize minimumSizeHint() const override { return {240, 160}; }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *) override;
    void resizeEvent(QResizeEvent *) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void connectTouch();
    void zoomAt(const QPointF &pixel, double factor);
    void beginDrag(const QPointF &pixel);
    void dragTo(const QPointF &pixel);
    void endDrag(const QPointF &pixel, bool isClick);
    void openMenu(const QPoint &pixel);
    void leaveVehicle();
    void turn();
    bool isOnNorth(const QPointF &pixel) const;
    void showFirst(const QPointF &vehicle);
    void markGroundDirty();
    std::optional<std::uint8_t> otherVehicleAt(const QPointF &pixel) const;
    void setPointer(const std::optional<QPointF> &pixel);
    LatLong placeAt(const QPointF &pixel) const { return mercator::unproject(m_viewport.toMetres(pixel)); }
    void click(const QPointF &pixel);
    void showMeasurement();
    void showCursor();
    void describe();
    void paintGround();

    MapContent m_content;
    FenceContent m_fence;
    TrafficContent m_traffic;
    MapViewport m_viewport;
    MapMotion m_motion{m_viewport};
    TileLayer m_tiles;
    MeasureTool m_measure;
    MapRotation m_rotation;
    MapTouch m_touch;
    OverlayModel m_overlays;
    UnitSystem m_units = UnitSystem::Metric;
    CoordinateFormat m_coordinates = CoordinateFormat::Decimal;
    std::optional<QPointF> m_pointer; ///< pixels
    bool m_follow = true;
    bool m_placed = false;                   ///< a vehicle was shown, or the operator has moved the map
    std::optional<QPointF> m_mark, m_target; ///< metres of the projection
    QString m_markLabel, m_targetLabel;
    /// Pixels.
    struct Drag
    {
        QPointF begin, last;
    };
    std::optional<Drag> m_drag; ///< while the button is down
    QPixmap m_ground;           ///< painted again only when its content or the viewport changes
    bool m_groundDirty = true;
};

} // namespace skyseal::ui
