#include "ui/map/map_view.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/map/map_painter.h"
#include "ui/map/measure_painter.h"
#include "ui/map/traffic_painter.h"
#include "ui/text/plain_tip.h"

#include <QtGui/QAction>
#include <QtGui/QContextMenuEvent>
#include <QtGui/QHelpEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QTouchEvent>
#include <QtGui/QWheelEvent>
#include <QtWidgets/QStyle>
#include <QtWidgets/QToolTip>

#include <cmath>
#include <utility>

namespace skyseal::ui {

namespace {
constexpr double kKeyStep = 96;  ///< pixels
constexpr double kKeyZoom = 1.5; ///< factor
} // namespace

MapView::MapView(const TileConfig &tiles, QWidget *parent) : QWidget(parent), m_ground(tiles)
{
    setObjectName(QStringLiteral("map"));
    setAccessibleName(tr("Map"));
    describe();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_camera.setAnimated(style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) > 0);
    connect(&m_camera, &MapCamera::changed, &m_ground, &GroundPicture::markDirty);
    connect(&m_ground, &GroundPicture::changed, this, qOverload<>(&MapView::update));
    connectPointer();
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
    const auto pointed = m_pointer.position();
    const auto arrow = pointed ? edgeArrow() : std::nullopt;
    if (pointed && (isOnNorth(*pointed) || (arrow && arrow->contains(*pointed))))
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
    if (view.snapshot && !view.vehicle && m_content.systemId() != 0)
        forgetFlight(); // of a station or a demo that has ended
    const MapContent::Changes changes = m_content.show(view, viewport().metresPerPixel());
    const bool fenceChanged = m_fence.show(view);
    const bool trafficChanged = m_traffic.show(view);
    if (changes.ground || fenceChanged)
        m_ground.markDirty();
    m_camera.showVehicle(m_content.vehicle(), changes.moved);
    if (view.vehicle && !view.stale())
        m_camera.showHeading(view.vehicle->state.heading, view.vehicle->state.groundSpeed);
    if (changes.vehicle || trafficChanged)
        update();
}

bool MapView::isOnNorth(const QPointF &pixel) const
{
    return viewport().isRotated() && MapPainter::placeOfNorth(viewport()).contains(pixel);
}

void MapView::clearTrack()
{
    m_content.clearTrack();
    m_ground.markDirty();
}

void MapView::startOver()
{
    m_live.reset();
    lookAnew();
}

void MapView::lookAnew()
{
    m_camera.followNext();
    forgetFlight();
}

void MapView::beginReplay()
{
    if (!m_live) // otherwise another replay was shown
        m_live = m_content;
    lookAnew();
}

void MapView::noteLive(const ViewState &live)
{
    if (!m_live)
        return;
    if (live.snapshot && !live.vehicle)
        m_live = MapContent(); // as showViewState()
    m_live->show(live, viewport().metresPerPixel());
}

void MapView::endReplay()
{
    lookAnew();
    const TrackColors colors = m_content.trackColors();
    m_content = std::exchange(m_live, std::nullopt).value_or(MapContent());
    m_content.setTrackColors(colors);
    m_camera.showVehicle(m_content.vehicle(), true);
}

void MapView::forgetFlight()
{
    const TrackColors colors = m_content.trackColors();
    m_content = MapContent();
    m_content.setTrackColors(colors);
    m_fence = FenceContent();
    m_traffic = TrafficContent();
    m_camera.forgetVehicle();
    m_ground.markDirty();
}

std::optional<MapView::Labelled> MapView::labelled(const std::optional<LatLong> &place, const QString &label)
{
    return place ? std::optional(Labelled{mercator::project(*place), label}) : std::nullopt;
}

std::optional<QPointF> MapView::placeOf(const std::optional<Labelled> &one)
{
    return one ? std::optional(one->metres) : std::nullopt;
}

void MapView::setMark(const std::optional<LatLong> &place, const QString &label)
{
    m_mark = labelled(place, label);
    update();
}

void MapView::setTarget(const std::optional<LatLong> &place, const QString &label)
{
    auto target = labelled(place, label);
    if (target == m_target)
        return;
    m_target = std::move(target);
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
    m_ground.markDirty();
}

void MapView::setUnits(UnitSystem units)
{
    if (m_units == units)
        return;
    m_units = units;
    describe();
    m_ground.markDirty();
}

void MapView::setCoordinateFormat(CoordinateFormat format)
{
    m_coordinates = format;
    update();
}

std::optional<EdgeArrow> MapView::edgeArrow() const
{
    return edgeArrowOf(m_content, viewport(), m_units, QFontMetricsF(font()));
}

std::optional<LatLong> MapView::pointedPlace() const
{
    if (m_byKeys && hasFocus())
        return placeAt(QPointF(rect().center()));
    if (!m_pointer.position() && !hasFocus())
        return std::nullopt;
    return placeAt(m_pointer.position().value_or(QPointF(rect().center())));
}

void MapView::showPointer()
{
    if (!m_pointer.isDragging())
        showCursor();
    if (m_measure.isOn())
        update();
    else
        update(MapPainter::placeOfCoordinates(viewport(), fontMetrics(), widestCoordinates(m_coordinates)).toAlignedRect());
}

void MapView::paintEvent(QPaintEvent *)
{
    const bool moving = m_pointer.isDragging() || m_camera.isMoving();
    const QPixmap &ground = m_ground.picture({m_content, m_fence, viewport(), moving}, *this);
    QPainter painter(this);
    painter.drawPixmap(0, 0, ground);
    painter.setRenderHint(QPainter::Antialiasing);
    MapPainter map(painter, m_content, viewport(), palette());
    TrafficPainter(painter, viewport(), palette()).paint(m_traffic, m_units);
    if (m_target)
        map.paintTarget(m_target->metres, m_target->label);
    map.paintVehicles();
    if (m_mark)
        map.paintMark(m_mark->metres, m_mark->label);
    if (m_measure.isOn())
        MeasurePainter(painter, viewport(), palette()).paint(m_measure, pointedPlace(), m_units);
    map.paintLegends(m_ground.tiles(), m_units);
    if (const auto arrow = edgeArrow())
        paintEdgeArrow(painter, *arrow, palette());
    if (isCentreMarked())
        map.paintCentre();
    if (const auto place = pointedPlace())
        map.paintCoordinates(coordinatesText(place->latitude, place->longitude, m_coordinates));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void MapView::resizeEvent(QResizeEvent *)
{
    m_camera.setSize(size());
}

void MapView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_ground.markDirty();
    QWidget::changeEvent(event);
}

void MapView::connectPointer()
{
    setAttribute(Qt::WA_AcceptTouchEvents);
    connect(&m_pointer, &MapPointer::moved, this, &MapView::showPointer);
    connect(&m_pointer, &MapPointer::dragBegan, &m_camera, &MapCamera::hold);
    connect(&m_pointer, &MapPointer::dragged, &m_camera, &MapCamera::drag);
    connect(&m_pointer, &MapPointer::dragEnded, this, [this] {
        m_camera.letGo();
        showCursor();
        m_ground.markDirty(); // finely
    });
    connect(&m_pointer, &MapPointer::clicked, this, &MapView::click);
    connect(&m_pointer, &MapPointer::held, this, [this](const QPointF &pixel) { openMenu(pixel.toPoint()); });
    connect(&m_pointer, &MapPointer::pinched, &m_camera, &MapCamera::pinch);
}

/// Fingers are read here; Qt would make a mouse of the first one only.
bool MapView::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        if (m_pointer.handleTouch(*static_cast<QTouchEvent *>(event), *this)) {
            event->accept();
            return true;
        }
        break;
    case QEvent::ToolTip: showToolTip(*static_cast<QHelpEvent *>(event)); return true;
    default: break;
    }
    return QWidget::event(event);
}

void MapView::showToolTip(const QHelpEvent &event)
{
    const auto arrow = edgeArrow();
    if (!arrow || !arrow->contains(event.pos()))
        return QToolTip::hideText();
    const QString keys = m_followKeys ? m_followKeys() : QString();
    const QString where = tr("The vehicle is beyond the map, %1 from its centre.").arg(arrow->distance);
    const QString how = keys.isEmpty() ? tr("A click centres the map on it.")
                                       : tr("A click or %1 centres the map on it.").arg(keys);
    QToolTip::showText(event.globalPos(), plainTip(where + QLatin1Char(' ') + how), this);
}

void MapView::setByKeys(bool byKeys)
{
    if (m_byKeys == byKeys)
        return;
    m_byKeys = byKeys;
    update();
}

void MapView::focusInEvent(QFocusEvent *event)
{
    const Qt::FocusReason reason = event->reason();
    if (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason)
        setByKeys(true);
    QWidget::focusInEvent(event);
}

void MapView::mousePressEvent(QMouseEvent *event)
{
    setByKeys(false);
    if (event->button() != Qt::LeftButton)
        return;
    m_pointer.press(event->position());
    setCursor(Qt::ClosedHandCursor);
}

void MapView::mouseMoveEvent(QMouseEvent *event)
{
    setByKeys(false);
    m_pointer.moveTo(event->position());
}

void MapView::mouseReleaseEvent(QMouseEvent *event)
{
    m_pointer.release(event->position());
}

void MapView::click(const QPointF &pixel)
{
    const auto arrow = edgeArrow();
    if (isOnNorth(pixel))
        m_camera.rotation().action()->setChecked(false);
    else if (arrow && arrow->contains(pixel))
        followVehicle();
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
        const QPointF way = viewport().toPixels(other.metres) - pixel;
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
        m_camera.zoom(event->position(), 2);
}

void MapView::leaveEvent(QEvent *)
{
    m_pointer.leave();
}

void MapView::wheelEvent(QWheelEvent *event)
{
    constexpr double kUnitsPerLevel = 240; // two notches of a usual wheel
    m_camera.zoom(event->position(), std::exp2(event->angleDelta().y() / kUnitsPerLevel));
    event->accept();
}

void MapView::keyPressEvent(QKeyEvent *event)
{
    if (m_measure.handleKey(*event, pointedPlace()))
        return;
    const auto pan = [this](double right, double down) { m_camera.pan({right * kKeyStep, down * kKeyStep}); };
    switch (event->key()) {
    case Qt::Key_Left: pan(1, 0); break;
    case Qt::Key_Right: pan(-1, 0); break;
    case Qt::Key_Up: pan(0, 1); break;
    case Qt::Key_Down: pan(0, -1); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: zoomBy(kKeyZoom); break;
    case Qt::Key_Minus: zoomBy(1 / kKeyZoom); break;
    case Qt::Key_Home: followVehicle(); break;
    default: return QWidget::keyPressEvent(event);
    }
    setByKeys(true);
}

} // namespace skyseal::ui

#include "moc_map_view.cpp"
