#include "core/engine/text/event_text.h"

#include "core/engine/text/qt_text.h"
#include "core/engine/text/state_text.h"
#include "core/engine/text/system_text.h"
#include "core/mavlink/enums.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

namespace {

constexpr std::uint8_t kError = mavlink::MAV_SEVERITY_ERROR, kWarning = mavlink::MAV_SEVERITY_WARNING,
                       kNotice = mavlink::MAV_SEVERITY_NOTICE, kInfo = mavlink::MAV_SEVERITY_INFO;

/// Calls the overload for the alternative that an event holds.
class Describe
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::EventText)

public:
    explicit Describe(const PeerNames &names) : m_names(names) {}

    EventText operator()(const LinkChanged &e) const { return linkText(e.link); }
    template<typename T>
    requires kIsChannelEvent<T> EventText operator()(const T &e) const { return channelEventText(e, m_names); }
    EventText operator()(const VehicleFound &e) const
    {
        const QString type = vehicleTypeText(e.type);
        if (e.recorded)
            return EventText{tr("Found: %1").arg(type), kInfo, e.systemId};
        return e.sealed ? EventText{tr("Found: %1, sealed").arg(type), kInfo, e.systemId}
                        : EventText{tr("Found: %1, not sealed").arg(type), kWarning, e.systemId};
    }
    EventText operator()(const VehicleLost &e) const { return {tr("Link to the vehicle lost"), kError, e.systemId}; }
    EventText operator()(const VehicleBack &e) const { return {tr("Link to the vehicle recovered"), kNotice, e.systemId}; }
    EventText operator()(const vehicle::TextReceived &e) const { return {qt(e.text.text), e.text.severity, e.systemId}; }
    EventText operator()(const PlaintextRefused &e) const
    {
        const QString address = qt(e.remoteAddress);
        if (e.mayBe.empty())
            return {tr("Refused %1 from %2 with the system ID of this sealed vehicle")
                        .arg(counted(e.frames, tr("one plain frame"), tr("%1 plain frames")), address),
                    kError, e.systemId};
        return {tr("This vehicle, at %1, is waiting for approval: it is not sealed and may be impersonating %2, which has "
                   "not been heard")
                    .arg(address, anyOfNames(e.mayBe)),
                kWarning, e.systemId, false, EventText::Remedy::AllowPlaintext};
    }
    EventText operator()(const SystemRefused &e) const
    {
        const QString peer = qt(e.peer), owner = qt(e.owner);
        const QString frames = counted(e.frames, tr("one frame"), tr("%1 frames"));
        if (e.owner.empty())
            return {tr("Refused %1 from %2, which may not send as this vehicle. If %2 is its agent, bind the system ID to %2 "
                       "in the list of peers")
                        .arg(frames, peer),
                    kError, e.systemId};
        return {tr("Refused %1 from %2, which sends as this vehicle although its system ID belongs to %3. If %2 is a new "
                   "agent of the same vehicle, remove %3 from the list of peers or bind the system ID to %2")
                    .arg(frames, peer, owner),
                kError, e.systemId};
    }
    EventText operator()(const OtherSystemsHeard &e) const
    {
        const QString all = otherSystemsText(e);
        if (e.vehicles.empty())
            return {all, kNotice};
        return {tr("%1. To show vehicle %2, bind its system ID to %3 in the list of peers")
                    .arg(all, systemsText(e.vehicles), qt(e.peer)),
                kWarning};
    }
    EventText operator()(const OwnIdClaimed &e) const
    {
        return {tr("A vehicle at %1 is not shown: it has the system ID %2, which is this station's own. Change one of the two")
                    .arg(qt(e.remoteAddress))
                    .arg(e.systemId),
                kError};
    }
    EventText operator()(const AgentUnanswering &e) const
    {
        const QString name = qt(e.agent.peerName), address = qt(e.agent.remoteAddress);
        if (e.over)
            return routineText(tr("The agent %1 at %2 has answered or is no longer heard").arg(name, address));
        return {unansweringText(e.agent), kWarning};
    }
    EventText operator()(const RecordingProblem &e) const
    {
        return {tr("Not recording to %1: %2").arg(qt(e.file), reasonText(e.problem)), kError};
    }
    EventText operator()(const EventsDropped &e) const
    {
        return {tr("Dropped %1 because this program did not keep up").arg(counted(e.events, tr("one event"), tr("%1 events"))),
                kWarning};
    }
    EventText operator()(const CounterStorage &e) const
    {
        if (e.problem.empty())
            return {tr("Handshake counters can be stored again"), kNotice};
        return {countersNotStoredText(e.problem), kError};
    }
    EventText operator()(const ServedLinkChanged &e) const { return linkText(e.link); }
    EventText operator()(const ClientConnected &e) const
    {
        const QString name = qt(e.name), address = qt(e.address);
        return {e.write == "none" ? tr("Client %1 at %2 connected, read-only").arg(name, address)
                                  : tr("Client %1 at %2 connected, may write: %3").arg(name, address, qt(e.write)),
                kNotice};
    }
    EventText operator()(const ClientGone &e) const
    {
        return {tr("Client %1 at %2 disconnected").arg(qt(e.name), qt(e.address)), kNotice};
    }
    EventText operator()(const ClientDenied &e) const
    {
        return {tr("Denied %1 from client %2 at %3, most recently %4")
                    .arg(counted(e.frames, tr("one frame"), tr("%1 frames")), qt(e.name), qt(e.address), qt(e.message)),
                kWarning};
    }
    EventText operator()(const ClientsUnreported &e) const
    {
        return {tr("Further events: %1 connected and disconnected, %2 denied")
                    .arg(counted(e.clients, tr("one client"), tr("%1 clients")),
                         counted(e.frames, tr("one frame"), tr("%1 frames"))),
                kWarning};
    }
    EventText operator()(const vehicle::MissionResult &e) const
    {
        if (!e.ok)
            return {missionFailed(e.transfer).arg(planName(e.type), reasonText(e.reason)), kError, e.systemId};
        const QString done = missionDone(e.transfer).arg(planName(e.type));
        return e.remark.empty() ? EventText{done, kInfo, e.systemId}
                                : EventText{done + QStringLiteral(": ") + reasonText(e.remark), kWarning, e.systemId};
    }
    EventText operator()(const vehicle::ParameterResult &e) const
    {
        const QString name = qt(e.parameter.name);
        const QString value = QString::number(e.parameter.value), reason = reasonText(e.reason);
        switch (e.action) {
        case vehicle::ParameterAction::ReadList:
            return e.ok ? EventText{tr("Parameters read"), kInfo, e.systemId}
                        : EventText{tr("Parameters not read: %1").arg(reason), kError, e.systemId};
        case vehicle::ParameterAction::Read:
            return e.ok ? EventText{tr("Parameter %1 is %2").arg(name, value), kInfo, e.systemId}
                        : EventText{tr("Parameter %1 not read: %2").arg(name, reason), kError, e.systemId};
        case vehicle::ParameterAction::Write: break;
        }
        return e.ok ? EventText{tr("Parameter %1 is now %2").arg(name, value), kInfo, e.systemId}
                    : EventText{tr("Parameter %1 not written: %2").arg(name, reason), kError, e.systemId};
    }
    EventText operator()(const vehicle::FileResult &e) const
    {
        return e.ok ? EventText{fileDone(e.action).arg(qt(e.path)), kInfo, e.systemId}
                    : EventText{fileFailed(e.action).arg(qt(e.path), reasonText(e.reason)), kError, e.systemId};
    }
    EventText operator()(const vehicle::LogResult &e) const
    {
        switch (e.action) {
        case vehicle::LogAction::List:
            return e.ok ? EventText{tr("List of logs read"), kInfo, e.systemId}
                        : EventText{tr("List of logs not read: %1").arg(reasonText(e.reason)), kError, e.systemId};
        case vehicle::LogAction::Read:
            return e.ok ? EventText{tr("Log %1 read").arg(e.log), kInfo, e.systemId}
                        : EventText{tr("Log %1 not read: %2").arg(e.log).arg(reasonText(e.reason)), kError, e.systemId};
        case vehicle::LogAction::Erase: break;
        }
        return e.ok ? EventText{tr("Logs erased"), kNotice, e.systemId}
                    : EventText{tr("Logs not erased: %1").arg(reasonText(e.reason)), kError, e.systemId};
    }
    EventText operator()(const vehicle::CommandResult &e) const
    {
        return routineText(tr("Command: %1").arg(outcomeOf(e)), e.systemId);
    }

    static QString outcomeOf(const vehicle::CommandResult &result)
    {
        const QString reason = reasonText(result.reason);
        switch (result.outcome) {
        case vehicle::CommandOutcome::Accepted: return tr("accepted");
        case vehicle::CommandOutcome::Refused: return reason.isEmpty() ? tr("refused") : reason; // "nothing was sent: …"
        case vehicle::CommandOutcome::TimedOut: break;
        }
        return reason.isEmpty() ? tr("no answer") : reason;
    }

private:
    static QString fileDone(vehicle::FileAction action)
    {
        switch (action) {
        case vehicle::FileAction::List: return tr("Folder %1 listed");
        case vehicle::FileAction::Read: return tr("File %1 read");
        case vehicle::FileAction::Write: return tr("File %1 written");
        case vehicle::FileAction::Remove: break;
        }
        return tr("File %1 removed");
    }
    static QString fileFailed(vehicle::FileAction action)
    {
        switch (action) {
        case vehicle::FileAction::List: return tr("Folder %1 not listed: %2");
        case vehicle::FileAction::Read: return tr("File %1 not read: %2");
        case vehicle::FileAction::Write: return tr("File %1 not written: %2");
        case vehicle::FileAction::Remove: break;
        }
        return tr("File %1 not removed: %2");
    }
    static QString planName(vehicle::MissionType type)
    {
        switch (type) {
        case vehicle::MissionType::Fence: return tr("Fence");
        case vehicle::MissionType::Rally: return tr("Rally points");
        case vehicle::MissionType::Mission: break;
        }
        return tr("Mission");
    }
    static QString missionDone(vehicle::MissionTransfer transfer)
    {
        switch (transfer) {
        case vehicle::MissionTransfer::Upload: return tr("%1 sent");
        case vehicle::MissionTransfer::Download: return tr("%1 read");
        case vehicle::MissionTransfer::Clear: break;
        }
        return tr("%1 cleared");
    }
    static QString missionFailed(vehicle::MissionTransfer transfer)
    {
        switch (transfer) {
        case vehicle::MissionTransfer::Upload: return tr("%1 not sent: %2");
        case vehicle::MissionTransfer::Download: return tr("%1 not read: %2");
        case vehicle::MissionTransfer::Clear: break;
        }
        return tr("%1 not cleared: %2");
    }

    const PeerNames &m_names;
};

} // namespace

QString unansweringText(const UnansweringAgent &agent)
{
    return Describe::tr("The agent %1 at %2 announces itself but does not answer: does it know this station's key? %3")
        .arg(qt(agent.peerName), qt(agent.remoteAddress), qt(agent.ownFingerprint));
}

QString countersNotStoredText(const Reason &problem)
{
    return Describe::tr("Handshake counters cannot be stored: %1. The links stay up. If this station restarts now, agents "
                        "will refuse its first handshake and return the correct counter")
        .arg(reasonText(problem));
}

EventText eventText(const Event &event, const PeerNames &names)
{
    return std::visit(Describe(names), event);
}

QString commandOutcomeText(const vehicle::CommandResult &result)
{
    return Describe::outcomeOf(result);
}

} // namespace skyseal::engine
