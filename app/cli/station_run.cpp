#include "app/cli/station_run.h"

#include "app/cli/control/control_server.h"
#include "app/cli/json_report.h"
#include "app/cli/metrics_server.h"
#include "app/cli/people_report.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/peers_watch.h"
#include "app/common/process.h"
#include "app/common/service_manager.h"
#include "core/crypto/mavsec_cipher.h"

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

} // namespace

int runStation(StationRun run)
{
    auto station = engine::Station::create(run.config);
    if (!station) {
        complain(run.program, station.error().text());
        return kCannotOpen;
    }
    ControlServer control(**station, run.config.keys.peers);
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
    const std::unique_ptr<engine::RunListener> report = makeReport(run);
    engine::HeadlessRun headless(**station, *report, std::move(run.plan), run.links);
    std::optional<PeersWatch> watch;
    if (run.config.secure == engine::SecureMode::Required) {
        watch.emplace(run.config.keys.peers, [&](std::vector<channel::Peer> peers) { (*station)->setPeers(std::move(peers)); });
        tellPeers(*watch, run.json);
    }
    ServiceManager manager;
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, &headless, [&manager] { manager.stopping(); });
    QObject::connect(&signals, &StopSignals::stopRequested, &headless, &engine::HeadlessRun::stop);
    QObject::connect(&headless, &engine::HeadlessRun::finished, qApp,
                     [&run](engine::RunOutcome outcome, const std::string &problem) {
                         if (outcome != engine::RunOutcome::Reached)
                             complain(run.program, problem);
                         QCoreApplication::exit(exitStatus(outcome));
                     });
    const auto start = [&] {
        headless.start();
        manager.ready();
    };
    QMetaObject::invokeMethod(&headless, start, Qt::QueuedConnection);
    return QCoreApplication::exec();
}

} // namespace skyseal::app
