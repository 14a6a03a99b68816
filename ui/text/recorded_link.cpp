#include "ui/text/recorded_link.h"

#include "core/engine/station/snapshot.h"
#include "core/log/log_index.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStringList>

#include <algorithm>

namespace skyseal::ui {

namespace {

struct RecordedLinkText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::RecordedLink)
};

} // namespace

QStringList RecordedLink::variants() const
{
    if (!isNoted)
        return {RecordedLinkText::tr("Replay · protection not recorded"), RecordedLinkText::tr("Replay")};
    if (isPlain())
        return {RecordedLinkText::tr("Replay · was not sealed"), RecordedLinkText::tr("Was not sealed")};
    const QString dot = QStringLiteral(" · "), sealed = RecordedLinkText::tr("Was sealed");
    QStringList out;
    if (!suiteName.isEmpty())
        out << sealed + dot + suiteName + dot + peers << sealed + dot + suiteName;
    return out << sealed;
}

QString RecordedLink::sentence() const
{
    if (!isNoted)
        return RecordedLinkText::tr("How the link was protected is not noted beside the recording.");
    if (isPlain())
        return RecordedLinkText::tr("The link was plain MAVLink, not sealed.");
    return suiteName.isEmpty() ? RecordedLinkText::tr("The link was sealed, with one of %1.").arg(peers)
                               : RecordedLinkText::tr("The link was sealed by %1, with %2.").arg(suiteName, peers);
}

std::optional<RecordedLink> recordedLinkOf(const ViewState &view, const engine::VehicleSnapshot &vehicle)
{
    if (!view.snapshot || !engine::isRecorded(*view.snapshot, vehicle))
        return std::nullopt;
    RecordedLink out;
    const auto &replay = view.snapshot->replay;
    if (!replay || !replay->index)
        return out;
    const auto events = tlog::protectionAt(*replay->index, replay->position, vehicle.state.systemId);
    if (events.empty())
        return out;
    out.isNoted = true;
    const std::string &suite = events.front().suite;
    QStringList peers;
    for (const tlog::LinkEvent &event : events)
        peers << fromStd(event.peer);
    out.peers = peers.join(QStringLiteral(", "));
    if (std::ranges::any_of(events, [&](const tlog::LinkEvent &event) { return event.suite != suite; }))
        return out;
    out.suite = crypto::suiteFromName(suite);
    out.suiteName = suiteNameOf(suite);
    return out;
}

} // namespace skyseal::ui
