#include "ui/window/problem_reports.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "core/engine/text/event_text.h"
#include "ui/links/problem_banner.h"
#include "ui/security/allow_plain.h"
#include "ui/text/vehicle_text.h"

#include <QtWidgets/QWidget>

namespace skyseal::ui {

ProblemReports::ProblemReports(StationInterface &station, ProblemBanner &banner, QWidget &window)
    : QObject(&window), m_station(station), m_banner(banner), m_window(window)
{}

void ProblemReports::report(const QString &problem, const QString &remedy, std::function<void()> act)
{
    m_banner.notify(problem, remedy, std::move(act));
}

void ProblemReports::handleEvent(const engine::Event &event, const ViewState &view)
{
    if (const auto *changed = std::get_if<engine::LinkChanged>(&event); changed && changed->link.addressInUse)
        reportPortInUse(changed->link);
    // Without a vehicle and a session, the empty state over the map shows the same.
    if (const auto *refused = std::get_if<engine::PlaintextRefused>(&event);
        refused && !refused->mayBe.empty() && (view.vehicle || view.session)) {
        const engine::PendingVehicle pending{refused->systemId, refused->remoteAddress, refused->mayBe};
        report(engine::eventText(event, {}).line(), allowPlainText(pending),
               [this, pending] { askAllowPlain(m_station, pending, &m_window); });
    }
}

void ProblemReports::reportPortInUse(const engine::LinkSnapshot &link)
{
    const QString url = fromStd(link.url);
    const qsizetype colon = url.lastIndexOf(QLatin1Char(':'));
    bool ok = false;
    const int port = url.mid(colon + 1).toInt(&ok);
    if (!ok || port <= 0 || port >= 65535) {
        report(tr("%1 is in use by another program: %2").arg(url, reasonText(link.problem)));
        return;
    }
    const QString other = url.left(colon + 1) + QString::number(port + 1);
    QString problem = reasonText(link.problem);
    if (!problem.isEmpty())
        problem[0] = problem[0].toUpper();
    report(problem, tr("Listen on %1 instead").arg(port + 1), [this, other, id = link.id] {
        m_station.removeLink(id);
        Q_EMIT linkRequested(other);
    });
}

} // namespace skyseal::ui

#include "moc_problem_reports.cpp"
