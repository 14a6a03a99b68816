#include "ui/text/words.h"

#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("skyseal::ui::Words", text);
}

template<typename... Ts> struct Overloaded : Ts...
{
    using Ts::operator()...;
};
template<typename... Ts> Overloaded(Ts...) -> Overloaded<Ts...>;

} // namespace

QString fromStd(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString fixWord(int gpsFixType)
{
    switch (gpsFixType) {
    case 0: return tr("no GPS");
    case 1: return tr("no fix");
    case 2: return tr("2D fix");
    case 3: return tr("3D fix");
    case 4: return tr("DGPS");
    case 5: return tr("RTK float");
    case 6: return tr("RTK fixed");
    case 7: return tr("static");
    case 8: return tr("PPP");
    default: return dash();
    }
}

QString vehicleTypeWord(std::uint8_t type)
{
    switch (type) {
    case 1: return tr("plane");
    case 2: return tr("quadrotor");
    case 3: return tr("coaxial helicopter");
    case 4: return tr("helicopter");
    case 5: return tr("antenna tracker");
    case 7: return tr("airship");
    case 10: return tr("rover");
    case 11: return tr("boat");
    case 12: return tr("submarine");
    case 13: return tr("hexarotor");
    case 14: return tr("octorotor");
    case 15: return tr("tricopter");
    case 19: case 20: case 21: case 22: case 23: case 24: case 25: return tr("VTOL");
    default: return tr("vehicle");
    }
}

QString severityWord(std::uint8_t severity)
{
    switch (severity) {
    case 0: return tr("emergency");
    case 1: return tr("alert");
    case 2: return tr("critical");
    case 3: return tr("error");
    case 4: return tr("warning");
    case 5: return tr("notice");
    case 6: return tr("info");
    default: return tr("debug");
    }
}

QString switchFailureWords(channel::SwitchFailure failure)
{
    switch (failure) {
    case channel::SwitchFailure::None: return tr("switched");
    case channel::SwitchFailure::NotAllowedHere: return tr("not allowed at this end");
    case channel::SwitchFailure::NotAllowedByPeer: return tr("not allowed by the vehicle");
    case channel::SwitchFailure::NotConfirmed: return tr("the vehicle did not confirm in time");
    case channel::SwitchFailure::Superseded: return tr("the other end's choice came first");
    case channel::SwitchFailure::SessionEnded: return tr("the session ended");
    }
    return {};
}

QString downReasonWords(channel::DownReason reason)
{
    switch (reason) {
    case channel::DownReason::PeerRestarted: return tr("the other end restarted");
    case channel::DownReason::PeerClosed: return tr("closed by the other end");
    case channel::DownReason::TimedOut: return tr("silent for too long");
    case channel::DownReason::Exhausted: return tr("its keys were used up");
    case channel::DownReason::Revoked: return tr("its key is no longer a known peer");
    case channel::DownReason::Closed: return tr("closed here");
    }
    return {};
}

QString refusalWords(channel::RefusalReason reason)
{
    switch (reason) {
    case channel::RefusalReason::UnknownPeer: return tr("an unknown key: nobody confirmed it here");
    case channel::RefusalReason::WrongKey: return tr("made for another key: meant for somebody else, or an impostor");
    case channel::RefusalReason::ReplayedHandshake: return tr("a replayed handshake");
    case channel::RefusalReason::NoCommonSuite: return tr("no cipher suite that both ends allow");
    case channel::RefusalReason::OfferTampered: return tr("the offer of suites was tampered with");
    case channel::RefusalReason::Version: return tr("another version of the protocol");
    }
    return {};
}

QString linkPhaseWord(engine::LinkPhase phase)
{
    switch (phase) {
    case engine::LinkPhase::Closed: return tr("closed");
    case engine::LinkPhase::Opening: return tr("opening");
    case engine::LinkPhase::Listening: return tr("listening");
    case engine::LinkPhase::Connected: return tr("connected");
    case engine::LinkPhase::Waiting: return tr("waiting to try again");
    case engine::LinkPhase::Finished: return tr("finished");
    case engine::LinkPhase::Failed: return tr("failed");
    }
    return {};
}

QString commandOutcomeWords(const vehicle::CommandResult &result)
{
    const QString reason = fromStd(result.reason);
    switch (result.outcome) {
    case vehicle::CommandOutcome::Accepted: return tr("accepted");
    case vehicle::CommandOutcome::Refused: return reason.isEmpty() ? tr("refused") : tr("refused: %1").arg(reason);
    case vehicle::CommandOutcome::TimedOut: return reason.isEmpty() ? tr("no answer") : tr("no answer: %1").arg(reason);
    }
    return {};
}

QString commandWords(const vehicle::VehicleCommand &command)
{
    return std::visit(
        Overloaded{[](const vehicle::Arm &) { return tr("Arm"); },
                   [](const vehicle::Disarm &) { return tr("Disarm"); },
                   [](const vehicle::TakeOff &c) { return tr("Take off to %1 m").arg(number(c.altitude, 0)); },
                   [](const vehicle::Land &) { return tr("Land"); },
                   [](const vehicle::ReturnToLaunch &) { return tr("Return to launch"); },
                   [](const vehicle::SetMode &c) { return tr("Mode %1").arg(fromStd(c.mode)); },
                   [](const vehicle::GoTo &) { return tr("Fly to the point"); },
                   [](const vehicle::ChangeSpeed &c) { return tr("Speed %1 m/s").arg(number(c.metresPerSecond, 1)); },
                   [](const vehicle::SetCurrentMissionItem &c) { return tr("Mission item %1").arg(c.index); },
                   [](const vehicle::StartMission &) { return tr("Start the mission"); },
                   [](const vehicle::Reboot &) { return tr("Restart the autopilot"); },
                   [](const vehicle::RawCommand &c) { return tr("Command %1").arg(c.command); }},
        command);
}

} // namespace skyseal::ui
