#include "ui/status/status_strip.h"

#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/engine/text/state_text.h"
#include "core/mavlink/enums.h"
#include "ui/text/lock_face.h"
#include "ui/text/command_age.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/instrument_style.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QEvent>
#include <QtGui/QPainter>

#include <algorithm>
#include <cmath>

namespace skyseal::ui {

using engine::Security;

namespace {

const QString kDot = QStringLiteral(" · ");

} // namespace

StatusStrip::StatusStrip(QWidget *parent)
    : QWidget(parent), m_vehicle(new StripItem(tr("Vehicle"), this)), m_armed(new StripItem(tr("Armed state"), this)),
      m_mode(new StripItem(tr("Flight mode"), this)), m_gps(new StripItem(tr("GPS"), this)),
      m_battery(new StripItem(tr("Battery"), this)), m_sharing(new StripItem(tr("Other stations"), this)),
      m_lock(new StripItem(tr("Link security"), this)), m_link(new StripItem(tr("Link quality"), this))
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_vehicle->setObjectName(QStringLiteral("stripVehicle"));
    m_armed->setObjectName(QStringLiteral("stripArmed"));
    m_mode->setObjectName(QStringLiteral("stripMode"));
    m_gps->setObjectName(QStringLiteral("stripGps"));
    m_battery->setObjectName(QStringLiteral("stripBattery"));
    m_sharing->setObjectName(QStringLiteral("stripSharing"));
    m_lock->setObjectName(QStringLiteral("stripLock"));
    m_link->setObjectName(QStringLiteral("stripLink"));

    m_armed->setStrong(true);
    m_armed->setSamples({tr("DISARMED")});
    m_gps->setSamples({tr("RTK fixed") + kDot + tr("%1 sat").arg(88), QString(), QString()});
    m_battery->setSamples({QStringLiteral("88.8 V · 100 %"), QStringLiteral("100 %")});
    m_sharing->setClickable(true);
    m_sharing->setStrong(true);
    m_sharing->hide();
    m_lock->setClickable(true);
    m_vehicle->setClickable(true);
    m_link->setClickable(true);
    m_link->setLine(true);
    connect(m_lock, &QAbstractButton::clicked, this, &StatusStrip::lockClicked);
    connect(m_vehicle, &QAbstractButton::clicked, this, &StatusStrip::vehicleClicked);
    connect(m_link, &QAbstractButton::clicked, this, &StatusStrip::linkClicked);
    connect(m_sharing, &QAbstractButton::clicked, this, &StatusStrip::sharingClicked);
    for (StripItem *item : {m_vehicle, m_armed, m_mode, m_gps, m_battery, m_sharing, m_lock, m_link})
        connect(item, &StripItem::widthChanged, this, &StatusStrip::arrange);
    showViewState({});
}

void StatusStrip::showViewState(const ViewState &view)
{
    m_sharing->setTextColor(stateColors(palette()).warning); // the theme may have changed
    showVehicle(view);
    showLock(view);
    showLink(view);
}

void StatusStrip::showSharing(const QString &word, const QString &sentence)
{
    m_sharing->setVisible(!word.isEmpty());
    m_sharing->setContent({word, tr("Shared")}, QStringLiteral("warning"));
    m_sharing->setToolTip(tr("%1\nA click opens the links.").arg(sentence));
    arrange();
}

void StatusStrip::showVehicle(const ViewState &view)
{
    const StateColors &colors = stateColors(palette());
    const bool present = view.vehicle != nullptr;
    for (StripItem *item : {m_armed, m_mode, m_gps, m_battery})
        item->setVisible(present);
    if (!present) {
        m_vehicle->setContent({tr("No vehicle")}, QStringLiteral("vehicle"));
        m_vehicle->setTextColor(colors.dim);
        arrange();
        return;
    }
    const auto &state = view.vehicle->state;
    const QColor aged = view.stale() ? colors.dim : QColor();
    m_vehicle->setContent({tr("Vehicle %1").arg(state.systemId), QString::number(state.systemId)}, QStringLiteral("vehicle"));
    m_vehicle->setToolTip(engine::vehicleTypeText(state.type)
                          + (state.firmware.empty() ? QString() : kDot + fromStd(state.firmware)));
    m_vehicle->setTextColor(aged);
    m_armed->setContent({state.armed ? tr("ARMED") : tr("DISARMED")},
                        state.armed ? QStringLiteral("armed") : QStringLiteral("disarmed"));
    m_armed->setTextColor(view.stale() ? colors.dim : state.armed ? colors.alarm : QColor());
    m_mode->setContent({state.mode.empty() ? dash() : fromStd(state.mode)});
    m_mode->setTextColor(aged);

    const QString fix = fixText(state.gpsFix);
    const QString satellites = state.satellites < 0 ? QString() : tr("%1 sat").arg(state.satellites);
    m_gps->setContent({satellites.isEmpty() ? fix : fix + kDot + satellites, fix, fix}, QStringLiteral("satellite"));
    m_gps->setTextColor(view.stale()                                                                ? colors.dim
                            : state.gpsFix >= 0 && state.gpsFix < int(mavlink::GPS_FIX_TYPE_3D_FIX) ? colors.warning
                                                                                                    : QColor());
    m_gps->setToolTip(tr("HDOP %1").arg(number(state.hdop, 1)));

    const QString volts = number(state.batteryVoltage, 1) + QStringLiteral(" V");
    const QString percent = number(state.batteryPercent, 0) + QStringLiteral(" %");
    const bool low = state.batteryPercent <= kLowBatteryPercent;
    m_battery->setContent({low ? volts + kDot + percent + kDot + tr("low") : volts + kDot + percent, percent},
                          QStringLiteral("battery"));
    m_battery->setTextColor(view.stale() ? colors.dim : low ? colors.alarm : QColor());
    m_battery->setToolTip(batteriesText(state));
    arrange();
}

void StatusStrip::showLock(const ViewState &view)
{
    const StateColors &colors = stateColors(palette());
    const LockFace face = lockFaceOf(view);
    m_lock->setContent(face.variants, face.icon);
    m_lock->setToolTip(face.toolTip);
    m_lock->setStrong(face.security == Security::UnderAttack || face.security == Security::Plain);
    switch (face.security) {
    case Security::Nothing:
        m_lock->setTextColor(face.lost ? colors.warning : colors.dim);
        m_lock->setIconColor(colors.dim);
        break;
    case Security::Plain:
        m_lock->setTextColor(colors.warning);
        m_lock->setIconColor(colors.warning);
        break;
    case Security::UnderAttack:
        m_lock->setTextColor(colors.alarm);
        m_lock->setIconColor(colors.alarm);
        break;
    case Security::Sealed:
    case Security::Switching:
        m_lock->setTextColor({});
        m_lock->setIconColor(face.suite ? suiteColor(*face.suite) : QColor());
        break;
    }
}

void StatusStrip::showLink(const ViewState &view)
{
    const StateColors &colors = stateColors(palette());
    if (!view.vehicle) {
        m_link->setSamples({});
        m_link->setContent({tr("No link"), tr("No link"), dash()}, QStringLiteral("link"));
        m_link->setTextColor(colors.dim);
        m_link->setToolTip({});
        noteQuality(view, vehicle::kUnknown);
        return;
    }
    const QString widest = tr("Link OK %1").arg(QStringLiteral("100.0 %"));
    m_link->setSamples(
        {widest + QStringLiteral(" · 888 ms · 8.8 s"), widest + QStringLiteral(" · 888 ms"), QStringLiteral("100.0 %")});
    const auto &state = view.vehicle->state;
    const QString age = tr("%1 s").arg(number(state.messageAge, 1));
    if (state.lost || view.stale() || (!view.session && view.vehicle->session)) {
        m_link->setContent({tr("Link lost") + kDot + age, tr("Lost") + kDot + age, age}, QStringLiteral("link"));
        m_link->setTextColor(colors.alarm);
        noteQuality(view, 0);
        return;
    }
    const double arrived = 100.0 - (view.session ? view.session->lossPercent : view.vehicle->lossPercent);
    noteQuality(view, arrived);
    const double latency = std::isfinite(state.latency)             ? state.latency
        : view.session && view.session->stats.roundTrip.count() > 0 ? seconds(view.session->stats.roundTrip)
                                                                    : vehicle::kUnknown;
    const QString percent = number(arrived, 1) + QStringLiteral(" %");
    // In the order of the item's numbers, which have no labels there.
    const QString tip = tr("%1 of the frames arrived\n%2 latency\n%3 since the newest message\n%4 frames/s, %5 lost")
                            .arg(percent, latencyText(latency), age, number(view.vehicle->framesPerSecond, 0),
                                 grouped(state.sequence.lost))
        + QLatin1Char('\n') + tr("Lowest in the last minute: %1 %").arg(number(m_link->line().lowest(), 1));
    const auto commandAge = commandAgeOf(view);
    m_link->setToolTip(commandAge ? tip + QLatin1Char('\n') + commandAge->sentence + QLatin1Char('\n') + commandAge->limits
                                  : tip);
    if (commandAge && commandAge->late) {
        m_link->setContent({commandAge->brief, commandAge->brief, commandAge->brief}, QStringLiteral("link"));
        m_link->setTextColor(commandAge->ignored ? colors.alarm : colors.warning);
        return;
    }
    const bool poor = arrived < 90;
    const QString word = poor ? tr("Link poor %1") : tr("Link OK %1");
    m_link->setContent({word.arg(percent) + kDot + latencyText(latency) + kDot + age,
                        word.arg(percent) + kDot + latencyText(latency), percent},
                       QStringLiteral("link"));
    m_link->setTextColor(poor ? colors.warning : QColor());
}

/// The line goes on through an interruption, at 0 %, and begins anew with another vehicle.
void StatusStrip::noteQuality(const ViewState &view, double percent)
{
    const int system = view.vehicle ? view.vehicle->state.systemId : -1;
    if (system != m_lineOf) {
        m_link->clearLine();
        m_lineOf = system;
    }
    if (view.vehicle && view.snapshot)
        m_link->addSample(view.snapshot->time, percent);
    const double lowest = m_link->line().lowest();
    const QString spoken = std::isfinite(lowest) ? tr("Lowest in the last minute: %1 %").arg(number(lowest, 1)) : QString();
    if (m_link->accessibleDescription() != spoken) // each one set is an event for assistive technology
        m_link->setAccessibleDescription(spoken);
}

void StatusStrip::arrange()
{
    // Order in which the items shorten.
    StripItem *const order[] = {m_link, m_lock, m_gps, m_battery, m_vehicle, m_sharing, m_link, m_lock, m_gps, m_mode};
    StripItem *const left[] = {m_vehicle, m_armed, m_mode, m_gps, m_battery};
    StripItem *const right[] = {m_link, m_lock, m_sharing};
    StripItem *const all[] = {m_vehicle, m_armed, m_mode, m_gps, m_battery, m_sharing, m_lock, m_link};
    constexpr int kItems = std::size(all);
    int variants[kItems] = {};
    const auto total = [&] {
        int sum = 2 * kHalfGrid;
        for (int i = 0; i < kItems; ++i)
            sum += all[i]->isHidden() ? 0 : all[i]->widthOf(variants[i]);
        return sum;
    };
    for (StripItem *item : order) {
        if (total() <= width())
            break;
        for (int i = 0; i < kItems; ++i)
            if (all[i] == item && variants[i] + 1 < item->variantCount())
                ++variants[i];
    }
    for (int i = 0; i < kItems; ++i)
        all[i]->setVariant(variants[i]);

    int x = kHalfGrid;
    for (StripItem *item : left) {
        if (item->isHidden())
            continue;
        item->setGeometry(x, 0, item->sizeHint().width(), height());
        x += item->width();
    }
    int end = width() - kHalfGrid;
    for (StripItem *item : right) {
        if (item->isHidden())
            continue;
        const int wide = item->sizeHint().width();
        item->setGeometry(end - wide, 0, wide, height());
        end -= wide;
    }
}

QSize StatusStrip::sizeHint() const
{
    return {640, std::max(5 * kGrid, leastTarget(*this))};
}

QSize StatusStrip::minimumSizeHint() const
{
    return {320, std::max(5 * kGrid, leastTarget(*this))};
}

void StatusStrip::resizeEvent(QResizeEvent *)
{
    arrange();
}

void StatusStrip::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::FontChange)
        arrange();
    QWidget::changeEvent(event);
}

void StatusStrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const StateColors &colors = stateColors(palette());
    painter.fillRect(rect(), colors.panel);
    painter.fillRect(0, height() - 1, width(), 1, colors.line);
}

} // namespace skyseal::ui

#include "moc_status_strip.cpp"
