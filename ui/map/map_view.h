// The plan view: north is up, a metric grid and a scale bar, home, mission, the track coloured by suite, and the vehicle.
// Drag or the arrow keys move it, the wheel or + and − zoom, Home follows the vehicle again.
#pragma once

#include "ui/map/local_frame.h"
#include "ui/map/track.h"
#include "ui/view_state.h"

#include <QtGui/QPixmap>
#include <QtWidgets/QWidget>

#include <optional>

namespace skyseal::ui {

class MapView : public QWidget
{
    Q_OBJECT

public:
    explicit MapView(QWidget *parent = nullptr);

    void showViewState(const ViewState &view);
    void clearTrack();
    void followVehicle();
    void zoomBy(double factor);

    bool isFollowing() const { return m_follow; }
    double metresPerPixel() const { return m_metresPerPixel; }
    const Track &track() const { return m_track; }
    /// Returns the pixel of a position in metres.
    QPointF toPixels(const QPointF &metres) const;

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
    void zoomAt(const QPointF &pixels, double factor);
    void pan(const QPointF &pixels);
    void dirty();
    void paintGround();
    void paintTrack(QPainter &painter) const;
    void paintMission(QPainter &painter) const;
    void paintHome(QPainter &painter) const;
    void paintVehicle(QPainter &painter) const;
    void paintFurniture(QPainter &painter) const;

    std::optional<LocalFrame> m_frame;
    QPointF m_centre; ///< metres
    double m_metresPerPixel = 0.5;
    bool m_follow = true;
    QPointF m_dragFrom;
    bool m_dragging = false;

    std::uint8_t m_systemId = 0;
    std::optional<QPointF> m_vehicle, m_home;
    double m_heading = 0;
    bool m_stale = false, m_armed = false;
    crypto::SuiteId m_suite{};
    Track m_track;
    std::shared_ptr<const std::vector<vehicle::MissionItem>> m_mission;
    int m_missionCurrent = -1;
    QPixmap m_ground; ///< grid, mission and track: redrawn only when they change
    bool m_groundDirty = true;
};

} // namespace skyseal::ui
