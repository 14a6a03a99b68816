#include "app/cli/station_run.h"

#include "app/cli/broker_report.h"
#include "app/cli/control/control_socket.h"
#include "app/cli/json_report.h"
#include "app/cli/metrics_server.h"
#include "app/cli/people_report.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/peers_watch.h"
#include "app/common/process.h"
#include "app/common/service_manager.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/engine/headless/fleet_feed.h"
#include "core/engine/station/snapshot.h"
#include "core/link/steady_now.h"
#include "core/mqtt/publisher.h"

#include <QtCore/QCoreApplication>

namespace skyseal::app {

namespace {

int exitStatus(engine::RunOutcome outcome)
{
    switch (outcome) {
    case engine::RunOutcome::Reached: return kDone;
    case engine::RunOutcome::CannotOpen: return kCannotOpen;
    default: return kNotReached;
    }
}

std::unique_ptr<engine::RunListener> makeReport(const StationRun &run)
{
    if (run.json)
        return std::make_unique<JsonReport>();
    return std::make_unique<PeopleReport>(run.config.record ? run.config.recordFolder : std::string());
}

/// Tells the service manager that the station is ready when all its links were opened without an error that ends the run, and
/// that it is alive as long as its I/O thread makes snapshots.
class ServiceReport
{
public:
    ServiceReport(const engine::Station &station, const engine::HeadlessRun &run, std::size_t links)
    {
        QObject::connect(&station, &engine::Station::snapshotReady, &run,
                         [this, &run, links](const std::shared_ptr<const engine::Snapshot> &snapshot) {
                             m_alive = true;
                             if (m_ready || run.isStopping() || snapshot->links.size() + snapshot->served.size() < links)
                                 return;
                             m_ready = true;
                             m_manager.ready();
                         });
        m_manager.setAliveCheck([this] { return std::exchange(m_alive, false); });
    }
    void stopping() { m_manager.stopping(); }

private:
    ServiceManager m_manager;
    bool m_ready = false;
    bool m_alive = false; ///< a snapshot came since the watchdog was told
};

Result<std::shared_ptr<engine::FleetFeed>, InputError> makeFeed(const BrokerPlan &plan)
{
    auto publisher = mqtt::Publisher::create(plan.config);
    if (!publisher)
        return tl::unexpected(publisher.error());
    return std::make_shared<engine::FleetFeed>(std::move(*publisher), plan.raw);
}

void feedFrom(engine::Station &station, const std::shared_ptr<engine::FleetFeed> &feed, BrokerReport &report)
{
    station.setFeed(feed);
    QObject::connect(&station, &engine::Station::snapshotReady, &station,
                     [feed, &report](const std::shared_ptr<const engine::Snapshot> &snapshot) {
                         feed->take(*snapshot, wallNow());
                         report.take(*snapshot);
                     });
    QObject::connect(&station, &engine::Station::eventOccurred, &station,
                     [feed](const engine::Event &event) { feed->handleEvent(event); });
}

} // namespace

int runStation(StationRun run)
{
    std::shared_ptr<engine::FleetFeed> feed; // outlives the station: its end waits for the broker
    if (run.broker) {
        auto made = makeFeed(*run.broker);
        if (!made) {
            complain(run.program, made.error().text());
            return kCannotOpen;
        }
        feed = std::move(*made);
    }
    BrokerReport brokerReport(run.broker ? run.broker->config.broker.toText() : std::string(), run.json);
    auto station = engine::Station::create(run.config);
    if (!station) {
        complain(run.program, station.error().text());
        return kCannotOpen;
    }
    ControlSocket control(**station, run.config.keys.peers);
    if (!run.control.isEmpty()) {
        if (const auto listening = control.listen(run.control); !listening) {
            complain(run.program, listening.error().text());
            return kCannotOpen;
        }
    }
    MetricsServer metrics(**station);
    if (!run.metrics.empty()) {
        if (const auto listening = metrics.listen(run.metrics); !listening) {
            complain(run.program, listening.error().text());
            return kCannotOpen;
        }
    }
    if (feed)
        feedFrom(**station, feed, brokerReport);
    const std::unique_ptr<engine::RunListener> report = run.report ? std::move(run.report) : makeReport(run);
    const std::size_t links = run.links.size() + run.plan.serve.size();
    engine::HeadlessRun headless(**station, *report, std::move(run.plan), run.links);
    std::optional<PeersWatch> watch;
    if (run.config.secure == engine::SecureMode::Required) {
        watch.emplace(run.config.keys.peers, [&](std::vector<channel::Peer> peers) { (*station)->setPeers(std::move(peers)); });
        reportPeers(*watch, run.json);
    }
    ServiceReport service(**station, headless, links);
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &headless, [&service] { service.stopping(); });
    QObject::connect(&signals, &StopSignals::stopRequested, &headless, &engine::HeadlessRun::stop);
    QObject::connect(&headless, &engine::HeadlessRun::finished, qApp,
                     [&run](engine::RunOutcome outcome, const std::string &problem) {
                         if (outcome != engine::RunOutcome::Reached)
                             complain(run.program, problem);
                         QCoreApplication::exit(exitStatus(outcome));
                     });
    QMetaObject::invokeMethod(&headless, &engine::HeadlessRun::start, Qt::QueuedConnection);
    return QCoreApplication::exec();
}

} // namespace skyseal::app
