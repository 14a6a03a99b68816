#include "ui/text/state_text.h"

#include "core/mavlink/enums.h"
#include "ui/text/units.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

/// The translations' context of the free functions below.
struct Words
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::Words)
};

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

QString anyOfNames(std::string_view names)
{
    const QString all = fromStd(names), comma = QStringLiteral(", ");
    const qsizetype last = all.lastIndexOf(comma);
    return last < 0 ? all : Words::tr("%1 or %2").arg(all.left(last), all.mid(last + comma.size()));
}

QString fixText(int gpsFixType)
{
    switch (gpsFixType) {
    case mavlink::GPS_FIX_TYPE_NO_GPS: return Words::tr("no GPS");
    case mavlink::GPS_FIX_TYPE_NO_FIX: return Words::tr("no fix");
    case mavlink::GPS_FIX_TYPE_2D_FIX: return Words::tr("2D fix");
    case mavlink::GPS_FIX_TYPE_3D_FIX: return Words::tr("3D fix");
    case mavlink::GPS_FIX_TYPE_DGPS: return Words::tr("DGPS");
    case mavlink::GPS_FIX_TYPE_RTK_FLOAT: return Words::tr("RTK float");
    case mavlink::GPS_FIX_TYPE_RTK_FIXED: return Words::tr("RTK fixed");
    case mavlink::GPS_FIX_TYPE_STATIC: return Words::tr("static");
    case mavlink::GPS_FIX_TYPE_PPP: return Words::tr("PPP");
    default: return dash();
    }
}

QString vehicleTypeText(std::uint8_t type)
{
    switch (type) {
    case mavlink::MAV_TYPE_FIXED_WING: return Words::tr("plane");
    case mavlink::MAV_TYPE_QUADROTOR: return Words::tr("quadrotor");
    case mavlink::MAV_TYPE_COAXIAL: return Words::tr("coaxial helicopter");
    case mavlink::MAV_TYPE_HELICOPTER: return Words::tr("helicopter");
    case mavlink::MAV_TYPE_ANTENNA_TRACKER: return Words::tr("antenna tracker");
    case mavlink::MAV_TYPE_AIRSHIP: return Words::tr("airship");
    case mavlink::MAV_TYPE_GROUND_ROVER: return Words::tr("rover");
    case mavlink::MAV_TYPE_SURFACE_BOAT: return Words::tr("boat");
    case mavlink::MAV_TYPE_SUBMARINE: return Words::tr("submarine");
    case mavlink::MAV_TYPE_HEXAROTOR: return Words::tr("hexarotor");
    case mavlink::MAV_TYPE_OCTOROTOR: return Words::tr("octorotor");
    case mavlink::MAV_TYPE_TRICOPTER: return Words::tr("tricopter");
    case mavlink::MAV_TYPE_VTOL_TAILSITTER_DUOROTOR:
    case mavlink::MAV_TYPE_VTOL_TAILSITTER_QUADROTOR:
    case mavlink::MAV_TYPE_VTOL_TILTROTOR:
    case mavlink::MAV_TYPE_VTOL_FIXEDROTOR:
    case mavlink::MAV_TYPE_VTOL_TAILSITTER:
    case mavlink::MAV_TYPE_VTOL_TILTWING:
    case mavlink::MAV_TYPE_VTOL_RESERVED5: return Words::tr("VTOL");
    default: return Words::tr("vehicle");
    }
}

QString severityText(std::uint8_t severity)
{
    switch (severity) {
    case mavlink::MAV_SEVERITY_EMERGENCY: return Words::tr("emergency");
    case mavlink::MAV_SEVERITY_ALERT: return Words::tr("alert");
    case mavlink::MAV_SEVERITY_CRITICAL: return Words::tr("critical");
    case mavlink::MAV_SEVERITY_ERROR: return Words::tr("error");
    case mavlink::MAV_SEVERITY_WARNING: return Words::tr("warning");
    case mavlink::MAV_SEVERITY_NOTICE: return Words::tr("notice");
    case mavlink::MAV_SEVERITY_INFO: return Words::tr("info");
    default: return Words::tr("debug");
    }
}

QString switchFailureText(channel::SwitchFailure failure)
{
    switch (failure) {
    case channel::SwitchFailure::None: return Words::tr("switched");
    case channel::SwitchFailure::NotAllowedHere: return Words::tr("not allowed at this end");
    case channel::SwitchFailure::NotAllowedByPeer: return Words::tr("not allowed by the vehicle");
    case channel::SwitchFailure::NotConfirmed: return Words::tr("the vehicle did not confirm in time");
    case channel::SwitchFailure::Superseded: return Words::tr("the other end's choice came first");
    case channel::SwitchFailure::SessionEnded: return Words::tr("the session ended");
    }
    return {};
}

QString downReasonText(channel::DownReason reason)
{
    switch (reason) {
    case channel::DownReason::PeerRestarted: return Words::tr("the other end restarted");
    case channel::DownReason::PeerClosed: return Words::tr("closed by the other end");
    case channel::DownReason::TimedOut: return Words::tr("silent for too long");
    case channel::DownReason::Exhausted: return Words::tr("its keys were used up");
    case channel::DownReason::Revoked: return Words::tr("its key is no longer a known peer");
    case channel::DownReason::Closed: return Words::tr("closed here");
    }
    return {};
}

QString refusalText(channel::RefusalReason reason)
{
    switch (reason) {
    case channel::RefusalReason::UnknownPeer: return Words::tr("an unknown key: nobody confirmed it here");
    case channel::RefusalReason::WrongKey: return Words::tr("made for another key: meant for somebody else, or an impostor");
    case channel::RefusalReason::ReplayedHandshake: return Words::tr("a replayed handshake");
    case channel::RefusalReason::NoCommonSuite: return Words::tr("no cipher suite that both ends allow");
    case channel::RefusalReason::OfferTampered: return Words::tr("the offer of suites was tampered with");
    case channel::RefusalReason::Version: return Words::tr("another version of the protocol");
    case channel::RefusalReason::CounterBehind:
        return Words::tr("the file of counters was lost or put back; going on from the number that the other end remembers");
    case channel::RefusalReason::CountersUsedUp:
        return Words::tr("all handshake counters of this station's key are used; make a new key");
    case channel::RefusalReason::Flood: return Words::tr("too many of them; only senders that prove their address get through");
    }
    return {};
}

QString linkPhaseText(engine::LinkPhase phase)
{
    switch (phase) {
    case engine::LinkPhase::Closed: return Words::tr("closed");
    case engine::LinkPhase::Opening: return Words::tr("opening");
    case engine::LinkPhase::Listening: return Words::tr("listening");
    case engine::LinkPhase::Connected: return Words::tr("connected");
    case engine::LinkPhase::Waiting: return Words::tr("waiting to try again");
    case engine::LinkPhase::Finished: return Words::tr("finished");
    case engine::LinkPhase::Failed: return Words::tr("failed");
    }
    return {};
}

QString commandOutcomeText(const vehicle::CommandResult &result)
{
    const QString reason = fromStd(result.reason);
    switch (result.outcome) {
    case vehicle::CommandOutcome::Accepted: return Words::tr("accepted");
    case vehicle::CommandOutcome::Refused:
        return reason.isEmpty() ? Words::tr("refused") : Words::tr("refused: %1").arg(reason);
    case vehicle::CommandOutcome::TimedOut: return reason.isEmpty() ? Words::tr("no answer") : reason;
    }
    return {};
}

QString commandText(const vehicle::VehicleCommand &command)
{
    return std::visit(
        Overloaded{[](const vehicle::Arm &) { return Words::tr("Arm"); },
                   [](const vehicle::Disarm &) { return Words::tr("Disarm"); },
                   [](const vehicle::TakeOff &c) { return Words::tr("Take off to %1 m").arg(number(c.altitude, 0)); },
                   [](const vehicle::Land &) { return Words::tr("Land"); },
                   [](const vehicle::ReturnToLaunch &) { return Words::tr("Return to launch"); },
                   [](const vehicle::SetMode &c) { return Words::tr("Mode %1").arg(fromStd(c.mode)); },
                   [](const vehicle::GoTo &) { return Words::tr("Fly to the point"); },
                   [](const vehicle::ChangeSpeed &c) { return Words::tr("Speed %1 m/s").arg(number(c.metresPerSecond, 1)); },
                   [](const vehicle::SetCurrentMissionItem &c) { return Words::tr("Mission item %1").arg(c.index); },
                   [](const vehicle::StartMission &) { return Words::tr("Start the mission"); },
                   [](const vehicle::Reboot &) { return Words::tr("Restart the autopilot"); },
                   [](const vehicle::RawCommand &c) { return Words::tr("Command %1").arg(c.command); }},
        command);
}

} // namespace skyseal::ui
