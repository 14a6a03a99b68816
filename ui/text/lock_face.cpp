#include "ui/text/lock_face.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/event_text.h"
#include "core/engine/text/state_text.h"
#include "ui/refusal_meter.h"
#include "ui/text/link_ended.h"
#include "ui/text/one_way.h"
#include "ui/text/recorded_link.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

using engine::Security;

namespace {

/// The translation context of the functions below.
struct LockFaceText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::LockFace)
};

QString peerName(const engine::SessionSnapshot &session)
{
    return session.info.peerName.empty() ? LockFaceText::tr("peer") : fromStd(session.info.peerName);
}

QString sealedToolTip(const engine::SessionSnapshot &session)
{
    return LockFaceText::tr("Sealed with %1 for %2\nPeer %3 at %4\nFingerprint %5")
        .arg(suiteName(session.info.suite), durationText(session.age), peerName(session), fromStd(session.remoteAddress),
             fromStd(session.fingerprint));
}

LockFace unsealedFace(const QStringList &variants, const QString &toolTip)
{
    LockFace face;
    face.security = Security::Plain;
    face.icon = QStringLiteral("lock-open");
    face.variants = variants;
    face.toolTip = toolTip;
    face.suite = crypto::SuiteId::None;
    return face;
}

LockFace pendingApprovalFace(const engine::PendingVehicle &pending)
{
    return unsealedFace(
        {LockFaceText::tr("Not sealed · vehicle %1 needs approval").arg(pending.systemId),
         LockFaceText::tr("Not sealed · needs approval"), LockFaceText::tr("Not sealed")},
        LockFaceText::tr("Vehicle %1 at %2 may be impersonating %3, which has not been heard yet. Its telemetry is not "
                         "shown and nothing is sent to it until you allow it: Security → Allow plain MAVLink.")
            .arg(pending.systemId)
            .arg(fromStd(pending.remoteAddress), engine::anyOfNames(pending.mayBe)));
}

/// Without alarm, whatever it was: nothing of it is live.
LockFace recordedFace(const RecordedLink &link, const QString &toolTip)
{
    LockFace face;
    face.security = Security::Nothing;
    face.icon = !link.isNoted ? QStringLiteral("lock-none")
        : link.isPlain()      ? QStringLiteral("lock-open")
                              : QStringLiteral("lock-closed");
    face.variants = link.variants();
    face.toolTip = toolTip;
    return face;
}

LockFace plainFace(const ViewState &view)
{
    if (const auto oneWay = oneWayOf(view))
        return unsealedFace({oneWay->title, LockFaceText::tr("Not sealed")}, oneWay->advice);
    if (view.plainRun)
        return unsealedFace(
            {LockFaceText::tr("Not sealed · sweep running"), LockFaceText::tr("Not sealed")},
            LockFaceText::tr("The sweep is measuring plain MAVLink, with your consent: anyone on the path can read and change "
                             "the traffic. The sweep seals the link again afterwards."));
    return unsealedFace(
        {LockFaceText::tr("Not sealed · plain MAVLink"), LockFaceText::tr("Not sealed")},
        LockFaceText::tr("Anyone on the path can read and change the traffic. Start skyseal-air beside the vehicle to "
                         "seal the link."));
}

} // namespace

Security securityOf(const ViewState &view)
{
    if (!view.session)
        return view.vehicle
            ? view.vehicle->session || engine::isRecorded(*view.snapshot, *view.vehicle) ? Security::Nothing : Security::Plain
            : view.snapshot ? view.snapshot->security
                            : Security::Nothing;
    if (view.refusedLastMinute > 0)
        return Security::UnderAttack; // by frames outside the session
    if (engine::isAttacked(*view.session))
        return view.snapshot->sessions.size() == 1 ? view.snapshot->security : Security::UnderAttack;
    return view.session->info.pending ? Security::Switching : Security::Sealed;
}

LockFace lockFaceOf(const ViewState &view)
{
    LockFace face;
    face.security = securityOf(view);
    if (!view.session) {
        if (view.pendingApproval)
            return pendingApprovalFace(*view.pendingApproval);
        if (const engine::UnansweringAgent *agent = unansweringOf(view)) {
            face.icon = QStringLiteral("lock-none");
            face.lost = true;
            face.variants = {LockFaceText::tr("%1 does not answer").arg(fromStd(agent->peerName)),
                             LockFaceText::tr("No answer")};
            face.toolTip = engine::unansweringText(*agent);
            return face;
        }
        if (const auto ended = linkEndedOf(view)) {
            face.icon = QStringLiteral("lock-none");
            face.lost = true;
            face.variants = {ended->title, ended->revoked ? LockFaceText::tr("Revoked") : LockFaceText::tr("No session")};
            face.toolTip = ended->advice;
            return face;
        }
        if (const auto recorded = view.vehicle ? recordedLinkOf(view, *view.vehicle) : std::nullopt) {
            const auto oneWay = oneWayOf(view);
            return recordedFace(*recorded, oneWay ? oneWay->advice : recorded->sentence());
        }
        if (face.security == Security::Nothing) {
            face.icon = QStringLiteral("lock-none");
            face.variants = {LockFaceText::tr("Nothing sealed"), LockFaceText::tr("Nothing sealed")};
            face.toolTip = view.key.isOpening ? LockFaceText::tr("No sealed links yet: this station's key is being opened")
                : view.key.problem.isEmpty()  ? LockFaceText::tr("No vehicle and no session yet")
                                              : LockFaceText::tr("No sealed links: this station cannot use its key")
                                                   .append(QLatin1Char('\n'))
                                                   .append(view.key.problem);
            return face;
        }
        return plainFace(view);
    }
    const auto &session = *view.session;
    const QString suite = suiteName(session.info.suite);
    const QString peer = peerName(session) + QStringLiteral(" ✓");
    const QString dot = QStringLiteral(" · ");
    face.suite = session.info.suite;
    face.toolTip = sealedToolTip(session);
    switch (face.security) {
    case Security::Switching: {
        face.icon = QStringLiteral("lock-switching");
        if (session.info.pending.value_or(session.info.suite) == session.info.suite) {
            face.variants = {suite + dot + LockFaceText::tr("changing keys…")};
            face.toolTip += QLatin1Char('\n') + LockFaceText::tr("New keys are being negotiated");
            break;
        }
        const QString to = suiteName(*session.info.pending);
        face.variants = {suite + QStringLiteral(" → ") + to + dot + LockFaceText::tr("switching…"),
                         suite + dot + LockFaceText::tr("switching…")};
        face.toolTip += QLatin1Char('\n') + LockFaceText::tr("Switching to %1").arg(to);
        break;
    }
    case Security::UnderAttack: {
        const std::uint64_t records = refusedFrames(session, view.refusedLastMinute > 0).all();
        const std::uint64_t outside = view.refusedLastMinute > 0 ? view.refused : 0;
        const QString brief = LockFaceText::tr("%1 refused").arg(grouped(records + outside));
        face.icon = QStringLiteral("lock-alert");
        face.variants = {suite + dot + peer + dot + LockFaceText::tr("under attack, %1").arg(brief), suite + dot + brief,
                         brief};
        if (records > 0)
            face.toolTip += QLatin1Char('\n')
                + LockFaceText::tr(
                      "Under attack: %1 forged or replayed records since the link came up. All of them were refused.")
                      .arg(grouped(records));
        if (outside > 0)
            face.toolTip += QLatin1Char('\n')
                + LockFaceText::tr(
                      "Under attack: %1 spoofed frames of this vehicle since the link came up. All of them were refused.")
                      .arg(grouped(outside));
        break;
    }
    default: {
        const QString epoch = LockFaceText::tr("epoch %1").arg(static_cast<std::uint32_t>(session.info.epoch));
        face.icon = QStringLiteral("lock-closed");
        face.variants = {suite + dot + peer + dot + epoch, suite + dot + peer, suite};
        break;
    }
    }
    return face;
}

} // namespace skyseal::ui
