#include "ui/security/suite_actions.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/engine/text/common_event_text.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"

#include <QtGui/QAction>
#include <QtGui/QActionGroup>

#include <algorithm>

namespace skyseal::ui {

using crypto::SuiteId;

SuiteActions::SuiteActions(StationInterface &station, QObject *parent, QSettings *store)
    : QObject(parent), m_station(station), m_group(new QActionGroup(this)), m_changeKeys(new QAction(this))
{
    if (store)
        m_choices.emplace(*store);
    for (const SuiteId suite : m_suites) {
        auto *action = new QAction(suiteDot(suite), suiteName(suite), this);
        action->setObjectName(QStringLiteral("suite_") + fromStd(crypto::suiteInfo(suite).name));
        action->setCheckable(true);
        if (m_actions.size() < 9)
            action->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | static_cast<Qt::Key>(Qt::Key_1 + m_actions.size())));
        m_group->addAction(action);
        connect(action, &QAction::triggered, this, [this, suite] { choose(suite); });
        m_actions.push_back(action);
    }
    m_group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    m_changeKeys->setObjectName(QStringLiteral("actionChangeKeys"));
    m_changeKeys->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_K);
    connect(m_changeKeys, &QAction::triggered, this, &SuiteActions::changeKeys);
    connect(&station, &StationInterface::eventOccurred, this, &SuiteActions::handleEvent);
    refresh();
}

QAction *SuiteActions::action(SuiteId suite) const
{
    const auto at = std::ranges::find(m_suites, suite);
    return at == m_suites.end() ? nullptr : m_actions[static_cast<std::size_t>(at - m_suites.begin())];
}

std::optional<SuiteId> SuiteActions::pending() const
{
    if (m_asked)
        return m_asked;
    return m_info ? m_info->pending : std::nullopt;
}

QString SuiteActions::noSession() const
{
    return m_recorded ? tr("a replay is shown") : m_plain ? tr("the link is not sealed") : tr("no sealed link yet");
}

QString SuiteActions::disabledReason(SuiteId suite) const
{
    if (!m_info)
        return noSession();
    if (m_held)
        return tr("a sweep is running");
    if (std::ranges::find(m_info->permitted, suite) != m_info->permitted.end())
        return {};
    if (crypto::suiteInfo(suite).strength < crypto::suiteInfo(m_weakest).strength)
        return tr("weaker than allowed");
    if (crypto::suiteInfo(suite).research && !m_researchAllowed)
        return tr("research suites are off");
    if (std::ranges::find(m_info->peerOffered, suite) == m_info->peerOffered.end())
        return tr("not offered by the agent");
    return tr("not allowed here");
}

void SuiteActions::choose(SuiteId suite)
{
    if (m_info && suite != m_info->suite && disabledReason(suite).isEmpty()) {
        m_asked = suite;
        m_station.switchSuite(m_info->session, suite);
    }
    refresh(); // the mark returns to the suite in use
}

QString SuiteActions::freshKeysDisabledReason() const
{
    if (!m_info)
        return noSession();
    if (m_held)
        return tr("a sweep is running");
    return m_keysAsked || pending() ? tr("changing…") : QString();
}

void SuiteActions::changeKeys()
{
    if (!freshKeysDisabledReason().isEmpty())
        return;
    m_keysAsked = true;
    m_station.switchSuite(m_info->session, m_info->suite); // a switch to the suite in use makes new keys
    refresh();
}

void SuiteActions::showViewState(const ViewState &view)
{
    m_plain = view.vehicle && !view.session;
    m_recorded = view.vehicle && engine::isRecorded(*view.snapshot, *view.vehicle);
    if (!view.session) {
        // The end of a session is told while its vehicle is shown; a switch is told no longer than the session lasts.
        const bool isOfAnother = view.vehicle && view.vehicle->session != m_noteSession;
        if (!m_note.isEmpty() && (!m_noteIsProblem || isOfAnother))
            setNote({}, false);
        m_info.reset();
        m_asked.reset();
        m_keysAsked = false;
    } else {
        if (m_info && m_info->session != view.session->info.session) {
            m_asked.reset();
            m_keysAsked = false;
        }
        if ((!m_info || m_info->session != view.session->info.session) && !m_note.isEmpty())
            setNote({}, false); // of another session, or its end
        m_info = view.session->info;
    }
    takeUpChoices(view);
    refresh();
}

/// A session begins with the suite that both ends prefer. The choice that the operator made last for its peer takes its
/// place, unless that would weaken the session.
void SuiteActions::takeUpChoices(const ViewState &view)
{
    if (m_fresh.empty() || !view.station())
        return;
    for (const engine::SessionSnapshot &session : view.station()->sessions) {
        const channel::SessionInfo &info = session.info;
        const bool isFresh = std::erase(m_fresh, info.session) > 0;
        const auto chosen = isFresh && m_keeps && !m_held && m_choices ? m_choices->of(info.peer) : std::nullopt;
        if (!chosen || *chosen == info.suite)
            continue;
        const bool isShown = m_info && m_info->session == info.session;
        const bool isWeaker = crypto::suiteInfo(*chosen).strength < crypto::suiteInfo(info.suite).strength;
        if (isWeaker || std::ranges::find(info.permitted, *chosen) == info.permitted.end()) {
            if (isShown)
                setNote((isWeaker ? tr("Sealed with %1: %2, chosen last, is weaker")
                                  : tr("Sealed with %1: %2, chosen last, is not permitted now"))
                            .arg(suiteName(info.suite), suiteName(*chosen)),
                        false);
            continue;
        }
        if (isShown)
            m_asked = chosen;
        m_station.switchSuite(info.session, *chosen);
    }
}

void SuiteActions::handleEvent(const engine::Event &event)
{
    m_names.note(event);
    if (const auto *up = std::get_if<channel::SessionUp>(&event))
        m_fresh.push_back(up->session);
    else if (const auto *over = std::get_if<channel::SessionDown>(&event))
        std::erase(m_fresh, over->session);
    if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        if (!m_info || done->session != m_info->session)
            return;
        const bool committed = done->failure == channel::SwitchFailure::None;
        if (committed && m_asked == done->to && !done->byPeer && m_choices && m_keeps)
            m_choices->remember(m_info->peer, done->to);
        if (done->rekey && (!m_keysAsked || done->byPeer))
            return; // an automatic change of keys
        if (!done->rekey)
            m_asked.reset(); // an abandoned change of keys does not answer the request
        m_info->pending.reset();
        m_keysAsked = m_keysAsked && done->byPeer;
        if (committed) {
            m_info->suite = done->to; // the suite in use, for a change of keys
            m_info->epoch = done->epoch;
        }
        setNote(engine::channelEventText(*done, m_names).sentence, !committed, done->session);
        refresh();
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        const bool wanted = m_held && down->reason == channel::DownReason::Closed; // by the sweep
        if (wanted)
            setNote({}, false);
        else if (m_info && down->session == m_info->session && down->reason != channel::DownReason::PeerRestarted)
            setNote(engine::channelEventText(*down, m_names).sentence, true, down->session);
    }
}

void SuiteActions::setResearchAllowed(bool allowed)
{
    m_researchAllowed = allowed;
    refresh();
}

void SuiteActions::setHeld(bool held)
{
    m_held = held;
    refresh();
}

void SuiteActions::setWeakest(SuiteId suite)
{
    m_weakest = suite;
    refresh();
}

void SuiteActions::startOver()
{
    m_names = {};
    setNote({}, false);
}

void SuiteActions::setNote(const QString &note, bool problem, std::optional<channel::SessionId> session)
{
    m_note = note;
    m_noteSession = session;
    m_noteIsProblem = problem;
    Q_EMIT noteChanged();
}

void SuiteActions::refresh()
{
    bool any = false;
    const auto underWay = pending();
    for (std::size_t i = 0; i < m_suites.size(); ++i) {
        const SuiteId suite = m_suites[i];
        QAction *action = m_actions[i];
        const bool inUse = m_info && m_info->suite == suite;
        const QString why = disabledReason(suite);
        QString text = suiteName(suite);
        if (underWay == suite && !inUse)
            text += QStringLiteral(" · ") + tr("switching…");
        else if (m_info && !why.isEmpty())
            text += QStringLiteral(" · ") + why;
        const QString tip = why.isEmpty() ? suiteName(suite) : tr("%1: %2").arg(suiteName(suite), why);
        const bool enabled = why.isEmpty() && (!(underWay || m_keysAsked) || inUse || underWay == suite);
        if (action->text() == text && action->toolTip() == tip && action->isEnabled() == enabled
            && action->isChecked() == inUse)
            continue;
        action->setText(text);
        action->setToolTip(tip);
        action->setStatusTip(tip);
        action->setEnabled(enabled);
        action->setChecked(inUse);
        any = true;
    }
    if (any)
        Q_EMIT changed();
    refreshChangeKeys();
}

void SuiteActions::refreshChangeKeys()
{
    const QString why = freshKeysDisabledReason();
    const QString text = tr("Change keys &now");
    m_changeKeys->setText(m_info && !why.isEmpty() ? text + QStringLiteral(" · ") + why : text);
    m_changeKeys->setToolTip(why.isEmpty() ? tr("New keys for the suite in use, without interrupting the link") : why);
    m_changeKeys->setStatusTip(m_changeKeys->toolTip());
    m_changeKeys->setEnabled(why.isEmpty());
}

} // namespace skyseal::ui

#include "moc_suite_actions.cpp"
