#include "core/experiment/measured_link.h"

#include "core/engine/station/snapshot.h"

#include <algorithm>

namespace skyseal::experiment {

using engine::Protection;

namespace {

/// True if both ends make a new session for the change. Sessions are sealed where nothing else is set.
bool renewsSession(std::optional<Protection> from, std::optional<Protection> to)
{
    return from.value_or(Protection::Sealed) != to.value_or(Protection::Sealed);
}

/// TIMESYNC answers of all vehicles.
double answersIn(const engine::Snapshot &snapshot)
{
    double out = 0;
    for (const engine::VehicleSnapshot &vehicle : snapshot.vehicles)
        out += static_cast<double>(vehicle.state.trips);
    return out;
}

} // namespace

Protection protectionOf(const SweepArm &arm)
{
    if (arm.suite == crypto::SuiteId::None || arm.framing == ArmFraming::Bare)
        return Protection::Plain;
    return arm.framing == ArmFraming::Inline ? Protection::Inline : Protection::Sealed;
}

void MeasuredLink::stationOpened()
{
    m_protection.reset();
    m_bareCipher.reset();
    m_ending.reset();
    m_answersBefore = 0;
}

void MeasuredLink::setProtection(std::optional<Protection> protection, const engine::Snapshot *snapshot)
{
    const engine::SessionSnapshot *up = snapshot ? session(*snapshot) : nullptr;
    if (up && renewsSession(m_protection, protection))
        m_ending = up->info.session;
    m_answersBefore = snapshot ? answersIn(*snapshot) : 0;
    m_protection = protection;
    m_bareCipher.reset();
}

void MeasuredLink::setBareCipher(std::optional<crypto::MavsecKind> cipher, const engine::Snapshot *snapshot)
{
    m_answersBefore = snapshot ? answersIn(*snapshot) : 0;
    m_bareCipher = cipher;
}

bool MeasuredLink::isCarriedAs(const SweepArm &arm) const
{
    return m_protection == protectionOf(arm) && m_bareCipher == bareCipherOf(arm);
}

void MeasuredLink::update(const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = session(snapshot);
    if (up && !m_firstSuite)
        m_firstSuite = up->info.suite;
}

void MeasuredLink::learnConsent(const engine::Snapshot &snapshot)
{
    const engine::SessionSnapshot *up = session(snapshot);
    if (!up)
        return;
    const auto &offered = up->info.peerOffered;
    m_plainRefused = std::find(offered.begin(), offered.end(), crypto::SuiteId::None) == offered.end();
    m_inlineRefused = m_inlineRefused || (m_protection == Protection::Inline && m_framing != channel::Framing::Inline);
}

Reason MeasuredLink::refusal(const SweepArm &arm) const
{
    const Protection wanted = protectionOf(arm);
    if (bareCipherOf(arm) && m_bareRefused)
        return kUnreadable;
    if (wanted == Protection::Plain && m_plainRefused)
        return sentence("Reason", "the other end does not allow plain MAVLink");
    if (wanted == Protection::Inline && m_inlineRefused)
        return sentence("Reason", "the other end does not allow inline framing");
    return {};
}

const engine::SessionSnapshot *MeasuredLink::session(const engine::Snapshot &snapshot) const
{
    const auto found = std::find_if(
        snapshot.sessions.begin(), snapshot.sessions.end(),
        [this](const engine::SessionSnapshot &one) { return !one.info.silent && one.info.session != m_ending; });
    return found == snapshot.sessions.end() ? nullptr : &*found;
}

bool MeasuredLink::isUnder(crypto::SuiteId suite, const engine::Snapshot &snapshot) const
{
    const engine::SessionSnapshot *up = session(snapshot);
    return isPlain() || (up && up->info.suite == suite && up->info.pending.value_or(suite) == suite);
}

bool MeasuredLink::isHeard(const engine::Snapshot &snapshot, const engine::VehicleSnapshot &vehicle) const
{
    if (vehicle.state.lost)
        return false;
    if (isPlain())
        return !vehicle.session;
    const engine::SessionSnapshot *up = session(snapshot);
    return up && vehicle.session == up->info.session;
}

bool MeasuredLink::hasVehicle(const engine::Snapshot &snapshot) const
{
    return std::any_of(snapshot.vehicles.begin(), snapshot.vehicles.end(),
                       [&](const engine::VehicleSnapshot &vehicle) { return isHeard(snapshot, vehicle); });
}

bool MeasuredLink::hasReadableVehicle(const engine::Snapshot &snapshot) const
{
    return hasVehicle(snapshot) && (!m_bareCipher || isAnswering(snapshot));
}

bool MeasuredLink::hasSettledVehicle(const engine::Snapshot &snapshot) const
{
    return std::any_of(snapshot.vehicles.begin(), snapshot.vehicles.end(), [&](const engine::VehicleSnapshot &vehicle) {
        return isHeard(snapshot, vehicle) && vehicle.state.ekfOk.value_or(false) && vehicle.state.home.known();
    });
}

bool MeasuredLink::isAnswering(const engine::Snapshot &snapshot) const
{
    return answersIn(snapshot) > m_answersBefore;
}

bool MeasuredLink::isRestored(const engine::Snapshot &snapshot) const
{
    const engine::SessionSnapshot *up = session(snapshot);
    return up && !isPlain() && up->info.suite == m_firstSuite && !up->info.pending;
}

} // namespace skyseal::experiment
