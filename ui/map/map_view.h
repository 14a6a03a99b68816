// The plan view: north is up, a metric grid and a scale bar, home, mission, the track coloured by suite, and the vehicle.
// Drag or the arrow keys move it, the wheel or + and − zoom, Home follows the vehicle again. Holds the content, the viewport
// and a picture of the ground; MapPainter paints.
#pragma once

#include "ui/map/map_content.h"
#include "ui/map/map_viewport.h"
#include "ui/text/units.h"

#include <QtGui/QPixmap>
#include <QtWidgets/QWidget>

namespace skyseal::ui {

class MapView : public QWidget
{
    Q_OBJECT

public:
    explicit MapView(QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    void clearTrack();
    /// Another source of vehicles is shown: forgets everything of the one before.
    void startOver();
    void setUnits(UnitSystem units);
    void followVehicle();
    void zoomBy(double factor);

    bool isFollowing() const { return m_follow; }
    const MapContent &content() const { return m_content; }
    const MapViewport &viewport() const { return m_viewport; }

    QSize minimumSizeHint() const override { return {240, 160}; }

protected:
    void paintEvent(QPaintEvent *) override;
    void resizeEvent(QResizeEvent *) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void zoomAt(const QPointF &pixel, double factor);
    void pan(const QPointF &pixels);
    void markGroundDirty();
    void paintGround();

    MapContent m_content;
    MapViewport m_viewport;
    UnitSystem m_units = UnitSystem::Metric;
    bool m_follow = true;
    QPointF m_dragFrom;
    bool m_dragging = false;
    QPixmap m_ground; ///< painted again only when its content or the viewport changes
    bool m_groundDirty = true;
};

} // namespace skyseal::ui
