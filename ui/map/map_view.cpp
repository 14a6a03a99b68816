#include "ui/map/map_view.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/map/map_painter.h"
#include "ui/map/measure_painter.h"
#include "ui/map/traffic_painter.h"

#include <QtGui/QAction>
#include <QtGui/QContextMenuEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QTouchEvent>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QApplication>
#include <QtWidgets/QStyle>

#include <cmath>
#include <utility>

namespace skyseal::ui {

namespace {
constexpr double kKeyStep = 96;        ///< pixels
constexpr double kKeyZoom = 1.5;       ///< factor
constexpr double kFirstScale = 0.5;    ///< metres on the ground per pixel, when the first vehicle is shown
constexpr double kWorldScale = 40'000; ///< metres per pixel, until then
} // namespace

MapView::MapView(const TileConfig &tiles, QWidget *parent) : QWidget(parent), m_tiles(tiles)
{
    setObjectName(QStringLiteral("map"));
    setAccessibleName(tr("Map"));
    describe();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_viewport.setMetresPerPixel(kWorldScale);
    m_motion.setAnimated(style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) > 0);
    connect(&m_motion, &MapMotion::moved, this, &MapView::markGroundDirty);
    connect(&m_motion, &MapMotion::settled, this, &MapView::markGroundDirty); // finely
    connect(&m_tiles, &TileLayer::changed, this, &MapView::markGroundDirty);
    connect(&m_overlays, &OverlayModel::pictureChanged, this, &MapView::markGroundDirty);
    connectTouch();
    connect(&m_rotation, &MapRotation::toggled, this, &MapView::turn);
    connect(&m_measure, &MeasureTool::changed, this, &MapView::showMeasurement);
    connect(m_measure.action(), &QAction::triggered, this, [this] { setFocus(Qt::ShortcutFocusReason); }); // for its keys
}

void MapView::describe()
{
    setAccessibleDescription(
        m_measure.isOn()
            ? tr("%1. Enter sets a point at the centre of the map, Backspace removes the last, Escape ends")
                  .arg(measuredText(m_measure, m_units))
            : tr("Arrow keys move the map, plus and minus zoom, Home follows the vehicle, Menu opens the commands for "
                 "the centre"));
}

void MapView::showCursor()
{
    if (m_pointer && isOnNorth(*m_pointer))
        setCursor(Qt::PointingHandCursor);
    else if (m_measure.isOn())
        setCursor(Qt::CrossCursor);
    else
        unsetCursor();
}

void MapView::showMeasurement()
{
    showCursor();
    describe();
    update();
}

void MapView::showViewState(const ViewState &view)
{
    const MapContent::Changes changes = m_content.show(view, m_viewport.metresPerPixel());
    m_groundDirty |= changes.ground;
    m_groundDirty |= m_fence.show(view);
    const bool trafficChanged = m_traffic.show(view);
    if (changes.moved && !m_placed)
        showFirst(*m_content.vehicle());
    if (changes.moved && m_follow && !m_drag) {
        // Follow in steps: the ground is redrawn only when the vehicle leaves the middle of the picture.
        const QPointF off = m_viewport.toPixels(*m_content.vehicle()) - QPointF(width() / 2.0, height() / 2.0);
        if (std::abs(off.x()) > width() / 4.0 || std::abs(off.y()) > height() / 4.0) {
            m_viewport.setCentre(*m_content.vehicle());
            m_groundDirty = true;
        }
    }
    if (view.vehicle && !view.stale()) {
        m_rotation.showHeading(view.vehicle->state.heading, view.vehicle->state.groundSpeed);
        if (m_follow)
            turn();
    }
    if (changes.vehicle || trafficChanged || m_groundDirty)
        update();
}

/// Around the vehicle, if the map follows it. A map that the operator has moved stays as it is, until it follows again or north
/// is to point up.
void MapView::turn()
{
    if (m_drag || (m_rotation.isOn() && !m_follow))
        return;
    const QPointF middle(width() / 2.0, height() / 2.0);
    if (m_rotation.target() != m_viewport.heading())
        m_motion.turn(m_follow && m_content.vehicle() ? m_viewport.toPixels(*m_content.vehicle()) : middle,
                      m_rotation.target());
}

bool MapView::isOnNorth(const QPointF &pixel) const
{
    return m_viewport.isRotated() && MapPainter::placeOfNorth(m_viewport).contains(pixel);
}

void MapView::showFirst(const QPointF &vehicle)
{
    m_placed = true;
    m_viewport.setCentre(vehicle);
    m_viewport.setMetresPerPixel(kFirstScale * mercator::stretch(vehicle.y()));
    m_groundDirty = true;
}

void MapView::markGroundDirty()
{
    m_groundDirty = true;
    update();
}

void MapView::clearTrack()
{
    m_content.clearTrack();
    markGroundDirty();
}

void MapView::startOver()
{
    m_follow = true;
    forgetFlight();
}

void MapView::forgetFlight()
{
    const TrackColors colors = m_content.trackColors();
    m_content = MapContent();
    m_content.setTrackColors(colors);
    m_fence = FenceContent();
    m_traffic = TrafficContent();
    markGroundDirty();
}

void MapView::setMark(const std::optional<LatLong> &place, const QString &label)
{
    m_mark = place ? std::optional(mercator::project(*place)) : std::nullopt;
    m_markLabel = label;
    update();
}

void MapView::setTarget(const std::optional<LatLong> &place, const QString &label)
{
    const auto target = place ? std::optional(mercator::project(*place)) : std::nullopt;
    if (target == m_target && label == m_targetLabel)
        return;
    m_target = target;
    m_targetLabel = label;
    update();
}

/// By the key: in the middle of the map.
void MapView::contextMenuEvent(QContextMenuEvent *event)
{
    event->accept();
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    openMenu(byKey ? rect().center() : event->pos());
}

void MapView::openMenu(const QPoint &pixel)
{
    if (!m_measure.isOn())
        Q_EMIT menuRequested(placeAt(pixel), mapToGlobal(pixel));
}

void MapView::setTrackColors(TrackColors colors)
{
    if (colors == m_content.trackColors())
        return;
    m_content.setTrackColors(colors);
    markGroundDirty();
}

void MapView::setUnits(UnitSystem units)
{
    if (m_units == units)
        return;
    m_units = units;
    describe();
    markGroundDirty();
}

void MapView::setCoordinateFormat(CoordinateFormat format)
{
    m_coordinates = format;
    update();
}

std::optional<LatLong> MapView::pointedPlace() const
{
    if (!m_pointer && !hasFocus())
        return std::nullopt;
    return placeAt(m_pointer.value_or(QPointF(rect().center())));
}

void MapView::setPointer(const std::optional<QPointF> &pixel)
{
    m_pointer = pixel;
    if (!m_drag)
        showCursor();
    if (m_measure.isOn())
        update();
    else
        update(MapPainter::placeOfCoordinates(m_viewport, fontMetrics(), widestCoordinates(m_coordinates)).toAlignedRect());
}

void MapView::followVehicle()
{
    m_follow = true;
    m_motion.stop();
    if (m_content.vehicle())
        m_viewport.setCentre(*m_content.vehicle());
    turn();
    markGroundDirty();
}

void MapView::zoomBy(double factor)
{
    zoomAt(QPointF(width() / 2.0, height() / 2.0), factor);
}

void MapView::zoomAt(const QPointF &pixel, double factor)
{
    m_motion.zoom(pixel, factor);
}

void MapView::leaveVehicle()
{
    m_follow = false;
    m_placed = true;
}

void MapView::paintEvent(QPaintEvent *)
{
    if (m_groundDirty)
        paintGround();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_ground);
    painter.setRenderHint(QPainter::Antialiasing);
    MapPainter map(painter, m_content, m_viewport, palette());
    TrafficPainter(painter, m_viewport, palette()).paint(m_traffic, m_units);
    if (m_target)
        map.paintTarget(*m_target, m_targetLabel);
    map.paintVehicles();
    if (m_mark)
        map.paintMark(*m_mark, m_markLabel);
    if (m_measure.isOn())
        MeasurePainter(painter, m_viewport, palette()).paint(m_measure, pointedPlace(), m_units);
    if (const auto place = pointedPlace())
        map.paintCoordinates(coordinatesText(place->latitude, place->longitude, m_coordinates));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void MapView::paintGround()
{
    const qreal ratio = devicePixelRatioF();
    const QSize wanted = size() * ratio;
    if (m_ground.size() != wanted) {
        m_ground = QPixmap(wanted);
        m_ground.setDevicePixelRatio(ratio);
    }
    m_groundDirty = false;
    m_tiles.show(m_viewport);
    m_ground.fill(palette().color(QPalette::Base));
    QPainter painter(&m_ground);
    painter.setFont(font());
    MapPainter(painter, m_content, m_viewport, palette())
        .paintGround(m_tiles, m_overlays, m_fence, m_units, m_drag || m_motion.isMoving());
}

void MapView::resizeEvent(QResizeEvent *)
{
    m_viewport.setSize(size());
    markGroundDirty();
}

void MapView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        markGroundDirty();
    QWidget::changeEvent(event);
}

void MapView::connectTouch()
{
    setAttribute(Qt::WA_AcceptTouchEvents);
    connect(&m_touch, &MapTouch::pressed, this, &MapView::beginDrag);
    connect(&m_touch, &MapTouch::dragged, this, &MapView::dragTo);
    connect(&m_touch, &MapTouch::released, this, &MapView::endDrag);
    connect(&m_touch, &MapTouch::held, this, [this](const QPointF &pixel) { openMenu(pixel.toPoint()); });
    connect(&m_touch, &MapTouch::pinched, this, [this](const QPointF &from, const QPointF &to, double factor) {
        leaveVehicle();
        m_motion.stop();
        m_viewport.pan(to - from);
        m_viewport.zoomAt(to, factor);
        markGroundDirty();
    });
}

/// Fingers are read here; Qt would make a mouse of the first one only.
bool MapView::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        if (m_touch.handle(*static_cast<QTouchEvent *>(event), *this)) {
            event->accept();
            return true;
        }
        break;
    default: break;
    }
    return QWidget::event(event);
}

void MapView::beginDrag(const QPointF &pixel)
{
    m_drag = Drag{pixel, pixel};
    m_motion.stop();
}

void MapView::dragTo(const QPointF &pixel)
{
    if (!m_drag)
        return;
    leaveVehicle();
    m_viewport.pan(pixel - m_drag->last);
    m_drag->last = pixel;
    markGroundDirty();
}

void MapView::endDrag(const QPointF &pixel, bool isClick)
{
    const bool dragged = std::exchange(m_drag, std::nullopt).has_value();
    showCursor();
    markGroundDirty(); // finely
    if (dragged && isClick)
        click(pixel);
}

void MapView::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    beginDrag(event->position());
    setCursor(Qt::ClosedHandCursor);
}

void MapView::mouseMoveEvent(QMouseEvent *event)
{
    setPointer(event->position());
    dragTo(event->position());
}

void MapView::mouseReleaseEvent(QMouseEvent *event)
{
    const bool isClick = m_drag && (event->position() - m_drag->begin).manhattanLength() < QApplication::startDragDistance();
    endDrag(event->position(), isClick);
}

void MapView::click(const QPointF &pixel)
{
    if (isOnNorth(pixel))
        m_rotation.action()->setChecked(false);
    else if (m_measure.isOn())
        m_measure.add(placeAt(pixel));
    else if (const auto clicked = otherVehicleAt(pixel))
        Q_EMIT vehicleClicked(*clicked);
}

/// The nearest one within reach of a finger.
std::optional<std::uint8_t> MapView::otherVehicleAt(const QPointF &pixel) const
{
    constexpr double kReach = 20; // pixels
    std::optional<std::uint8_t> found;
    double nearest = kReach;
    for (const VehicleMarker &other : m_content.others()) {
        const QPointF way = m_viewport.toPixels(other.metres) - pixel;
        if (const double apart = std::hypot(way.x(), way.y()); apart < nearest) {
            nearest = apart;
            found = other.systemId;
        }
    }
    return found;
}

void MapView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (!m_measure.isOn())
        zoomAt(event->position(), 2);
}

void MapView::leaveEvent(QEvent *)
{
    setPointer(std::nullopt);
}

void MapView::wheelEvent(QWheelEvent *event)
{
    constexpr double kUnitsPerLevel = 240; // two notches of a usual wheel
    zoomAt(event->position(), std::exp2(event->angleDelta().y() / kUnitsPerLevel));
    event->accept();
}

void MapView::keyPressEvent(QKeyEvent *event)
{
    if (m_measure.handleKey(*event, pointedPlace()))
        return;
    const auto pan = [this](double right, double down) {
        leaveVehicle();
        m_motion.pan({right * kKeyStep, down * kKeyStep});
    };
    switch (event->key()) {
    case Qt::Key_Left: pan(1, 0); break;
    case Qt::Key_Right: pan(-1, 0); break;
    case Qt::Key_Up: pan(0, 1); break;
    case Qt::Key_Down: pan(0, -1); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomBy(kKeyZoom); break;
    case Qt::Key_Minus: zoomBy(1 / kKeyZoom); break;
    case Qt::Key_Home: followVehicle(); break;
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace skyseal::ui
