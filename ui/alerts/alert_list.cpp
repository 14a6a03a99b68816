#include "ui/alerts/alert_list.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/event_text.h"
#include "core/engine/text/state_text.h"
#include "core/link/address_text.h"
#include "core/mavlink/enums.h"
#include "ui/text/aircraft_text.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <tuple>
#include <utility>

namespace skyseal::ui {

namespace {

/// The translation context of this file.
struct AlertListText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::AlertList)
};

constexpr double kVeryLowBatteryPercent = 10;
constexpr double kBatteryRise = 3;     ///< percent above the limit that end the alert, against a value that swings
constexpr double kFailsafeTextAge = 5; ///< seconds before the failsafe
constexpr unsigned kWorseFactor = 10;  // lupdate takes the "std::" of a variable here for the scope of the next function
constexpr double kSlowestAnswer = 30;  ///< seconds

QString ageText(double seconds)
{
    return seconds < 60 ? AlertListText::tr("%1 s").arg(number(seconds, 0)) : durationText(seconds);
}

QString framesText(std::uint64_t count, const QString &one, const QString &many)
{
    return count == 1 ? one : many.arg(grouped(count));
}

} // namespace

void AlertList::showView(const ViewState &live, double now)
{
    if (!live.snapshot)
        return;
    if (m_snapshot && live.snapshot->number < m_snapshot->number)
        startOver(); // another station, as that of the demo
    m_snapshot = live.snapshot;
    m_inSweep = live.inSweep;
    m_selected = live.vehicle ? live.vehicle->state.systemId : 0;
    ++m_round;
    for (const engine::VehicleSnapshot &vehicle : m_snapshot->vehicles)
        showVehicle(vehicle, now);
    for (const Alert &alert : m_limits.check(live, now))
        raiseState(alert, now);
    showAttacks(*m_snapshot, now);
    showStorage(*m_snapshot, now);
    showUnknown(*m_snapshot, now);
    std::erase_if(m_entries, [this](const auto &one) { return one.second.alert.ongoing && one.second.round != m_round; });
    expire(now);
}

void AlertList::setValues(const ValueChoices &choices, UnitSystem units)
{
    m_units = units;
    m_limits.setChoices(choices, units);
}

void AlertList::startOver()
{
    LimitWatch limits = std::move(m_limits);
    const UnitSystem units = m_units;
    *this = AlertList();
    m_limits = std::move(limits);
    m_limits.startOver();
    m_units = units;
}

void AlertList::showVehicle(const engine::VehicleSnapshot &vehicle, double now)
{
    const vehicle::VehicleState &state = vehicle.state;
    const std::uint8_t id = state.systemId;
    if (state.messageAge > state.staleAfter)
        raiseState({{AlertKind::LinkLost, id},
                    AlertSeverity::Severe,
                    AlertListText::tr("Link lost %1").arg(ageText(state.messageAge)),
                    AlertListText::tr("Nothing has been received from the vehicle since. The last received values are shown.")},
                   now);
    const auto status = state.systemStatus;
    if (status == mavlink::MAV_STATE_CRITICAL || status == mavlink::MAV_STATE_EMERGENCY
        || status == mavlink::MAV_STATE_FLIGHT_TERMINATION) {
        const QString title = status == mavlink::MAV_STATE_CRITICAL ? AlertListText::tr("Failsafe")
            : status == mavlink::MAV_STATE_EMERGENCY                ? AlertListText::tr("Emergency")
                                                                    : AlertListText::tr("Flight terminated");
        const auto said = m_failsafeTexts.find(id);
        const QString reason = said == m_failsafeTexts.end() ? QString() : said->second.text;
        Alert failsafe{{AlertKind::Failsafe, id},
                       AlertSeverity::Severe,
                       reason.isEmpty() ? title : AlertListText::tr("%1: %2").arg(title, reason),
                       AlertListText::tr("The autopilot reports an abnormal state. The Messages panel may show the reason.")};
        failsafe.subject = status;
        raiseState(std::move(failsafe), now);
    } else if (const auto said = m_failsafeTexts.find(id);
               said != m_failsafeTexts.end() && now - said->second.time > kFailsafeTextAge) {
        m_failsafeTexts.erase(said);
    }
    if (const auto near = nearestOf(state); near && state.messageAge <= state.staleAfter) {
        Alert aircraft{
            {AlertKind::AircraftNear, id},
            AlertSeverity::Severe,
            AlertListText::tr("Aircraft near: %1").arg(near->name),
            AlertListText::tr("Within %1 of the vehicle, and less than %2 above or below it or at an unknown altitude. "
                              "The map shows it.")
                .arg(distanceFigure(kNearMetres, m_units).text(), distanceFigure(kNearMetresInHeight, m_units).text())};
        aircraft.subject = near->address;
        raiseState(std::move(aircraft), now);
    }
    const auto known = m_entries.find({AlertKind::LowBattery, id});
    const bool wasLow = known != m_entries.end();
    const bool wasVeryLow = wasLow && known->second.alert.severity == AlertSeverity::Severe;
    if (state.batteryPercent <= kLowBatteryPercent + (wasLow ? kBatteryRise : 0)) {
        const bool veryLow = state.batteryPercent <= kVeryLowBatteryPercent + (wasVeryLow ? kBatteryRise : 0);
        const QString text = veryLow ? AlertListText::tr("Battery very low: %1 %") : AlertListText::tr("Battery low: %1 %");
        raiseState({{AlertKind::LowBattery, id},
                    veryLow ? AlertSeverity::Severe : AlertSeverity::Warning,
                    text.arg(number(state.batteryPercent, 0)),
                    AlertListText::tr("As reported by the vehicle.")},
                   now);
    }
    showMode(vehicle, now);
}

void AlertList::showMode(const engine::VehicleSnapshot &vehicle, double now)
{
    const std::uint8_t id = vehicle.state.systemId;
    if (vehicle.state.mode.empty())
        return;
    const std::string before = std::exchange(m_modes[id], vehicle.state.mode);
    if (before.empty() || before == vehicle.state.mode)
        return;
    const auto commanded = m_commands.find(id);
    if (commanded != m_commands.end() && now - commanded->second <= kOwnCommand)
        return;
    raiseEvent({{AlertKind::ModeChanged, id},
                AlertSeverity::Warning,
                AlertListText::tr("Mode %1 → %2, not by this station").arg(engine::qt(before), engine::qt(vehicle.state.mode)),
                AlertListText::tr("The mode changed without a command from this station. The autopilot, the RC transmitter or "
                                  "another station changed it.")},
               now);
}

/// Forged frames are records with a wrong tag, and frames outside the session with the system id of this vehicle. They are
/// counted as the lock counts them, see LockFace.
void AlertList::showAttacks(const engine::Snapshot &snapshot, double now)
{
    std::map<std::uint8_t, Attack> attacks;
    for (const engine::SessionSnapshot &session : snapshot.sessions) {
        const std::uint8_t systemId = vehicleOf(session.info.session);
        const RefusedFrames refused = refusedFrames(session, m_refusals.lastMinute(systemId, now) > 0);
        attacks[systemId].forged += refused.forged;
        attacks[systemId].replayed += refused.replayed;
    }
    for (const auto &[systemId, total] : m_refusals.totals())
        if (m_refusals.lastMinute(systemId, now) > 0)
            attacks[systemId].forged += total;
    const QString details = AlertListText::tr(
        "All were refused. Counted since the link came up, as the Secure link panel does.");
    for (const auto &[systemId, attack] : attacks) {
        if (attack.forged > 0)
            raiseState({{AlertKind::ForgedFrames, systemId},
                        AlertSeverity::Warning,
                        framesText(attack.forged, AlertListText::tr("One forged frame"), AlertListText::tr("%1 forged frames")),
                        details,
                        attack.forged},
                       now);
        if (attack.replayed > 0)
            raiseState(
                {{AlertKind::ReplayedFrames, systemId},
                 AlertSeverity::Warning,
                 framesText(attack.replayed, AlertListText::tr("One replayed frame"), AlertListText::tr("%1 replayed frames")),
                 details,
                 attack.replayed},
                now);
    }
}

void AlertList::showStorage(const engine::Snapshot &snapshot, double now)
{
    if (!snapshot.recording.problem.empty()) {
        const engine::RecordingSnapshot &recording = snapshot.recording;
        const engine::Event event = engine::RecordingProblem{recording.file, recording.problem};
        raiseState({{AlertKind::NotRecording},
                    AlertSeverity::Warning,
                    AlertListText::tr("Not recording: %1").arg(reasonText(recording.problem)),
                    engine::eventText(event, m_names).sentence},
                   now);
    }
    if (!snapshot.storageProblem.empty()) {
        const engine::Event event = engine::CounterStorage{snapshot.storageProblem};
        raiseState({{AlertKind::CountersNotStored},
                    AlertSeverity::Warning,
                    AlertListText::tr("Counters not stored: %1").arg(reasonText(snapshot.storageProblem)),
                    engine::eventText(event, m_names).sentence},
                   now);
    }
    std::erase_if(m_notStoring, [&](channel::SessionId session) {
        return std::ranges::none_of(snapshot.sessions, [&](const auto &one) { return one.info.session == session; });
    });
    for (const channel::SessionId session : m_notStoring) {
        const engine::Event event = channel::PeerStorageChanged{session, true};
        raiseState({{AlertKind::AgentNotStoring, vehicleOf(session)},
                    AlertSeverity::Warning,
                    AlertListText::tr("%1: its disk may be full").arg(peerText(session)),
                    engine::eventText(event, m_names).sentence},
                   now);
    }
}

/// The station reports an unknown agent once a minute; in between its pictures tell that it still announces itself.
void AlertList::showUnknown(const engine::Snapshot &snapshot, double now)
{
    const auto reported = m_entries.find({AlertKind::UnknownAgent});
    if (!snapshot.unknownAgents.empty() && reported != m_entries.end())
        reported->second.heard = now;
}

void AlertList::handleEvent(const engine::Event &event, double now)
{
    m_names.note(event);
    m_refusals.handleEvent(event, now);
    if (const auto *result = std::get_if<vehicle::CommandResult>(&event)) {
        const auto sent = m_commands.find(result->systemId);
        if (result->outcome == vehicle::CommandOutcome::Accepted && sent != m_commands.end()
            && now - sent->second < kSlowestAnswer)
            noteCommand(result->systemId, now); // a slow vehicle changes its mode as late as it answers
    } else if (const auto *received = std::get_if<vehicle::TextReceived>(&event)) {
        const QString text = engine::qt(received->text.text);
        if (text.contains(QLatin1String("failsafe"), Qt::CaseInsensitive))
            m_failsafeTexts[received->systemId] = {text, now};
    } else if (const auto *done = std::get_if<channel::SwitchDone>(&event)) {
        handleSwitch(*done, event, now);
    } else if (const auto *storage = std::get_if<channel::PeerStorageChanged>(&event)) {
        if (storage->failed)
            m_notStoring.insert(storage->session);
        else
            m_notStoring.erase(storage->session);
    } else if (const auto *down = std::get_if<channel::SessionDown>(&event)) {
        m_notStoring.erase(down->session);
        if (down->reason == channel::DownReason::Cloned)
            raiseEvent({{AlertKind::KeysCloned, vehicleOf(down->session)},
                        AlertSeverity::Severe,
                        AlertListText::tr("%1: keys in use twice").arg(peerText(down->session)),
                        engine::eventText(event, m_names).sentence},
                       now);
    } else if (std::holds_alternative<channel::SessionUp>(event)) {
        m_entries.erase(AlertId{AlertKind::UnknownAgent}); // most likely it has been paired
    } else if (const auto *refused = std::get_if<channel::HandshakeRefused>(&event)) {
        if (refused->reason == channel::RefusalReason::UnknownPeer)
            raiseEvent({{AlertKind::UnknownAgent},
                        AlertSeverity::Warning,
                        AlertListText::tr("Unknown agent at %1").arg(engine::qt(link::toText(refused->path.remote))),
                        AlertListText::tr("%1. To pair with it, choose Pair or open Security → Keys and peers")
                            .arg(engine::eventText(event, m_names).sentence)},
                       now);
    }
}

void AlertList::handleSwitch(const channel::SwitchDone &done, const engine::Event &event, double now)
{
    const bool failed = done.failure != channel::SwitchFailure::None;
    if (m_inSweep || (done.rekey && !failed))
        return; // a sweep switches all the time, and fresh keys are routine
    const QString suite = engine::suiteText(done.to);
    raiseEvent({{AlertKind::SuiteSwitch, vehicleOf(done.session)},
                failed ? AlertSeverity::Warning : AlertSeverity::Information,
                !failed          ? AlertListText::tr("Switched to %1").arg(suite)
                    : done.rekey ? AlertListText::tr("Keys not changed: %1").arg(engine::switchFailureText(done.failure))
                                 : AlertListText::tr("Not switched to %1").arg(suite),
                engine::eventText(event, m_names).sentence},
               now);
}

std::uint8_t AlertList::vehicleOf(channel::SessionId session) const
{
    if (!m_snapshot)
        return 0;
    const auto heard = std::ranges::find_if(m_snapshot->vehicles, [&](const auto &one) { return one.session == session; });
    return heard == m_snapshot->vehicles.end() ? std::uint8_t(0) : heard->state.systemId;
}

QString AlertList::peerText(channel::SessionId session) const
{
    const std::string name = m_names.of(session);
    return name.empty() ? AlertListText::tr("The agent") : engine::qt(name);
}

void AlertList::raiseState(Alert alert, double now)
{
    const auto [at, isNew] = m_entries.try_emplace(alert.id);
    Entry &entry = at->second;
    const bool worse = !isNew && (alert.severity > entry.alert.severity || alert.subject != entry.alert.subject);
    alert.since = isNew ? now : entry.alert.since;
    alert.ongoing = true;
    entry.alert = std::move(alert);
    entry.heard = now;
    entry.round = m_round;
    if (entry.dismissed) {
        if (!worse && entry.alert.severity <= entry.dismissedAs && entry.alert.count / kWorseFactor < entry.dismissedAt)
            return;
        entry.dismissed = false;
        raise(entry.alert.id);
    } else if (isNew || worse) {
        raise(entry.alert.id);
    }
}

void AlertList::raiseEvent(Alert alert, double now)
{
    expire(now);
    const auto [at, isNew] = m_entries.try_emplace(alert.id);
    Entry &entry = at->second;
    entry.heard = now;
    if (entry.dismissed && entry.alert.text == alert.text)
        return; // the same report again
    const bool goesOn = !isNew && !entry.dismissed;
    alert.since = goesOn ? entry.alert.since : now;
    const bool isRepeated = goesOn && entry.alert.text == alert.text && alert.id.kind != AlertKind::UnknownAgent;
    alert.count = isRepeated ? entry.alert.count + 1 : 1;
    entry.alert = std::move(alert);
    entry.dismissed = false;
    raise(entry.alert.id);
}

void AlertList::raise(AlertId id)
{
    if (m_raised.size() < kMostRaised && std::ranges::find(m_raised, id) == m_raised.end())
        m_raised.push_back(id);
}

void AlertList::expire(double now)
{
    std::erase_if(m_entries, [now](const auto &one) {
        const Entry &entry = one.second;
        if (entry.alert.ongoing)
            return false;
        if (entry.dismissed)
            return now - entry.heard > kReportsRepeat;
        const double lasts = entry.alert.id.kind == AlertKind::UnknownAgent ? kUnheardFor : kShownFor;
        return entry.alert.severity != AlertSeverity::Severe && now - entry.heard >= lasts;
    });
}

void AlertList::dismiss(AlertId id)
{
    const auto at = m_entries.find(id);
    if (at == m_entries.end() || at->second.dismissed)
        return;
    // Only an agent that keeps announcing itself is reported again and again; each report of another kind is a new event.
    if (!at->second.alert.ongoing && id.kind != AlertKind::UnknownAgent) {
        m_entries.erase(at);
        return;
    }
    at->second.dismissed = true;
    at->second.dismissedAs = at->second.alert.severity;
    at->second.dismissedAt = at->second.alert.count;
}

std::vector<Alert> AlertList::alerts() const
{
    std::vector<Alert> out;
    for (const auto &[id, entry] : m_entries) {
        if (entry.dismissed)
            continue;
        out.push_back(entry.alert);
        out.back().text = shownText(entry.alert);
    }
    // Vehicles that anybody may invent on a plain link must not push those of the selected one away.
    const auto isOfAnother = [this](const Alert &alert) { return alert.id.systemId != 0 && alert.id.systemId != m_selected; };
    std::ranges::stable_sort(out, [&](const Alert &a, const Alert &b) {
        return std::tuple(b.severity, isOfAnother(a), a.since) < std::tuple(a.severity, isOfAnother(b), b.since);
    });
    return out;
}

std::vector<Alert> AlertList::takeRaised()
{
    std::vector<Alert> out;
    for (const AlertId id : std::exchange(m_raised, {})) {
        const auto at = m_entries.find(id);
        if (at == m_entries.end() || at->second.dismissed)
            continue;
        out.push_back(at->second.alert);
        out.back().text = shownText(at->second.alert);
    }
    return out;
}

bool AlertList::hasMomentary() const
{
    return std::ranges::any_of(m_entries, [](const auto &one) { return !one.second.alert.ongoing; });
}

/// The vehicle first, unless it is the only one; then how often an event was repeated.
QString AlertList::shownText(const Alert &alert) const
{
    const QString text = alert.ongoing || alert.count == 1
        ? alert.text
        : AlertListText::tr("%1 (%2 times)").arg(alert.text, grouped(alert.count));
    const std::uint8_t id = alert.id.systemId;
    const bool isOnly = m_snapshot && m_snapshot->vehicles.size() == 1 && m_snapshot->vehicles.front().state.systemId == id;
    return !isOnly && id != 0 ? AlertListText::tr("Vehicle %1: %2").arg(id).arg(text) : text;
}

} // namespace skyseal::ui
