#include "ui/replay/replay_timeline.h"

#include "core/vehicle/flight_modes.h"
#include "ui/replay/link_event_text.h"
#include "ui/replay/timeline_access.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QDateTime>
#include <QtCore/QLocale>
#include <QtGui/QHelpEvent>
#include <QtGui/QKeyEvent>
#include <QtGui/QMouseEvent>
#include <QtGui/QPainter>
#include <QtGui/QPainterPath>
#include <QtWidgets/QToolTip>

#include <algorithm>
#include <limits>

namespace skyseal::ui {

using std::chrono::milliseconds;

namespace {

constexpr int kHeight = 28, kLineHeight = 8, kMargin = 6; ///< pixels
constexpr qreal kNear = 4;                                ///< pixels from a mark to the pointer
constexpr int kSecond = 1000;
constexpr std::size_t kMostSpoken = 50; ///< marks in the description for screen readers

QString timeText(Duration at)
{
    return durationText(seconds(at));
}

/// Milliseconds on the time line, as the slider counts them.
int replayMilliseconds(Duration at)
{
    return static_cast<int>(
        std::clamp<std::int64_t>(std::chrono::floor<milliseconds>(at).count(), 0, std::numeric_limits<int>::max()));
}

QColor inkOf(const QWidget &widget)
{
    return widget.palette().color(widget.isEnabled() ? QPalette::WindowText : QPalette::PlaceholderText);
}

/// The area inside the frame of the line.
QRectF innerOf(const QRectF &line)
{
    return line.adjusted(1, 1, -1, -1);
}

} // namespace

ReplayTimeline::ReplayTimeline(QWidget *parent) : QAbstractSlider(parent)
{
    installTimelineAccess();
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMouseTracking(true);
    setAccessibleName(tr("Position of the replay"));
    setSingleStep(kSecond);
    setPageStep(10 * kSecond);
    setRange(0, 0);
    setEnabled(false);
    connect(this, &QAbstractSlider::actionTriggered, this, [this] { seekTo(sliderPosition()); }); // by keys and the wheel
}

void ReplayTimeline::setIndex(std::shared_ptr<const tlog::LogIndex> index)
{
    if (index == m_index)
        return;
    m_index = std::move(index);
    setMaximum(m_index ? replayMilliseconds(m_index->length) : 0);
    setEnabled(maximum() > 0);
    collectMarks();
    update();
}

void ReplayTimeline::showPosition(Duration position)
{
    if (!isSliderDown())
        setValue(replayMilliseconds(position));
}

void ReplayTimeline::collectMarks()
{
    m_marks.clear();
    if (!m_index) {
        setAccessibleDescription(tr("The recording is being read"));
        return;
    }
    for (const tlog::LogSpan &gap : m_index->gaps)
        m_marks.push_back({gap.from, gap.to,
                           tr("%1 nothing recorded for %2").arg(timeText(gap.from), timeText(gap.to - gap.from)),
                           Mark::Kind::Gap});
    const bool several = m_index->vehicles.size() > 1;
    const auto ofVehicle = [&](std::uint8_t systemId) { return several ? tr(" (vehicle %1)").arg(systemId) : QString(); };
    for (const tlog::ArmedSpan &armed : m_index->armed)
        m_marks.push_back(
            {armed.span.from, armed.span.to,
             tr("%1 armed until %2").arg(timeText(armed.span.from), timeText(armed.span.to)) + ofVehicle(armed.systemId),
             Mark::Kind::Armed});
    for (const tlog::ModeChange &mode : m_index->modes) {
        const std::string name = vehicle::modeName({mode.type, mode.autopilot}, mode.baseMode, mode.customMode);
        m_marks.push_back({mode.at, mode.at, tr("%1 mode %2").arg(timeText(mode.at), fromStd(name)) + ofVehicle(mode.systemId),
                           Mark::Kind::Mode});
    }
    collectSuites();
    std::ranges::stable_sort(m_marks, {}, &Mark::from);
    describeMarks();
}

/// The links are named if there are several.
void ReplayTimeline::collectSuites()
{
    const std::vector<tlog::SuiteMark> &suites = m_index->suites;
    const bool several = std::ranges::any_of(
        suites, [&](const tlog::SuiteMark &mark) { return mark.event.peer != suites.front().event.peer; });
    for (const tlog::SuiteMark &mark : suites) {
        const bool switched = mark.event.kind == tlog::LinkEvent::Kind::Switched;
        const bool isPlain = mark.event.kind == tlog::LinkEvent::Kind::Plain;
        QString text = isPlain ? tr("%1 vehicle %2 in plain MAVLink").arg(timeText(mark.at), fromStd(mark.event.peer))
                               : (switched ? tr("%1 switched to %2") : tr("%1 sealed with %2"))
                                     .arg(timeText(mark.at), suiteNameOf(mark.event.suite));
        if (several && !isPlain)
            text += tr(" (link to %1)").arg(fromStd(mark.event.peer));
        const auto known = crypto::suiteFromName(mark.event.suite);
        m_marks.push_back({mark.at, mark.at, text, Mark::Kind::Suite, suiteColor(known.value_or(crypto::SuiteId::None))});
    }
}

void ReplayTimeline::describeMarks()
{
    QStringList spoken;
    if (const QString unreadable = unreadableEventsText(*m_index); !unreadable.isEmpty())
        spoken << unreadable;
    for (const Mark &mark : m_marks) {
        if (&mark - m_marks.data() == static_cast<std::ptrdiff_t>(kMostSpoken)) {
            spoken << tr("and %1 more").arg(m_marks.size() - kMostSpoken);
            break;
        }
        spoken << mark.text;
    }
    setAccessibleDescription(spoken.join(QStringLiteral("; ")));
}

QRectF ReplayTimeline::lineRect() const
{
    return {qreal(kMargin), (height() - kLineHeight) / 2.0, qreal(width() - 2 * kMargin), qreal(kLineHeight)};
}

qreal ReplayTimeline::pixelOf(Duration at) const
{
    const QRectF line = lineRect();
    return maximum() > 0 ? line.left() + line.width() * std::clamp(seconds(at) * kSecond / maximum(), 0.0, 1.0) : line.left();
}

int ReplayTimeline::millisecondsAt(int x) const
{
    const QRectF line = lineRect();
    return static_cast<int>(std::clamp((x - line.left()) / std::max(1.0, line.width()), 0.0, 1.0) * maximum());
}

QString ReplayTimeline::textAt(int x) const
{
    if (!m_index || maximum() == 0)
        return {};
    const milliseconds at(millisecondsAt(x));
    QStringList lines{timeText(at)};
    if (m_index->first) {
        const auto recorded = std::chrono::floor<milliseconds>(m_index->first->time_since_epoch()) + at;
        const QDateTime time = QDateTime::fromMSecsSinceEpoch(recorded.count());
        lines[0] += QStringLiteral(" · ") + QLocale().toString(time, QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    }
    for (const Mark &mark : m_marks) {
        if (pixelOf(mark.from) - kNear <= x && x <= pixelOf(mark.to) + kNear)
            lines << mark.text;
    }
    constexpr qsizetype kMostLines = 8;
    if (lines.size() > kMostLines)
        lines = lines.mid(0, kMostLines - 1) << tr("and %1 more").arg(lines.size() - kMostLines + 1);
    return lines.join(QLatin1Char('\n'));
}

QSize ReplayTimeline::sizeHint() const
{
    return {400, std::max(kHeight, leastTarget(*this))};
}

QSize ReplayTimeline::minimumSizeHint() const
{
    return {120, std::max(kHeight, leastTarget(*this))};
}

void ReplayTimeline::seekTo(int place)
{
    setValue(place);
    Q_EMIT seekRequested(milliseconds(value()));
}

/// Gaps count at both of their ends, so that one key leads behind them.
void ReplayTimeline::goToMark(bool forward)
{
    std::vector<int> places{0, maximum()};
    for (const Mark &mark : m_marks) {
        places.push_back(replayMilliseconds(mark.from));
        places.push_back(replayMilliseconds(mark.to));
    }
    std::ranges::sort(places);
    if (forward) {
        const auto next = std::ranges::upper_bound(places, value());
        seekTo(next == places.end() ? maximum() : *next);
    } else {
        const auto next = std::ranges::lower_bound(places, value());
        seekTo(next == places.begin() ? 0 : *std::prev(next));
    }
}

void ReplayTimeline::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    setSliderDown(true);
    seekTo(millisecondsAt(event->position().toPoint().x()));
}

void ReplayTimeline::mouseMoveEvent(QMouseEvent *event)
{
    if (isSliderDown())
        seekTo(millisecondsAt(event->position().toPoint().x()));
}

void ReplayTimeline::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        setSliderDown(false);
}

void ReplayTimeline::keyPressEvent(QKeyEvent *event)
{
    const bool left = event->key() == Qt::Key_Left, right = event->key() == Qt::Key_Right;
    if ((left || right) && event->modifiers().testFlag(Qt::ControlModifier))
        goToMark(right);
    else
        QAbstractSlider::keyPressEvent(event);
}

bool ReplayTimeline::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QAbstractSlider::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), textAt(help->pos().x()), this);
    return true;
}

void ReplayTimeline::paintMark(QPainter &painter, const Mark &mark) const
{
    const StateColors &colors = stateColors(palette());
    const QRectF line = lineRect(), inner = innerOf(line);
    const qreal from = pixelOf(mark.from), to = std::max(pixelOf(mark.to), from + 1);
    switch (mark.kind) {
    case Mark::Kind::Gap:
        painter.fillRect(QRectF(from, inner.top(), to - from, inner.height()), palette().color(QPalette::Window));
        painter.fillRect(QRectF(from, inner.top(), to - from, inner.height()), QBrush(inkOf(*this), Qt::BDiagPattern));
        break;
    case Mark::Kind::Armed: painter.fillRect(QRectF(from, line.bottom() + 2, to - from, 3), colors.warning); break;
    case Mark::Kind::Mode: {
        QPainterPath pointer(QPointF(from, line.top() - 1));
        pointer.lineTo(from - 4, line.top() - 7);
        pointer.lineTo(from + 4, line.top() - 7);
        pointer.closeSubpath();
        painter.fillPath(pointer, colors.accent);
        break;
    }
    case Mark::Kind::Suite: {
        const QPointF middle(from, line.bottom() + 5);
        painter.setPen(QPen(inkOf(*this), 1));
        painter.setBrush(mark.color);
        painter.drawPolygon(
            QPolygonF{middle - QPointF(0, 4), middle + QPointF(4, 0), middle + QPointF(0, 4), middle - QPointF(4, 0)});
        break;
    }
    }
}

void ReplayTimeline::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const StateColors &colors = stateColors(palette());
    const QColor ink = inkOf(*this);
    const QRectF line = lineRect();
    painter.setPen(QPen(colors.edge, 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(line.adjusted(0.5, 0.5, -0.5, -0.5));
    const QRectF inner = innerOf(line);
    const qreal here = pixelOf(milliseconds(value()));
    painter.fillRect(QRectF(inner.topLeft(), QPointF(here, inner.bottom())), palette().color(QPalette::Highlight));
    // Those of the suites last: the bar of a time armed must not cover them.
    for (const bool suites : {false, true}) {
        for (const Mark &mark : m_marks) {
            if ((mark.kind == Mark::Kind::Suite) == suites)
                paintMark(painter, mark);
        }
    }
    if (isEnabled()) {
        painter.setPen(QPen(palette().color(QPalette::Window), 1));
        painter.setBrush(ink);
        painter.drawRoundedRect(QRectF(here - 3, line.top() - 4, 6, kLineHeight + 8), 2, 2);
    }
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

} // namespace skyseal::ui

#include "moc_replay_timeline.cpp"
