// skyseal-cli gateway: serves other ground stations and programs through the sealed links of this station.
#include "app/cli/commands.h"
#include "app/cli/control/control_url.h"
#include "app/cli/metrics_server.h"
#include "app/cli/mqtt_options.h"
#include "app/cli/station_options.h"
#include "app/cli/station_run.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/own_ports.h"

namespace skyseal::app {

namespace {

void declareGatewayOptions(Options &options)
{
    options.addLink("link", "Link to vehicles or their agents, e.g. udpin:0.0.0.0:14550. May be given several times.", isLive);
    declareKeys(options);
    options.addValue(
        "serve", "URL[,OPTION...]",
        "Serve ground stations and programs on this link: udpout:127.0.0.1:14550 (a station that listens), udpin:PORT, "
        "tcpin:PORT. May be given several times. Options: write=none|all|mission,param,command,ftp,rc (default none: read-only "
        "requests and, without a client that may write, message rates of 1 to 10 Hz are forwarded, commands denied); "
        "from=ADDRESS/PREFIX (links that listen); sysid=ID,...; name=NAME. Only heartbeats of clients that may write are "
        "forwarded to the vehicle: they arm its failsafe for a lost ground station, which acts when they stop. The gateway "
        "itself sends none.");
    declareControl(options, "Local socket for skyseal-cli status, switch and revoke.");
    options.addValue("metrics", "HOST:PORT", "Serve the counters to Prometheus at http://HOST:PORT/metrics (OpenMetrics).");
    declareMqtt(options);
    declareRecording(options);
    declareDuration(options);
    options.addConfig();
    options.addFlag("json", "One JSON object per line on stdout.");
}

std::vector<engine::ServeConfig> readServed(Options &options)
{
    options.required("serve");
    std::vector<engine::ServeConfig> out;
    for (const std::string &text : options.texts("serve")) {
        auto config = engine::ServeConfig::parse(text);
        if (config)
            out.push_back(std::move(*config));
        else
            options.fail("--serve '" + text + "': " + config.error().text());
    }
    return out;
}

std::vector<OptionLink> linksOf(const StationRun &run)
{
    std::vector<OptionLink> out;
    for (const link::LinkUrl &url : run.links)
        out.push_back({"link", url});
    for (const engine::ServeConfig &config : run.plan.serve)
        out.push_back({"serve", config.url});
    return out;
}

/// Clients are not authenticated: every program that reaches the port is served.
void warnOfOpenLinks(const QString &program, const std::vector<engine::ServeConfig> &served)
{
    for (const engine::ServeConfig &config : served) {
        if (!config.isOpenToOthers())
            continue;
        std::string warning = config.name + ": not sealed, and open to other machines: ";
        warning += config.url.isListening() && !config.from ? "anyone who reaches this address can " : "others can ";
        warning += "see the vehicles";
        if (config.write.any())
            warning += " and send (write=" + config.write.toText() + ")";
        complain(program, warning, mavlink::MAV_SEVERITY_WARNING);
    }
}

} // namespace

int runGateway(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli gateway");
    Options options(name, QStringLiteral("Serves other ground stations and programs through sealed links."));
    declareGatewayOptions(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    options.required("link");
    StationRun run{.program = name, .links = options.urls("link"), .json = options.has("json")};
    run.config.secure = engine::SecureMode::Required;
    run.config.ownHeartbeat = false;
    run.config.componentId = mavlink::MAV_COMP_ID_UDP_BRIDGE; // so that no client mistakes the answers for its own
    run.config.snapshotsPerSecond = 4;
    readKeys(options, run.config);
    readRecording(options, run.config);
    run.plan.serve = readServed(options);
    refuseOwnPorts(options, "the gateway", linksOf(run));
    if (options.has("control"))
        run.control = readControl(options);
    if (options.has("metrics")) {
        run.metrics = options.required("metrics");
        if (!MetricsServer::isAddress(run.metrics))
            options.fail("--metrics '" + run.metrics + "': ADDRESS:PORT is expected, such as 127.0.0.1:9464");
    }
    run.broker = readMqtt(options);
    run.plan.duration = readDuration(options);
    if (const auto status = options.finish())
        return *status;
    warnOfOpenLinks(name, run.plan.serve);
    if (MetricsServer::isOpenToOthers(run.metrics))
        complain(name, run.metrics + ": open to other machines: anyone who reaches this address can read the counters",
                 mavlink::MAV_SEVERITY_WARNING);
    if (run.broker)
        warnOfOpenBroker(name, run.broker->config);
    return runStation(std::move(run));
}

} // namespace skyseal::app
