#include "core/engine/text/event_text.h"

#include "core/engine/text/state_text.h"
#include "core/keys/public_key_text.h"
#include "core/link/address_text.h"
#include "core/mavlink/enums.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

namespace {

constexpr std::uint8_t kCritical = mavlink::MAV_SEVERITY_CRITICAL, kError = mavlink::MAV_SEVERITY_ERROR,
                       kWarning = mavlink::MAV_SEVERITY_WARNING, kNotice = mavlink::MAV_SEVERITY_NOTICE,
                       kInfo = mavlink::MAV_SEVERITY_INFO;

QString qt(const std::string &text)
{
    return QString::fromStdString(text);
}

QString addressOf(const Path &path)
{
    return qt(link::toText(path.remote));
}

EventText routine(const QString &sentence, std::uint8_t systemId = 0)
{
    return {sentence, kInfo, systemId, true};
}

/// Calls the overload for the alternative that an event holds.
class Describe
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::EventText)

public:
    explicit Describe(const PeerNames &names) : m_names(names) {}

    EventText operator()(const LinkChanged &e) const { return linkText(e.link); }
    EventText operator()(const VehicleFound &e) const
    {
        const QString type = vehicleTypeText(e.type);
        return e.sealed ? EventText{tr("Found a %1, sealed").arg(type), kInfo, e.systemId}
                        : EventText{tr("Found a %1, not sealed").arg(type), kWarning, e.systemId};
    }
    EventText operator()(const VehicleLost &e) const { return {tr("Link to the vehicle lost"), kError, e.systemId}; }
    EventText operator()(const VehicleBack &e) const { return {tr("Vehicle is back"), kNotice, e.systemId}; }
    EventText operator()(const vehicle::TextReceived &e) const { return {qt(e.text.text), e.text.severity, e.systemId}; }
    EventText operator()(const PlaintextRefused &e) const
    {
        const QString address = qt(e.remoteAddress);
        if (e.mayBe.empty())
            return {
                tr("Refused %1 plain frames from %2 that claim to come from this sealed vehicle").arg(e.frames).arg(address),
                kError, e.systemId};
        return {
            tr("This vehicle, at %1, waits for approval: it is not sealed and may be an impostor of %2, which was never heard")
                .arg(address, anyOfNames(e.mayBe)),
            kWarning, e.systemId, false, EventText::Remedy::AllowPlaintext};
    }
    EventText operator()(const SystemRefused &e) const
    {
        const QString peer = qt(e.peer), owner = qt(e.owner);
        if (e.owner.empty())
            return {tr("Refused %1 frames of %2, which may not send as this vehicle").arg(e.frames).arg(peer), kError,
                    e.systemId};
        return {tr("Refused %1 frames of %2, which sends as this vehicle although that belongs to %3. If %2 is a new agent of "
                   "the same vehicle, remove %3 from the list of peers or bind the system to %2")
                    .arg(e.frames)
                    .arg(peer, owner),
                kError, e.systemId};
    }
    EventText operator()(const AgentUnanswering &e) const
    {
        const QString name = qt(e.agent.peerName), address = qt(e.agent.remoteAddress);
        if (e.over)
            return routine(tr("The agent %1 at %2 answered, or is gone").arg(name, address));
        return {tr("The agent %1 at %2 announces itself but does not answer: does it know this station's key? %3")
                    .arg(name, address, qt(e.agent.ownFingerprint)),
                kWarning};
    }
    EventText operator()(const RecordingProblem &e) const
    {
        return {tr("Not recording to %1: %2").arg(qt(e.file), qt(e.problem)), kError};
    }
    EventText operator()(const vehicle::MissionResult &e) const
    {
        return e.ok ? EventText{missionDone(e.transfer), kInfo, e.systemId}
                    : EventText{missionFailed(e.transfer).arg(qt(e.reason)), kError, e.systemId};
    }
    EventText operator()(const vehicle::ParameterResult &e) const
    {
        const QString name = qt(e.parameter.name);
        if (name.isEmpty())
            return {tr("Parameters not read: %1").arg(qt(e.reason)), kError, e.systemId};
        return e.ok ? EventText{tr("Parameter %1 is now %2").arg(name, QString::number(e.parameter.value)), kInfo, e.systemId}
                    : EventText{tr("Parameter %1 not written: %2").arg(name, qt(e.reason)), kError, e.systemId};
    }
    EventText operator()(const vehicle::CommandResult &e) const
    {
        switch (e.outcome) {
        case vehicle::CommandOutcome::Accepted: return routine(tr("Command accepted"), e.systemId);
        case vehicle::CommandOutcome::Refused: return routine(tr("Command refused: %1").arg(qt(e.reason)), e.systemId);
        case vehicle::CommandOutcome::TimedOut: break;
        }
        return routine(tr("Command not answered"), e.systemId);
    }
    EventText operator()(const channel::SessionUp &e) const
    {
        return {tr("Sealed link to %1 at %2 is up with %3").arg(qt(e.peerName), addressOf(e.path), suiteText(e.suite)), kInfo};
    }
    EventText operator()(const channel::SessionDown &e) const
    {
        return {tr("Sealed link to %1 ended: %2").arg(peer(e.session), downReasonText(e.reason)), kWarning};
    }
    EventText operator()(const channel::PeerMoved &e) const
    {
        return {tr("The address of %1 changed to %2").arg(peer(e.session), addressOf(e.to)), kInfo};
    }
    EventText operator()(const channel::SwitchPending &e) const
    {
        return routine(tr("Switching from %1 to %2").arg(suiteText(e.from), suiteText(e.to)));
    }
    EventText operator()(const channel::SwitchDone &e) const
    {
        const auto epoch = static_cast<quint32>(e.epoch);
        if (e.failure != channel::SwitchFailure::None)
            return {tr("Switch to %1 rolled back: %2").arg(suiteText(e.to), switchFailureText(e.failure)), kWarning};
        if (e.rekey)
            return {tr("Fresh keys for %1, epoch %2").arg(suiteText(e.to)).arg(epoch), kInfo};
        return {tr("Switched from %1 to %2, epoch %3, in %4")
                    .arg(suiteText(e.from), suiteText(e.to))
                    .arg(epoch)
                    .arg(switchTimeText(e.took)),
                kInfo};
    }
    EventText operator()(const channel::HandshakeRefused &e) const
    {
        const bool isKeyKnown = e.peer != channel::PublicKey{};
        // A station reads an announcement, which does not show the key; an agent reads a handshake, which does.
        if (e.reason == channel::RefusalReason::UnknownPeer && !isKeyKnown)
            return {tr("An agent at %1 announces itself with a key that is not known here").arg(addressOf(e.path)), kWarning, 0,
                    false, EventText::Remedy::PairAgent};
        const QString sentence = tr("Refused a handshake from %1: %2").arg(addressOf(e.path), refusalText(e.reason));
        return {isKeyKnown ? tr("%1 (key %2)").arg(sentence, qt(keys::fingerprint(e.peer))) : sentence, kWarning};
    }
    EventText operator()(const channel::ForgeryAlarm &e) const
    {
        return {tr("Under attack: refused %1 forged and %2 replayed records that claim to come from %3")
                    .arg(e.forged)
                    .arg(e.replayed)
                    .arg(peer(e.session)),
                kCritical};
    }

    EventText operator()(const channel::CommandsLate &e) const
    {
        const double age = double(e.report.ageMicroseconds) / 1e6, limit = double(e.report.limitMilliseconds) / 1e3;
        if (limit > 0 && age > limit)
            return {
                tr("Commands arrive up to %1 s late at %2, which obeys none that are older than %3 s: it ignored %4 messages")
                    .arg(age, 0, 'f', 1)
                    .arg(peer(e.session))
                    .arg(limit, 0, 'f', 1)
                    .arg(e.records),
                kError};
        return {tr("Messages to %1 were withheld or delayed on their way, and others overtook them: it ignored %2")
                    .arg(peer(e.session))
                    .arg(e.records),
                kError};
    }

    static EventText ofLink(const LinkSnapshot &link)
    {
        const QString url = qt(link.url);
        if (!link.problem.empty())
            return {tr("Link %1: %2").arg(url, qt(link.problem)), kError};
        switch (link.phase) {
        case LinkPhase::Listening: return {tr("Link %1: listening on %2").arg(url, qt(link.localAddress)), kInfo};
        case LinkPhase::Finished: return {tr("Link %1: replayed to its end").arg(url), kInfo};
        case LinkPhase::Opening:
        case LinkPhase::Closed: return routine(tr("Link %1: %2").arg(url, linkPhaseText(link.phase)));
        default: return {tr("Link %1: %2").arg(url, linkPhaseText(link.phase)), kInfo};
        }
    }

    static QString lineOf(const EventText &text)
    {
        return text.systemId == 0 ? text.sentence : tr("Vehicle %1: %2").arg(text.systemId).arg(text.sentence);
    }

private:
    static QString missionDone(vehicle::MissionTransfer transfer)
    {
        switch (transfer) {
        case vehicle::MissionTransfer::Upload: return tr("Mission sent");
        case vehicle::MissionTransfer::Download: return tr("Mission read");
        case vehicle::MissionTransfer::Clear: break;
        }
        return tr("Mission cleared");
    }
    static QString missionFailed(vehicle::MissionTransfer transfer)
    {
        switch (transfer) {
        case vehicle::MissionTransfer::Upload: return tr("Mission not sent: %1");
        case vehicle::MissionTransfer::Download: return tr("Mission not read: %1");
        case vehicle::MissionTransfer::Clear: break;
        }
        return tr("Mission not cleared: %1");
    }
    QString peer(channel::SessionId session) const
    {
        const std::string name = m_names.of(session);
        return name.empty() ? tr("the peer") : qt(name);
    }

    const PeerNames &m_names;
};

} // namespace

QString EventText::line() const
{
    return Describe::lineOf(*this);
}

EventText eventText(const Event &event, const PeerNames &names)
{
    return std::visit(Describe(names), event);
}

EventText linkText(const LinkSnapshot &link)
{
    return Describe::ofLink(link);
}

} // namespace skyseal::engine
