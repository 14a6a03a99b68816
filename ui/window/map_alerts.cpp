#include "ui/window/map_alerts.h"

#include "ui/alerts/alert_stack.h"
#include "ui/map/map_view.h"
#include "ui/settings.h"
#include "ui/window/view_selection.h"
#include "ui/window/window_dialogs.h"

#include <QtGui/QAction>

namespace skyseal::ui {

namespace {

constexpr int kTickMs = 1000;

/// The text of an alert without signs that a voice would name or swallow.
QString spokenText(const Alert &alert)
{
    QString text = alert.text;
    return text.replace(QStringLiteral(" → "), QStringLiteral(", "));
}

} // namespace

MapAlerts::MapAlerts(StationInterface &station, ViewSelection &selection, WindowDialogs &dialogs, MapView &map,
                     const Settings &settings)
    : QObject(map.parentWidget()), m_stack(new AlertStack(map)), m_goTo(new QAction(tr("Go to the a&lerts"), this))
{
    m_clock.start();
    m_speech.setOn(settings.speakAlerts);
    m_list.setValues(settings.values.list, settings.units);
    m_tick.setInterval(kTickMs);
    m_goTo->setObjectName(QStringLiteral("actionAlerts"));
    m_goTo->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_A);
    m_goTo->setEnabled(false);
    connect(m_goTo, &QAction::triggered, m_stack, &AlertStack::focusFirst);
    connect(&m_tick, &QTimer::timeout, this, [this] {
        m_list.expire(now());
        refresh();
    });
    connect(&selection, &ViewSelection::viewChanged, this, [this](const ViewState &view) {
        if (!view.isReplay())
            showView(view);
    });
    connect(&selection, &ViewSelection::liveChanged, this, &MapAlerts::showView);
    connect(&station, &StationInterface::modeChangeSent, this,
            [this](std::uint8_t systemId) { m_list.noteCommand(systemId, now()); });
    connect(&station, &StationInterface::eventOccurred, this, [this](const engine::Event &event) {
        m_list.handleEvent(event, now());
        refresh();
    });
    connect(m_stack, &AlertStack::dismissed, this, [this](AlertId id) {
        m_list.dismiss(id);
        refresh();
    });
    connect(m_stack, &AlertStack::remedyRequested, &dialogs, &WindowDialogs::openPairing); // only unknown agents have one
    connect(&dialogs, &WindowDialogs::settingsAccepted, this, [this](const Settings &changed) {
        m_speech.setOn(changed.speakAlerts);
        m_list.setValues(changed.values.list, changed.units);
    });
}

QList<QAction *> MapAlerts::actions() const
{
    return m_stack->actions();
}

double MapAlerts::now() const
{
    return static_cast<double>(m_clock.elapsed()) / 1000;
}

void MapAlerts::showView(const ViewState &live)
{
    m_list.showView(live, now());
    refresh();
}

void MapAlerts::refresh()
{
    for (const Alert &alert : m_list.takeRaised())
        m_speech.say(spokenText(alert), alert.severity == AlertSeverity::Severe);
    std::vector<Alert> alerts = m_list.alerts();
    m_goTo->setEnabled(!alerts.empty());
    m_goTo->setStatusTip(alerts.empty() ? tr("No alerts") : QString());
    if (m_list.hasMomentary() != m_tick.isActive())
        m_list.hasMomentary() ? m_tick.start() : m_tick.stop();
    Q_EMIT alertsShown(alerts);
    m_stack->showAlerts(std::move(alerts), now());
}

} // namespace skyseal::ui

#include "moc_map_alerts.cpp"
