// The map: north is up unless it turns with the vehicle, tiles of the chosen source or a graticule, a scale bar, home, fence,
// mission, the track coloured by suite, the overlays of the operator, and all vehicles. A click selects another one. Drag or
// the arrow keys move the map, the wheel or + and − zoom, Home follows the vehicle again; while the operator measures, clicks
// and keys go to MeasureTool. MapContent, FenceContent and TrafficContent are what it shows, MapCamera is which part of it,
// GroundPicture, MapPainter and EdgeArrow paint it, MapPointer reads mouse and fingers.
#pragma once

#include "ui/map/edge_arrow.h"
#include "ui/map/fence.h"
#include "ui/map/ground_picture.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_content.h"
#include "ui/map/map_pointer.h"
#include "ui/map/measure_tool.h"
#include "ui/map/traffic.h"
#include "ui/text/coordinates.h"
#include "ui/text/units.h"

#include <QtWidgets/QWidget>

#include <functional>
#include <utility>

class QHelpEvent;

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
    /// A replay is shown in place of the live picture, which is kept and goes on by noteLive() until endReplay() shows it
    /// again.
    void beginReplay();
    void noteLive(const ViewState &live);
    void endReplay();
    void setUnits(UnitSystem units);
    void setTrackColors(TrackColors colors);
    void setCoordinateFormat(CoordinateFormat format);
    void setSource(const MapSource &source) { m_ground.tiles().setSource(source); }
    void followVehicle() { m_camera.follow(); }
    void zoomBy(double factor) { m_camera.zoom(factor); }

    bool isFollowing() const { return m_camera.isFollowing(); }
    /// Until a zoom or a movement by keys has ended.
    bool isMoving() const { return m_camera.isMoving(); }
    const MapContent &content() const { return m_content; }
    const FenceContent &fence() const { return m_fence; }
    const TrafficContent &traffic() const { return m_traffic; }
    const MapViewport &viewport() const { return m_camera.viewport(); }
    TileLayer &tiles() { return m_ground.tiles(); }
    MeasureTool &measure() { return m_measure; }
    MapRotation &rotation() { return m_camera.rotation(); }
    OverlayModel &overlays() { return m_ground.overlays(); }
    UnitSystem units() const { return m_units; }
    CoordinateFormat coordinateFormat() const { return m_coordinates; }
    /// The place under the pointer or, while the map has the focus without it or is moved by keys, in the middle; nullopt
    /// otherwise.
    std::optional<LatLong> pointedPlace() const;
    /// Marks a place that the operator is asked about, with a word beside it; nullopt: none.
    void setMark(const std::optional<LatLong> &place, const QString &label = {});
    std::optional<QPointF> mark() const { return placeOf(m_mark); }
    /// Marks the place that the selected vehicle flies to; nullopt: none.
    void setTarget(const std::optional<LatLong> &place, const QString &label = {});
    std::optional<QPointF> target() const { return placeOf(m_target); }
    /// Points to the selected vehicle while it is beyond the map.
    std::optional<EdgeArrow> edgeArrow() const;
    /// The keys that follow the vehicle from anywhere in the window, for the tool tip of that arrow.
    void setFollowKeys(std::function<QString()> keys) { m_followKeys = std::move(keys); }
    /// Whether the centre is marked: the operator moves the map by keys, and other keys act there.
    bool isCentreMarked() const { return m_byKeys && hasFocus() && !m_measure.isOn(); }
    QPoint pixelOf(const LatLong &place) const { return viewport().toPixels(mercator::project(place)).toPoint(); }

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
    void focusInEvent(QFocusEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    /// A place with a word beside it.
    struct Labelled
    {
        QPointF metres; ///< of the projection
        QString label;

        bool operator==(const Labelled &) const = default;
    };
    static std::optional<Labelled> labelled(const std::optional<LatLong> &place, const QString &label);
    static std::optional<QPointF> placeOf(const std::optional<Labelled> &one);
    void connectPointer();
    void openMenu(const QPoint &pixel);
    void lookAnew();
    void setByKeys(bool byKeys);
    void showToolTip(const QHelpEvent &event);
    bool isOnNorth(const QPointF &pixel) const;
    std::optional<std::uint8_t> otherVehicleAt(const QPointF &pixel) const;
    void showPointer();
    LatLong placeAt(const QPointF &pixel) const { return mercator::unproject(viewport().toMetres(pixel)); }
    void click(const QPointF &pixel);
    void showMeasurement();
    void showCursor();
    void describe();

    MapContent m_content;
    std::optional<MapContent> m_live; ///< during a replay
    FenceContent m_fence;
    TrafficContent m_traffic;
    MapCamera m_camera;
    GroundPicture m_ground;
    MapPointer m_pointer;
    MeasureTool m_measure;
    UnitSystem m_units = UnitSystem::Metric;
    CoordinateFormat m_coordinates = CoordinateFormat::Decimal;
    std::optional<Labelled> m_mark, m_target;
    bool m_byKeys = false; ///< the last movement of the map was not by the pointer
    std::function<QString()> m_followKeys;
};

} // namespace skyseal::ui
