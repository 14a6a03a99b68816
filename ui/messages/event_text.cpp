#include "ui/messages/event_text.h"

#include "core/link/address_text.h"
#include "ui/text/units.h"
#include "ui/text/state_text.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

constexpr std::uint8_t kCritical = 2, kError = 3, kWarning = 4, kNotice = 5, kInfo = 6;

struct Lines
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::EventLine)

public:
    using Line = std::optional<EventLine>;

    Line operator()(const engine::LinkChanged &e) const
    {
        const QString where = fromStd(e.link.url);
        if (!e.link.problem.empty())
            return EventLine{tr("Link %1: %2").arg(where, fromStd(e.link.problem)), kError};
        return EventLine{tr("Link %1: %2").arg(where, linkPhaseText(e.link.phase)), kInfo};
    }
    Line operator()(const engine::VehicleFound &e) const
    {
        return EventLine{e.sealed ? tr("Found a %1, sealed").arg(vehicleTypeText(e.type))
                                  : tr("Found a %1, not sealed").arg(vehicleTypeText(e.type)),
                         e.sealed ? kInfo : kWarning, e.systemId};
    }
    Line operator()(const engine::VehicleLost &e) const
    {
        return EventLine{tr("Link to the vehicle lost"), kError, e.systemId};
    }
    Line operator()(const engine::VehicleBack &e) const { return EventLine{tr("Vehicle is back"), kNotice, e.systemId}; }
    Line operator()(const vehicle::TextReceived &e) const
    {
        return EventLine{fromStd(e.text.text), e.text.severity, e.systemId};
    }
    Line operator()(const engine::PlaintextRefused &e) const
    {
        if (!e.mayBe.empty())
            return EventLine{tr("Held back: this vehicle, at %1, is not sealed and may be an impostor of %2, which was never "
                                "heard. Security → Allow plain MAVLink takes it all the same")
                                 .arg(fromStd(e.remoteAddress), anyOfNames(e.mayBe)),
                             kWarning, e.systemId};
        return EventLine{tr("Refused %1 clear frames from %2 that claim to be this sealed vehicle")
                             .arg(e.frames)
                             .arg(fromStd(e.remoteAddress)),
                         kError, e.systemId};
    }
    Line operator()(const engine::SystemRefused &e) const
    {
        const QString peer = fromStd(e.peer), owner = fromStd(e.owner);
        if (e.owner.empty())
            return EventLine{tr("Refused %1 frames of %2, which speaks as this vehicle and may not").arg(e.frames).arg(peer),
                             kError, e.systemId};
        return EventLine{tr("Refused %1 frames of %2, which speaks as this vehicle: it is %3's. Is it a new agent of "
                            "the same vehicle? Then remove %3 from the keys, or bind the system to %2")
                             .arg(e.frames)
                             .arg(peer, owner),
                         kError, e.systemId};
    }
    Line operator()(const engine::AgentUnanswering &e) const
    {
        const QString name = fromStd(e.agent.peerName);
        if (e.over)
            return {}; // the session that is up, or the silence, says enough
        return EventLine{tr("The agent %1 at %2 is there but does not answer: does it know this station's key? %3")
                             .arg(name, fromStd(e.agent.remoteAddress), fromStd(e.agent.ownFingerprint)),
                         kWarning};
    }
    Line operator()(const engine::RecordingProblem &e) const
    {
        return EventLine{tr("Recording %1: %2").arg(fromStd(e.file), fromStd(e.problem)), kError};
    }
    Line operator()(const vehicle::MissionResult &e) const
    {
        const QString what = e.transfer == vehicle::MissionTransfer::Upload ? tr("Mission sent") : tr("Mission read");
        return e.ok ? EventLine{what, kInfo, e.systemId}
                    : EventLine{tr("%1: failed, %2").arg(what, fromStd(e.reason)), kError, e.systemId};
    }
    Line operator()(const vehicle::ParameterResult &e) const
    {
        const QString name = fromStd(e.parameter.name);
        return e.ok ? EventLine{tr("Parameter %1 is now %2").arg(name).arg(e.parameter.value), kInfo, e.systemId}
                    : EventLine{tr("Parameter %1 not written: %2").arg(name, fromStd(e.reason)), kError, e.systemId};
    }
    Line operator()(const vehicle::CommandResult &) const { return {}; } // told with its question
    Line operator()(const channel::SessionUp &e) const
    {
        return EventLine{tr("Sealed link to %1 is up with %2").arg(fromStd(e.peerName), suiteName(e.suite)), kInfo};
    }
    Line operator()(const channel::SessionDown &e) const
    {
        return EventLine{tr("Sealed link ended: %1").arg(downReasonText(e.reason)), kWarning};
    }
    Line operator()(const channel::PeerMoved &) const { return EventLine{tr("The peer's address changed"), kInfo}; }
    Line operator()(const channel::SwitchPending &) const { return {}; } // its result is told
    Line operator()(const channel::SwitchDone &e) const
    {
        if (e.failure != channel::SwitchFailure::None)
            return EventLine{tr("Switch to %1 rolled back: %2").arg(suiteName(e.to), switchFailureText(e.failure)), kWarning};
        if (e.rekey)
            return EventLine{tr("Fresh keys for %1, epoch %2").arg(suiteName(e.to)).arg(static_cast<quint32>(e.epoch)), kInfo};
        return EventLine{tr("Switched from %1 to %2 in %3").arg(suiteName(e.from), suiteName(e.to), switchTimeText(e.took)),
                         kInfo};
    }
    Line operator()(const channel::HandshakeRefused &e) const
    {
        if (e.reason == channel::RefusalReason::UnknownPeer)
            return EventLine{tr("An agent at %1 announces itself with a key that is not known here. Security → Keys and "
                                "peers pairs the two")
                                 .arg(fromStd(link::toText(e.path.remote))),
                             kWarning};
        return EventLine{tr("Handshake refused: %1").arg(refusalText(e.reason)), kWarning};
    }
    Line operator()(const channel::ForgeryAlarm &e) const
    {
        return EventLine{tr("Under attack: %1 forged and %2 replayed records refused").arg(e.forged).arg(e.replayed),
                         kCritical};
    }
};

} // namespace

std::optional<EventLine> eventLine(const engine::Event &event)
{
    return std::visit(Lines{}, event);
}

} // namespace skyseal::ui
