#include "ui/messages/happening_words.h"

#include "core/link/address_text.h"
#include "ui/text/units.h"
#include "ui/text/words.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

constexpr std::uint8_t kCritical = 2, kError = 3, kWarning = 4, kNotice = 5, kInfo = 6;

struct Lines
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::HappeningLine)

public:
    using Line = std::optional<HappeningLine>;

    Line operator()(const engine::LinkChanged &e) const
    {
        const QString where = fromStd(e.link.url);
        if (!e.link.problem.empty())
            return HappeningLine{tr("Link %1: %2").arg(where, fromStd(e.link.problem)), kError};
        return HappeningLine{tr("Link %1: %2").arg(where, linkPhaseWord(e.link.phase)), kInfo};
    }
    Line operator()(const engine::VehicleFound &e) const
    {
        return HappeningLine{e.sealed ? tr("Found a %1, sealed").arg(vehicleTypeWord(e.type))
                                      : tr("Found a %1, not sealed").arg(vehicleTypeWord(e.type)),
                             e.sealed ? kInfo : kWarning, e.systemId};
    }
    Line operator()(const engine::VehicleLost &e) const
    {
        return HappeningLine{tr("Link to the vehicle lost"), kError, e.systemId};
    }
    Line operator()(const engine::VehicleBack &e) const { return HappeningLine{tr("Vehicle is back"), kNotice, e.systemId}; }
    Line operator()(const engine::TextReceived &e) const
    {
        return HappeningLine{fromStd(e.text.text), e.text.severity, e.systemId};
    }
    Line operator()(const engine::PlaintextRefused &e) const
    {
        if (!e.mayBe.empty())
            return HappeningLine{tr("Held back: this vehicle, at %1, is not sealed and may be an impostor of %2, which was never "
                                    "heard. Security → Allow plain MAVLink takes it all the same")
                                     .arg(fromStd(e.remoteAddress), anyOfNames(e.mayBe)), kWarning, e.systemId};
        return HappeningLine{tr("Refused %1 clear frames from %2 that claim to be this sealed vehicle")
                                 .arg(e.frames).arg(fromStd(e.remoteAddress)), kError, e.systemId};
    }
    Line operator()(const engine::SystemRefused &e) const
    {
        const QString peer = fromStd(e.peer), owner = fromStd(e.owner);
        if (e.owner.empty())
            return HappeningLine{
                tr("Refused %1 frames of %2, which speaks as this vehicle and may not").arg(e.frames).arg(peer), kError,
                e.systemId};
        return HappeningLine{tr("Refused %1 frames of %2, which speaks as this vehicle: it is %3's. Is it a new agent of "
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
        return HappeningLine{tr("The agent %1 at %2 is there but does not answer: does it know this station's key? %3")
                                 .arg(name, fromStd(e.agent.remoteAddress), fromStd(e.agent.ownFingerprint)),
                             kWarning};
    }
    Line operator()(const engine::RecordingProblem &e) const
    {
        return HappeningLine{tr("Recording %1: %2").arg(fromStd(e.file), fromStd(e.problem)), kError};
    }
    Line operator()(const engine::MissionTransferDone &e) const
    {
        const QString what = e.upload ? tr("Mission sent") : tr("Mission read");
        return e.ok ? HappeningLine{what, kInfo, e.systemId}
                    : HappeningLine{tr("%1: failed, %2").arg(what, fromStd(e.reason)), kError, e.systemId};
    }
    Line operator()(const engine::ParameterWritten &e) const
    {
        const QString name = fromStd(e.parameter.name);
        return e.ok ? HappeningLine{tr("Parameter %1 is now %2").arg(name).arg(e.parameter.value), kInfo, e.systemId}
                    : HappeningLine{tr("Parameter %1 not written: %2").arg(name, fromStd(e.reason)), kError, e.systemId};
    }
    Line operator()(const vehicle::CommandResult &) const { return {}; } // told with its question
    Line operator()(const channel::SessionUp &e) const
    {
        return HappeningLine{tr("Sealed link to %1 is up with %2").arg(fromStd(e.peerName), suiteName(e.suite)), kInfo};
    }
    Line operator()(const channel::SessionDown &e) const
    {
        return HappeningLine{tr("Sealed link ended: %1").arg(downReasonWords(e.reason)), kWarning};
    }
    Line operator()(const channel::PeerMoved &) const { return HappeningLine{tr("The peer's address changed"), kInfo}; }
    Line operator()(const channel::SwitchPending &) const { return {}; } // its result is told
    Line operator()(const channel::SwitchDone &e) const
    {
        if (e.failure != channel::SwitchFailure::None)
            return HappeningLine{tr("Switch to %1 rolled back: %2").arg(suiteName(e.to), switchFailureWords(e.failure)),
                                 kWarning};
        if (e.rekey)
            return HappeningLine{tr("Fresh keys for %1, epoch %2").arg(suiteName(e.to)).arg(static_cast<quint32>(e.epoch)),
                                 kInfo};
        return HappeningLine{
            tr("Switched from %1 to %2 in %3").arg(suiteName(e.from), suiteName(e.to), switchTimeText(e.took)), kInfo};
    }
    Line operator()(const channel::HandshakeRefused &e) const
    {
        if (e.reason == channel::RefusalReason::UnknownPeer)
            return HappeningLine{tr("An agent at %1 announces itself with a key that is not known here. Security → Keys and "
                                    "peers pairs the two")
                                     .arg(fromStd(link::toText(e.path.remote))),
                                 kWarning};
        return HappeningLine{tr("Handshake refused: %1").arg(refusalWords(e.reason)), kWarning};
    }
    Line operator()(const channel::ForgeryAlarm &e) const
    {
        return HappeningLine{tr("Under attack: %1 forged and %2 replayed records refused").arg(e.forged).arg(e.replayed),
                             kCritical};
    }
};

} // namespace

std::optional<HappeningLine> happeningLine(const engine::Happening &happening)
{
    return std::visit(Lines{}, happening);
}

} // namespace skyseal::ui
