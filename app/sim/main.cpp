// skyseal-sim: simulated vehicles on MAVLink, so that a station can be run and tested without further software.
#include "app/common/exit_status.h"
#include "app/common/mavsec_options.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/process.h"
#include "app/sim/sim_host.h"
#include "core/crypto/init_crypto.h"

#include <QtCore/QCoreApplication>

using namespace skyseal;

namespace {

constexpr int kMostVehicles = 100;

sim::VehicleType typeFrom(app::Options &options)
{
    sim::VehicleType type;
    const std::string kind = options.text("kind"), autopilot = options.text("autopilot");
    if (kind == "plane")
        type.kind = sim::CraftKind::Plane;
    else if (kind == "rover")
        type.kind = sim::CraftKind::Rover;
    else if (kind != "copter")
        options.fail("--kind: '" + kind + "': copter, plane or rover is expected");
    if (autopilot == "px4")
        type.firmware = sim::Firmware::Px4;
    else if (autopilot != "ardupilot")
        options.fail("--autopilot: '" + autopilot + "': ardupilot or px4 is expected");
    if (type.isPx4() && !type.hovers())
        options.fail("--autopilot px4 is simulated for --kind copter only");
    return type;
}

app::SimSettings settingsFrom(app::Options &options)
{
    app::SimSettings settings;
    if (!options.has("link"))
        options.fail("--link is missing");
    settings.links = options.urls("link");
    settings.vehicles = static_cast<int>(options.wholeNumber("vehicles", 1, kMostVehicles));
    settings.systemId = static_cast<int>(options.wholeNumber("sysid", 1, 254));
    if (settings.systemId + settings.vehicles - 1 > 254)
        options.fail("--vehicles: system IDs end at 254");
    settings.seed = options.wholeNumber("seed", 0, UINT64_MAX);
    settings.rate = options.number("rate", 0.1, 100);
    settings.type = typeFrom(options);
    settings.trustedLink = options.wholeNumber("trusted-link", 0, settings.links.size());
    settings.saturate = options.has("saturate");
    settings.perSecond = static_cast<std::uint32_t>(options.wholeNumber("pps", 0, 1'000'000));
    if (settings.saturate && settings.perSecond > 0)
        options.fail("--pps: not with --saturate");
    settings.json = options.has("json");
    const std::string framing = options.text("framing");
    if (framing != "plain" && framing != "mavsec2019")
        options.fail("--framing '" + framing + "': plain or mavsec2019 is expected");
    settings.readsStdin = options.has("stdin");
    if (settings.readsStdin && framing != "mavsec2019")
        options.fail("--stdin: only with --framing mavsec2019");
    if (settings.readsStdin && options.has("nonce"))
        options.fail("--nonce: not with --stdin, whose ciphers have nonces of different lengths");
    options.arguments(0, 0);
    return settings;
}

} // namespace

int main(int argc, char **argv)
{
    if (!crypto::initCrypto()) {
        app::remark("skyseal-sim: the system provides no randomness");
        return app::kCannotOpen;
    }
    QCoreApplication application(argc, argv);
    app::Options options(QStringLiteral("skyseal-sim"),
                         QStringLiteral("Simulated vehicles that behave like those of ArduPilot or PX4 on MAVLink."));
    options.addLink("link", "Link to a ground station or agent. May be given several times.", app::isLive);
    options.addValue("kind", "KIND", "Kind of vehicle: copter, plane or rover.", "copter");
    options.addValue("autopilot", "NAME", "Firmware to behave like: ardupilot or px4 (copter only).", "ardupilot");
    options.addValue("vehicles", "N", "Number of vehicles, which share the links.", "1");
    options.addValue("sysid", "N", "System ID of the first vehicle.", "1");
    options.addValue("seed", "N", "Seed of wind and noise, to repeat a flight.", "1");
    options.addValue("rate", "FACTOR", "Fly this many times as fast as real time; heartbeats and streams keep their rates.",
                     "1");
    options.addValue(
        "trusted-link", "N",
        "While MAVLink signing is on, accept unsigned messages on the Nth link, as an autopilot does on its USB port; "
        "0 = on no link.",
        "0");
    options.addFlag("saturate", "Let the first vehicle send telemetry as fast as the station answers, to load the link.");
    options.addValue(
        "pps", "N",
        "Let the first vehicle send N telemetry messages a second in addition to the streams, on a schedule fixed in "
        "advance; --json reports those that were missed.",
        "0");
    options.addResearchValue(
        "framing", "plain|mavsec2019",
        "Framing of messages from the vehicles. mavsec2019: INSECURE, payloads encrypted as by the autopilot of the MAVSec "
        "paper, without authentication; messages to the vehicles stay in clear.",
        "plain");
    app::MavsecOptions::declare(options);
    options.addResearchFlag("stdin",
                            "With mavsec2019: begin in clear, and change the cipher by each line on standard input: plain, "
                            "chacha20 or aes-256-ctr.");
    options.addFlag("json", "One JSON object per line on stdout.");
    if (const auto status = options.parse(application.arguments().mid(1)))
        return *status;
    const app::SimSettings settings = settingsFrom(options);
    const app::MavsecOptions mavsec = app::MavsecOptions::read(options);
    if (const auto status = options.finish())
        return *status;
    auto framing = app::SentFraming::make(mavsec, settings.readsStdin);
    if (!framing) {
        app::complain(QStringLiteral("skyseal-sim"), framing.error().text());
        return app::kCannotOpen;
    }
    if (mavsec.isChosen())
        app::remark("skyseal-sim: INSECURE: anyone can read, change and forge frames that are encrypted as in MAVSec's code");

    app::SimHost host(settings, std::move(*framing));
    app::StopSignals stop;
    QObject::connect(&stop, &app::StopSignals::stopRequested, &application, &QCoreApplication::quit);
    int status = app::kDone;
    QObject::connect(&host, &app::SimHost::failed, &application, [&] {
        status = app::kCannotOpen;
        QMetaObject::invokeMethod(&application, &QCoreApplication::quit, Qt::QueuedConnection);
    });
    host.start();
    QCoreApplication::exec();
    return status;
}
