#include "ui/text/link_ended.h"

#include "core/engine/station/snapshot.h"
#include "core/engine/text/state_text.h"
#include "ui/text/units.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

#include <algorithm>

namespace skyseal::ui {

using channel::DownReason;

namespace {

struct LinkEndedText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::LinkEnded)
};

} // namespace

std::optional<LinkEnded> linkEndedOf(const ViewState &view)
{
    if (view.session || !view.vehicle || !view.vehicle->session)
        return std::nullopt;
    const engine::EndedSession ended = view.vehicle->ended.value_or(engine::EndedSession{});
    const QString name = ended.peerName.empty() ? LinkEndedText::tr("the agent") : fromStd(ended.peerName);
    const QString ago = durationText(ended.age);
    const QString waiting = QLatin1Char(' ')
        + LinkEndedText::tr("Waiting: the session is re-established automatically when the agent is heard again. The last "
                            "received values are shown. Plain MAVLink with the vehicle's system ID is still refused.");
    if (view.inSweep && ended.reason == DownReason::Closed)
        return LinkEnded{LinkEndedText::tr("New session · %1").arg(name),
                         LinkEndedText::tr("The sweep changes the protection of the link, which needs a new handshake.")};
    switch (ended.reason) {
    case DownReason::Revoked:
        return LinkEnded{
            LinkEndedText::tr("Revoked · %1").arg(name),
            LinkEndedText::tr("%1 is no longer a known peer: its session ended %2 ago and cannot be re-established. "
                              "The last received values are shown. Pair it again to continue.")
                .arg(name, ago),
            true};
    case DownReason::TimedOut:
        return LinkEnded{LinkEndedText::tr("Session lost · %1").arg(name),
                         LinkEndedText::tr("%1 was silent for too long; the session ended %2 ago.").arg(name, ago) + waiting};
    case DownReason::PeerRestarted:
    case DownReason::PeerClosed:
    case DownReason::Exhausted:
    case DownReason::Cloned:
    case DownReason::Closed: break;
    }
    return LinkEnded{
        LinkEndedText::tr("Session ended · %1").arg(name),
        LinkEndedText::tr("The session with %1 ended %2 ago: %3.").arg(name, ago, engine::downReasonText(ended.reason))
            + waiting};
}

const engine::UnansweringAgent *unansweringOf(const ViewState &view)
{
    if (view.session || !view.snapshot)
        return nullptr;
    const auto &agents = view.snapshot->unanswering;
    if (!view.vehicle)
        return agents.empty() || !view.snapshot->sessions.empty() ? nullptr : &agents.front();
    if (!view.vehicle->ended)
        return nullptr;
    const auto found = std::ranges::find(agents, view.vehicle->ended->peerName, &engine::UnansweringAgent::peerName);
    return found == agents.end() ? nullptr : &*found;
}

const engine::UnknownAgent *unknownAgentOf(const ViewState &view)
{
    if (view.session || view.vehicle || view.pendingApproval || !view.snapshot || unansweringOf(view))
        return nullptr;
    const auto &agents = view.snapshot->unknownAgents;
    return agents.empty() ? nullptr : &agents.front();
}

} // namespace skyseal::ui
