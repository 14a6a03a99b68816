#include "core/engine/text/state_text.h"

#include "core/engine/text/qt_text.h"
#include "core/mavlink/enums.h"

#include <QtCore/QCoreApplication>

namespace skyseal::engine {

namespace {

/// The translations' context of this file.
struct StateText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::engine::StateText)
};

} // namespace

QString suiteText(crypto::SuiteId suite)
{
    if (suite == crypto::SuiteId::None)
        return StateText::tr("plain, not sealed");
    const crypto::SuiteInfo &info = crypto::suiteInfo(suite);
    const QString name = fromStd(info.displayName);
    return info.research ? StateText::tr("%1 (insecure)").arg(name) : name;
}

QString vehicleTypeText(std::uint8_t type)
{
    switch (type) {
    case mavlink::MAV_TYPE_FIXED_WING: return StateText::tr("plane");
    case mavlink::MAV_TYPE_QUADROTOR: return StateText::tr("quadrotor");
    case mavlink::MAV_TYPE_COAXIAL: return StateText::tr("coaxial helicopter");
    case mavlink::MAV_TYPE_HELICOPTER: return StateText::tr("helicopter");
    case mavlink::MAV_TYPE_ANTENNA_TRACKER: return StateText::tr("antenna tracker");
    case mavlink::MAV_TYPE_AIRSHIP: return StateText::tr("airship");
    case mavlink::MAV_TYPE_GROUND_ROVER: return StateText::tr("rover");
    case mavlink::MAV_TYPE_SURFACE_BOAT: return StateText::tr("boat");
    case mavlink::MAV_TYPE_SUBMARINE: return StateText::tr("submarine");
    case mavlink::MAV_TYPE_HEXAROTOR: return StateText::tr("hexarotor");
    case mavlink::MAV_TYPE_OCTOROTOR: return StateText::tr("octorotor");
    case mavlink::MAV_TYPE_TRICOPTER: return StateText::tr("tricopter");
    case mavlink::MAV_TYPE_VTOL_TAILSITTER_DUOROTOR:
    case mavlink::MAV_TYPE_VTOL_TAILSITTER_QUADROTOR:
    case mavlink::MAV_TYPE_VTOL_TILTROTOR:
    case mavlink::MAV_TYPE_VTOL_FIXEDROTOR:
    case mavlink::MAV_TYPE_VTOL_TAILSITTER:
    case mavlink::MAV_TYPE_VTOL_TILTWING:
    case mavlink::MAV_TYPE_VTOL_RESERVED5: return StateText::tr("VTOL");
    default: return StateText::tr("vehicle");
    }
}

QString linkPhaseText(LinkPhase phase)
{
    switch (phase) {
    case LinkPhase::Closed: return StateText::tr("closed");
    case LinkPhase::Opening: return StateText::tr("opening");
    case LinkPhase::Listening: return StateText::tr("listening");
    case LinkPhase::Connected: return StateText::tr("connected");
    case LinkPhase::Waiting: return StateText::tr("waiting to retry");
    case LinkPhase::Finished: return StateText::tr("finished");
    case LinkPhase::Failed: return StateText::tr("failed");
    }
    return {};
}

QString downReasonText(channel::DownReason reason)
{
    switch (reason) {
    case channel::DownReason::PeerRestarted: return StateText::tr("the other end restarted");
    case channel::DownReason::PeerClosed: return StateText::tr("closed by the other end");
    case channel::DownReason::TimedOut: return StateText::tr("silent for too long");
    case channel::DownReason::Exhausted: return StateText::tr("its keys were used up");
    case channel::DownReason::Revoked: return StateText::tr("its key is no longer among the known peers");
    case channel::DownReason::Closed: return StateText::tr("closed here");
    case channel::DownReason::Cloned:
        return StateText::tr("its keys are in use twice, as if the machine at one end had been copied");
    }
    return {};
}

QString switchFailureText(channel::SwitchFailure failure)
{
    switch (failure) {
    case channel::SwitchFailure::None: return StateText::tr("switched");
    case channel::SwitchFailure::NotAllowedHere: return StateText::tr("not allowed at this end");
    case channel::SwitchFailure::NotAllowedByPeer: return StateText::tr("not allowed by the other end");
    case channel::SwitchFailure::NotConfirmed: return StateText::tr("the other end did not confirm in time");
    case channel::SwitchFailure::Superseded: return StateText::tr("the other end's request took precedence");
    case channel::SwitchFailure::SessionEnded: return StateText::tr("the session ended");
    }
    return {};
}

QString refusalText(channel::RefusalReason reason)
{
    switch (reason) {
    case channel::RefusalReason::UnknownPeer: return StateText::tr("its key is not among the known peers");
    case channel::RefusalReason::WrongKey:
        return StateText::tr("it was made for a different key: a wrong destination, or an impersonation");
    case channel::RefusalReason::ReplayedHandshake:
        return StateText::tr("its counter was used before: a replay, or the station lost its counter file");
    case channel::RefusalReason::NoCommonSuite: return StateText::tr("there is no cipher suite that both ends allow");
    case channel::RefusalReason::OfferTampered: return StateText::tr("its offer of suites was modified in transit");
    case channel::RefusalReason::Version: return StateText::tr("it uses another version of the protocol");
    case channel::RefusalReason::CounterBehind:
        return StateText::tr(
            "this end's counter file was lost or restored; it continues from the number that the other end remembers");
    case channel::RefusalReason::CountersUsedUp:
        return StateText::tr("all handshake counters of this station's key are used up; it needs a new key");
    case channel::RefusalReason::Flood:
        return StateText::tr("there are too many handshakes; only senders that prove their address are answered");
    }
    return {};
}

QString switchTimeText(Duration took)
{
    const double ms = seconds(took) * 1000;
    return decimalText(ms, ms < 9.95 ? 1 : 0) + QStringLiteral(" ms");
}

QString anyOfNames(std::string_view names)
{
    const QString all = fromStd(names), comma = QStringLiteral(", ");
    const qsizetype last = all.lastIndexOf(comma);
    return last < 0 ? all : StateText::tr("%1 or %2").arg(all.left(last), all.mid(last + comma.size()));
}

} // namespace skyseal::engine
